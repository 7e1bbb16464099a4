// The body of a PLY file: vertices, faces and strips, once for text and once for bytes (ply_source.h). For
// ply_loader.cpp only.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "engine/io/ply_header.h"
#include "engine/io/ply_mesh.h"
#include "engine/io/remarks.h"

namespace glint {

enum PlySlot : size_t { kX, kY, kZ, kNx, kNy, kNz, kU, kV, kRed, kGreen, kBlue, kPlySlots };

/// Which property of the vertex element holds what; -1: none.
using PlySlots = std::array<int, kPlySlots>;
PlySlots plySlotsOf(const PlyElement& vertex);
const char* nameOf(PlySlot slot);

template <class Source>
class PlyBody {
  public:
    PlyBody(const PlyHeader& header, Source source) : header_(header), source_(std::move(source)) {}

    /// Error: with its place; an element that does not fit into the file.
    Status run() {
        for (const PlyElement& element : header_.elements) {
            if (!fits(element)) { return *headerError_; }
            const bool ok = element.is({"vertex", "vertices"})      ? readVertices(element)
                            : element.is({"face", "faces"})         ? readFaces(element, false)
                            : element.is({"tristrips", "tristrip"}) ? readFaces(element, true)
                                                                    : skipElement(element);
            if (!ok) { return headerError_ ? *headerError_ : source_.error(); }
        }
        return {};
    }

    PlyMesh mesh;
    bool hasWholeColors = false;  ///< colours are stored as integers
    const Remarks& remarks() const { return source_.remarks(); }

  private:
    /// Larger coordinates have squared lengths that overflow float.
    static constexpr double kMaxCoordinate = 1e18;

    /// Which properties of a face hold what; -1: none.
    struct FaceProperties {
        int corners, uvs, texture;
    };

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

    bool readVertices(const PlyElement& element) {
        const PlySlots slots = plySlotsOf(element);
        for (const int slot : slots) {
            if (slot >= 0 && element.properties[static_cast<size_t>(slot)].isList) {
                return headerFailure(element, "a vertex's coordinates and colours cannot be lists");
            }
        }
        if (slots[kX] < 0 || slots[kY] < 0 || slots[kZ] < 0) {
            return headerFailure(element, "expected the properties x, y and z in the element vertex");
        }
        if (element.count > INT32_MAX) {
            return headerFailure(element, fmt::format("expected at most {} vertices", INT32_MAX));
        }
        hasWholeColors =
            slots[kRed] >= 0 && !isFloat(element.properties[static_cast<size_t>(slots[kRed])].type);
        mesh.vertices.positions.reserve(element.count);
        for (uint64_t i = 0; i < element.count; ++i) {
            if (!readVertex(element, slots)) { return false; }
        }
        return true;
    }

    bool readVertex(const PlyElement& element, const PlySlots& slots) {
        std::array<double, kPlySlots> values{};
        if (!source_.beginRecord()) { return false; }
        for (size_t p = 0; p < element.properties.size(); ++p) {
            const PlyProperty& property = element.properties[p];
            size_t slot = 0;
            while (slot < kPlySlots && slots[slot] != static_cast<int>(p)) {
                ++slot;
            }
            const bool ok = slot == kPlySlots ? skipProperty(property)
                                              : readSlot(property, static_cast<PlySlot>(slot), &values[slot]);
            if (!ok) { return false; }
        }
        appendVertex(values, slots);
        return source_.endRecord();
    }

    bool readSlot(const PlyProperty& property, PlySlot slot, double* value) {
        if (!source_.read(property.type, nameOf(slot), value)) { return false; }
        if (std::fabs(*value) <= kMaxCoordinate) { return true; }
        if (slot <= kZ) {
            return source_.fail(
                fmt::format("{} is {}; expected a finite number below 1e18", nameOf(slot), *value));
        }
        source_.remark("normals, texture coordinates and colours that are no finite numbers count as 0");
        *value = 0.0;
        return true;
    }

    void appendVertex(const std::array<double, kPlySlots>& values, const PlySlots& slots) {
        const auto number = [&values](PlySlot slot) { return static_cast<float>(values[slot]); };
        const auto has = [&slots](PlySlot first, size_t count) {
            return std::all_of(&slots[first], &slots[first] + count, [](int slot) { return slot >= 0; });
        };
        ObjPools& to = mesh.vertices;
        to.positions.emplace_back(number(kX), number(kY), number(kZ));
        if (has(kNx, 3)) { to.normals.emplace_back(number(kNx), number(kNy), number(kNz)); }
        if (has(kU, 2)) { to.uvs.emplace_back(number(kU), number(kV)); }
        if (has(kRed, 3)) { to.colors.emplace_back(number(kRed), number(kGreen), number(kBlue)); }
    }

    bool readFaces(const PlyElement& element, bool areStrips) {
        const FaceProperties which{
            element.find({"vertex_indices", "vertex_index", "vertex_indexes", "vertices", "indices"}),
            element.find({"texcoord", "texcoords", "texture_coordinates"}),
            element.find({"texnumber", "texture_index"})};
        if (which.corners < 0 || !element.properties[static_cast<size_t>(which.corners)].isList) {
            return headerFailure(element,
                                 fmt::format("expected the property \"list uchar int vertex_indices\" in "
                                             "the element {}",
                                             element.name));
        }
        if (mesh.vertices.positions.empty() && element.count > 0) {
            return headerFailure(element,
                                 fmt::format("expected the element vertex, with at least one, before the "
                                             "element {}",
                                             element.name));
        }
        for (uint64_t i = 0; i < element.count; ++i) {
            if (!readFace(element, which, areStrips)) { return false; }
        }
        return true;
    }

    bool readFace(const PlyElement& element, const FaceProperties& which, bool isStrip) {
        corners_.clear();
        uvs_.clear();
        double texture = 0.0;
        if (!source_.beginRecord()) { return false; }
        for (size_t p = 0; p < element.properties.size(); ++p) {
            const PlyProperty& property = element.properties[p];
            const int index = static_cast<int>(p);
            const bool ok = index == which.corners                  ? readCorners(property, isStrip)
                            : index == which.uvs && property.isList ? readUvs(property)
                            : index == which.texture && !property.isList
                                ? source_.read(property.type, "texnumber", &texture)
                                : skipProperty(property);
            if (!ok) { return false; }
        }
        if (isStrip) {
            mesh.addStrip(corners_);
        } else if (!addFace(texture)) {
            return false;
        }
        return source_.endRecord();
    }

    bool addFace(double texture) {
        if (corners_.size() < 3) {
            source_.remark("faces of fewer than 3 corners are left out");
            return true;
        }
        if (!uvs_.empty() && uvs_.size() != corners_.size()) {
            source_.remark("a face has other texture coordinates than corners; they are left out");
            uvs_.clear();
        }
        const bool isNamed = texture >= 0.0 && texture < static_cast<double>(header_.textures.size());
        if (!mesh.addFace(corners_, uvs_, isNamed ? static_cast<size_t>(texture) : 0)) {
            source_.remark("faces of thousands of corners that are not convex are left out");
        }
        return true;
    }

    /// In strips, -1 ends one and begins another.
    bool readCorners(const PlyProperty& property, bool isStrip) {
        uint64_t count = 0;
        if (!readCount(property, &count)) { return false; }
        const auto known = static_cast<double>(mesh.vertices.positions.size());
        for (uint64_t i = 0; i < count; ++i) {
            double index = 0.0;
            if (!source_.read(property.type, "a vertex number", &index)) { return false; }
            if (isStrip && index == -1.0) {
                mesh.addStrip(corners_);
                corners_.clear();
                continue;
            }
            if (!(index >= 0.0 && index < known && index == std::floor(index))) {
                return source_.fail(
                    fmt::format("there is no vertex {}; they count from 0 to {}", index, known - 1.0));
            }
            corners_.push_back(static_cast<uint32_t>(index));
        }
        return true;
    }

    bool readUvs(const PlyProperty& property) {
        uint64_t count = 0;
        if (!readCount(property, &count)) { return false; }
        for (uint64_t i = 0; i < count; ++i) {
            double number = 0.0;
            if (!source_.read(property.type, "a texture coordinate", &number)) { return false; }
            if (!(std::fabs(number) <= kMaxCoordinate)) { number = 0.0; }
            if (i % 2 == 0) {
                uvs_.emplace_back(static_cast<float>(number), 0.0f);
            } else {
                uvs_.back().y = static_cast<float>(number);
            }
        }
        return true;
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
    std::vector<uint32_t> corners_;  ///< scratch
    std::vector<Vec2> uvs_;          ///< scratch
};

}  // namespace glint
