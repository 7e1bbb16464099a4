// The body of a PLY file: vertices, faces and strips, once for text and once for bytes (ply_source.h). For
// ply_loader.cpp only.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "engine/io/ply_elements.h"
#include "engine/io/ply_mesh.h"

namespace glint {

enum PlySlot : size_t { kX, kY, kZ, kNx, kNy, kNz, kU, kV, kRed, kGreen, kBlue, kPlySlots };

/// Which property of the vertex element holds what; -1: none.
using PlySlots = std::array<int, kPlySlots>;
PlySlots plySlotsOf(const PlyElement& vertex);
const char* nameOf(PlySlot slot);

/// Which property of a face or strip element holds what; -1: none. Corners' colours come before the face's.
struct PlyFaceProperties {
    int corners, uvs, texture, cornerColors;
    int rgb[3];

    bool hasRgb() const { return rgb[0] >= 0 && rgb[1] >= 0 && rgb[2] >= 0; }
};
PlyFaceProperties plyFacePropertiesOf(const PlyElement& face);

template <class Source>
class PlyBody : public PlyElements<Source> {
  public:
    using PlyElements<Source>::PlyElements;

    /// Error: with its place; an element that does not fit into the file.
    Status run() {
        const std::vector<PlyElement>& elements = header_.elements;
        const auto vertices = std::ranges::find_if(elements, isVertex);
        const bool facesFirst = std::any_of(elements.begin(), vertices, isFaceOrStrip);
        const auto start = source_.place();
        bool ok = true;
        if (facesFirst && vertices != elements.end()) {
            ok = readAll([&](const PlyElement& element) {
                return isVertex(element) ? readVertices(element) : skipElement(element);
            });
            source_.goTo(start);
        }
        ok = ok && readAll([&](const PlyElement& element) {
                 return isFaceOrStrip(element)             ? readFaces(element)
                        : isVertex(element) && !facesFirst ? readVertices(element)
                                                           : skipElement(element);
             });
        if (!ok) { return headerError_ ? *headerError_ : source_.error(); }
        return {};
    }

    PlyMesh mesh;
    bool hasWholeColors = false;  ///< colours are stored as integers

  private:
    using Base = PlyElements<Source>;
    using Base::header_, Base::source_, Base::headerError_;
    using Base::headerFailure, Base::readCount, Base::skipElement, Base::skipProperty;

    static bool isVertex(const PlyElement& element) { return element.is({"vertex", "vertices"}); }
    static bool isStrip(const PlyElement& element) { return element.is({"tristrips", "tristrip"}); }
    static bool isFaceOrStrip(const PlyElement& element) {
        return element.is({"face", "faces"}) || isStrip(element);
    }

    template <class Read>
    bool readAll(const Read& read) {
        return std::ranges::all_of(header_.elements, [&](const PlyElement& element) {
            return this->fits(element) && read(element);
        });
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
        if (slot > kZ) {
            makeFinite(value);
        } else if (!(std::fabs(*value) <= kMaxCoordinateD)) {
            if (!unplaced_) {
                source_.fail(
                    fmt::format("{} is {}; expected a finite number below 1e18", nameOf(slot), *value));
                unplaced_ = {mesh.vertices.positions.size(), source_.error()};
            }
            *value = std::numeric_limits<double>::quiet_NaN();
        }
        return true;
    }

    void makeFinite(double* attribute) {
        if (std::fabs(*attribute) <= kMaxCoordinateD) { return; }
        source_.remark("normals, texture coordinates and colours that are no finite numbers count as 0");
        *attribute = 0.0;
    }

    void appendVertex(const std::array<double, kPlySlots>& values, const PlySlots& slots) {
        const auto number = [&values](PlySlot slot) { return static_cast<float>(values[slot]); };
        const auto has = [&slots](PlySlot first, size_t count) {
            return std::all_of(&slots[first], &slots[first] + count, [](int slot) { return slot >= 0; });
        };
        ObjPools& to = mesh.vertices;
        to.positions.emplace_back(number(kX), number(kY), number(kZ));
        if (unplaced_ && !mesh.isPlaced(to.positions.size() - 1)) {
            source_.remark(
                "vertices without a place (not finite, or above 1e18) that no face uses are left out");
        }
        if (has(kNx, 3)) { to.normals.emplace_back(number(kNx), number(kNy), number(kNz)); }
        if (has(kU, 2)) { to.uvs.emplace_back(number(kU), number(kV)); }
        if (has(kRed, 3)) { to.colors.emplace_back(number(kRed), number(kGreen), number(kBlue)); }
    }

    bool readFaces(const PlyElement& element) {
        PlyFaceProperties which = plyFacePropertiesOf(element);
        if (which.corners < 0) {
            std::vector<std::string_view> found;
            for (const PlyProperty& property : element.properties) {
                found.push_back(property.name);
            }
            return headerFailure(
                element,
                fmt::format("expected the property \"list uchar int vertex_indices\" in the element {}, but "
                            "found {}",
                            element.name, fmt::join(found, ", ")));
        }
        if (mesh.vertices.positions.empty() && element.count > 0) {
            return headerFailure(
                element, fmt::format("expected the element vertex beside the element {}", element.name));
        }
        if (const int first = which.hasRgb() ? which.rgb[0] : which.cornerColors; first >= 0) {
            if (!mesh.vertices.colors.empty() || isStrip(element)) {
                source_.remark("colours of faces are left out where vertices have some, and in strips");
                which.cornerColors = which.rgb[0] = -1;
            } else {
                hasWholeColors = !isFloat(element.properties[static_cast<size_t>(first)].type);
            }
        }
        for (uint64_t i = 0; i < element.count; ++i) {
            if (!readFace(element, which)) { return false; }
        }
        return true;
    }

    bool readFace(const PlyElement& element, const PlyFaceProperties& which) {
        const bool areStrips = isStrip(element);
        corners_.clear();
        uvs_.clear();
        colors_.clear();
        double texture = 0.0;
        std::array<double, 3> rgb{};
        if (!source_.beginRecord()) { return false; }
        for (size_t p = 0; p < element.properties.size(); ++p) {
            const PlyProperty& property = element.properties[p];
            const int index = static_cast<int>(p);
            const auto channel = static_cast<size_t>(std::ranges::find(which.rgb, index) - which.rgb);
            const bool ok = index == which.corners ? readCorners(property, areStrips)
                            : index == which.uvs   ? readNumbers(property, "a texture coordinate", &uvs_)
                            : index == which.cornerColors ? readNumbers(property, "a colour", &colors_)
                            : index == which.texture      ? source_.read(property.type, "texnumber", &texture)
                            : channel < 3 ? source_.read(property.type, "a colour", &rgb[channel])
                                          : skipProperty(property);
            if (!ok) { return false; }
        }
        for (size_t c = 0; c < 3 && which.hasRgb(); ++c) {
            makeFinite(&rgb[c]);
            colors_.push_back(static_cast<float>(rgb[c]));
        }
        if (areStrips) {
            mesh.addStrip(corners_);
        } else {
            addFace(texture);
        }
        return source_.endRecord();
    }

    void addFace(double texture) {
        if (corners_.size() < 3) {
            source_.remark("faces of fewer than 3 corners are left out");
            return;
        }
        const bool isNamed = texture >= 0.0 && texture < static_cast<double>(header_.textures.size());
        const std::string_view leftOut =
            mesh.addFace({corners_, uvs_, colors_, isNamed ? static_cast<size_t>(texture) : 0});
        if (!leftOut.empty()) { source_.remark(leftOut); }
    }

    /// In strips, -1 ends one and begins another.
    bool readCorners(const PlyProperty& property, bool areStrips) {
        uint64_t count = 0;
        if (!readCount(property, &count)) { return false; }
        const auto known = static_cast<double>(mesh.vertices.positions.size());
        for (uint64_t i = 0; i < count; ++i) {
            double index = 0.0;
            if (!source_.read(property.type, "a vertex number", &index)) { return false; }
            if (areStrips && index == -1.0) {
                mesh.addStrip(corners_);
                corners_.clear();
                continue;
            }
            if (!(index >= 0.0 && index < known && index == std::floor(index))) {
                return source_.fail(
                    fmt::format("there is no vertex {}; they count from 0 to {}", index, known - 1.0));
            }
            corners_.push_back(static_cast<uint32_t>(index));
            if (unplaced_ && !mesh.isPlaced(corners_.back())) { return refuseUnplaced(corners_.back()); }
        }
        return true;
    }

    bool refuseUnplaced(uint32_t vertex) {
        if (vertex == unplaced_->first) {
            headerError_ = unplaced_->second;
            return false;
        }
        return source_.fail(
            fmt::format("vertex {} has no place: x, y or z is no finite number below 1e18", vertex));
    }

    bool readNumbers(const PlyProperty& property, const char* what, std::vector<float>* numbers) {
        uint64_t count = 0;
        if (!readCount(property, &count)) { return false; }
        numbers->clear();
        for (uint64_t i = 0; i < count; ++i) {
            double number = 0.0;
            if (!source_.read(property.type, what, &number)) { return false; }
            makeFinite(&number);
            numbers->push_back(static_cast<float>(number));
        }
        return true;
    }

    std::optional<std::pair<size_t, Error>> unplaced_;  ///< the first vertex without a place, and why
    std::vector<uint32_t> corners_;                     ///< scratch
    std::vector<float> uvs_, colors_;                   ///< scratch
};

}  // namespace glint
