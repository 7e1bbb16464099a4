// What reading vertices and faces of a PLY body shares: lists, what is skipped, and whether an element fits
// into the file. For ply_body.h only.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "engine/io/ply_header.h"
#include "engine/io/remarks.h"

namespace glint {

/// `Source`: ply_source.h.
template <class Source>
class PlyElements {
  public:
    PlyElements(const PlyHeader& header, Source source) : header_(header), source_(std::move(source)) {}

    const Remarks& remarks() const { return source_.remarks(); }

  protected:
    bool headerFailure(const PlyElement& element, std::string message) {
        headerError_ = Error{std::move(message), element.place};
        return false;
    }

    /// Compares what the header promises with what the file still has, before anything is allocated for it.
    bool fits(const PlyElement& element) {
        uint64_t perRecord = 0;
        for (const PlyProperty& property : element.properties) {
            perRecord += Source::leastBytes(property.isList ? property.countType : property.type, 1);
        }
        if (perRecord == 0 || element.count <= source_.bytesLeft() / perRecord) { return true; }
        return headerFailure(
            element,
            fmt::format("{} \"{}\" elements need at least {} bytes, but only {} are left in the file",
                        element.count, element.name, element.count * perRecord, source_.bytesLeft()));
    }

    bool readCount(const PlyProperty& property, uint64_t* count) {
        double number = 0.0;
        if (!source_.read(property.countType, "the number of items", &number)) { return false; }
        if (!(number >= 0.0 && number <= 4294967295.0 && number == std::floor(number)) ||
            Source::leastBytes(property.type, static_cast<uint64_t>(number)) > source_.bytesLeft()) {
            return source_.fail(
                fmt::format("the list \"{}\" has {} items, but only {} bytes are left in the file",
                            property.name, number, source_.bytesLeft()));
        }
        *count = static_cast<uint64_t>(number);
        return true;
    }

    bool skipProperty(const PlyProperty& property) {
        uint64_t count = 1;
        if (property.isList && !readCount(property, &count)) { return false; }
        for (uint64_t i = 0; i < count; ++i) {
            if (!source_.skip(property.type)) { return false; }
        }
        return true;
    }

    bool skipElement(const PlyElement& element) {
        for (uint64_t i = 0; i < element.count && !element.properties.empty(); ++i) {
            if (!source_.beginRecord()) { return false; }
            for (const PlyProperty& property : element.properties) {
                if (!skipProperty(property)) { return false; }
            }
            if (!source_.endRecord()) { return false; }
        }
        return true;
    }

    const PlyHeader& header_;
    Source source_;
    std::optional<Error> headerError_;
};

}  // namespace glint
