#include "engine/io/mitsuba_attributes.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "engine/io/ply_source.h"

namespace glint {
namespace {

/// The properties that hold an attribute's one or three numbers; empty: none do.
std::vector<int> propertiesOf(const PlyElement& element, const std::string& name) {
    std::vector<int> found;
    for (int i = 0; i < 3; ++i) {
        const std::string numbered = fmt::format("{}_{}", name, i);
        int at = element.find({numbered});
        if (at < 0 && name == "color") {
            constexpr std::string_view kShort[] = {"r", "g", "b"}, kLong[] = {"red", "green", "blue"};
            at = element.find({kShort[i], kLong[i]});
        }
        if (at < 0 && i == 0) { at = element.find({name}); }
        if (at >= 0 && !element.properties[static_cast<size_t>(at)].isList) { found.push_back(at); }
    }
    if (found.size() == 2) { found.pop_back(); }
    return found;
}

template <class Source>
class AttributeReader {
  public:
    AttributeReader(const PlyHeader& header, Source source, std::string_view name)
        : header_(header),
          source_(std::move(source)),
          isOfFaces_(name.starts_with("face_")),
          name_(name.substr(std::min(name.find('_') + 1, name.size()))) {}

    Result<PlyAttribute> run(const std::string& path) {
        for (const PlyElement& element : header_.elements) {
            const bool isWanted =
                isOfFaces_ ? element.is({"face", "faces"}) : element.is({"vertex", "vertices"});
            const std::vector<int> wanted = isWanted ? propertiesOf(element, name_) : std::vector<int>();
            if (element.properties.empty()) { continue; }
            for (uint64_t i = 0; i < element.count; ++i) {
                if (!readRecord(element, wanted)) { return source_.error(); }
            }
            if (!wanted.empty()) { return std::move(attribute_); }
        }
        return Error{
            fmt::format("has no attribute \"{}\" of its {}", name_, isOfFaces_ ? "faces" : "vertices"),
            {.file = path}};
    }

  private:
    bool readRecord(const PlyElement& element, const std::vector<int>& wanted) {
        if (!source_.beginRecord()) { return false; }
        Vec3 value(0.0f);
        uint32_t corners = 0;
        for (size_t p = 0; p < element.properties.size(); ++p) {
            const PlyProperty& property = element.properties[p];
            const auto slot = std::ranges::find(wanted, static_cast<int>(p)) - wanted.begin();
            double number = 1.0;
            if (property.isList) {
                if (!source_.read(property.countType, "the number of items", &number)) { return false; }
                if (corners == 0) { corners = static_cast<uint32_t>(std::clamp(number, 0.0, 4e9)); }
                for (double i = 0.0; i < number; ++i) {
                    if (!source_.skip(property.type)) { return false; }
                }
            } else if (slot < std::ssize(wanted)) {
                if (!source_.read(property.type, "an attribute", &number)) { return false; }
                const float scale = isFloat(property.type) ? 1.0f : 1.0f / 255.0f;
                value[static_cast<int>(slot)] =
                    std::isfinite(number) ? scale * static_cast<float>(std::clamp(number, 0.0, 1e9)) : 0.0f;
            } else if (!source_.skip(property.type)) {
                return false;
            }
        }
        if (!wanted.empty()) {
            attribute_.values.push_back(wanted.size() == 3 ? value : Vec3(value.x));
            if (isOfFaces_) { attribute_.corners.push_back(corners); }
        }
        return source_.endRecord();
    }

    const PlyHeader& header_;
    Source source_;
    bool isOfFaces_;
    std::string name_;
    PlyAttribute attribute_;
};

}  // namespace

Result<PlyAttribute> readPlyAttribute(const std::string& bytes, const std::string& path,
                                      std::string_view name) {
    const Result<PlyHeader> header = parsePlyHeader(bytes, path);
    if (!header) { return header.error(); }
    if (header->format == PlyFormat::Ascii) {
        return AttributeReader(*header, PlyTextSource(bytes, path, *header), name).run(path);
    }
    const bool isBigEndian = header->format == PlyFormat::BinaryBigEndian;
    return AttributeReader(*header, PlyBinarySource(bytes, path, header->bodyOffset, isBigEndian), name)
        .run(path);
}

}  // namespace glint
