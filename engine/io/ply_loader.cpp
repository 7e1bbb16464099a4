// The body of a PLY file: vertices and faces, once for text and once for bytes (ply_source.h).
#include "engine/io/ply_loader.h"

#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "engine/io/atomic_file.h"
#include "engine/io/ply_header.h"
#include "engine/io/ply_source.h"
#include "engine/io/polygon.h"
#include "engine/math/color.h"

namespace glint {
namespace {

/// Larger coordinates have squared lengths that overflow float.
constexpr double kMaxCoordinate = 1e18;

enum Slot : size_t { kX, kY, kZ, kNx, kNy, kNz, kU, kV, kRed, kGreen, kBlue, kSlotCount };
constexpr std::array<const char*, kSlotCount> kSlotNames{"x", "y", "z",   "nx",    "ny",  "nz",
                                                         "u", "v", "red", "green", "blue"};

/// Which property of the vertex element holds what; -1: none.
using SlotTable = std::array<int, kSlotCount>;

SlotTable slotsOf(const PlyElement& vertex) {
    return {vertex.find({"x"}),
            vertex.find({"y"}),
            vertex.find({"z"}),
            vertex.find({"nx", "normal_x"}),
            vertex.find({"ny", "normal_y"}),
            vertex.find({"nz", "normal_z"}),
            vertex.find({"u", "s", "texture_u", "texture_s"}),
            vertex.find({"v", "t", "texture_v", "texture_t"}),
            vertex.find({"red", "r", "diffuse_red"}),
            vertex.find({"green", "g", "diffuse_green"}),
            vertex.find({"blue", "b", "diffuse_blue"})};
}

/// Stored colour to linear: integers are sRGB-encoded fractions of the type's largest value.
float linearColor(double stored, PlyType type) {
    if (isFloat(type)) { return static_cast<float>(std::fmax(stored, 0.0)); }
    const double largest = std::exp2(8.0 * static_cast<double>(sizeOf(type))) - 1.0;
    return srgbToLinear(static_cast<float>(std::fmin(std::fmax(stored / largest, 0.0), 1.0)));
}

template <class Source>
class PlyBody {
  public:
    PlyBody(const PlyHeader& header, Source source) : header_(header), source_(std::move(source)) {}

    Result<std::shared_ptr<MeshData>> run() {
        for (const PlyElement& element : header_.elements) {
            if (!fits(element)) { return *headerError_; }
            const bool ok = element.name == "vertex" ? readVertices(element)
                            : element.name == "face" ? readFaces(element)
                                                     : skipElement(element);
            if (!ok) { return headerError_ ? *headerError_ : source_.error(); }
        }
        return std::make_shared<MeshData>(std::move(mesh_));
    }

  private:
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
        const SlotTable slots = slotsOf(element);
        for (const int slot : slots) {
            if (slot >= 0 && element.properties[static_cast<size_t>(slot)].isList) {
                return headerFailure(element, "a vertex's coordinates and colours cannot be lists");
            }
        }
        if (slots[kX] < 0 || slots[kY] < 0 || slots[kZ] < 0) {
            return headerFailure(element, "expected the properties x, y and z in the element vertex");
        }
        if (element.count > UINT32_MAX) {
            return headerFailure(element, fmt::format("expected at most {} vertices", UINT32_MAX));
        }
        mesh_.positions.reserve(element.count);
        for (uint64_t i = 0; i < element.count; ++i) {
            if (!readVertex(element, slots)) { return false; }
        }
        return true;
    }

    bool readVertex(const PlyElement& element, const SlotTable& slots) {
        std::array<double, kSlotCount> values{};
        if (!source_.beginRecord()) { return false; }
        for (size_t p = 0; p < element.properties.size(); ++p) {
            const PlyProperty& property = element.properties[p];
            size_t slot = 0;
            while (slot < kSlotCount && slots[slot] != static_cast<int>(p)) {
                ++slot;
            }
            if (slot == kSlotCount) {
                if (!skipProperty(property)) { return false; }
            } else if (!source_.read(property.type, kSlotNames[slot], &values[slot])) {
                return false;
            } else if (!(std::fabs(values[slot]) <= kMaxCoordinate)) {
                return source_.fail(fmt::format("{} is {}; expected a finite number below 1e18",
                                                kSlotNames[slot], values[slot]));
            }
        }
        appendVertex(values, element, slots);
        return source_.endRecord();
    }

    void appendVertex(const std::array<double, kSlotCount>& values, const PlyElement& element,
                      const SlotTable& slots) {
        const auto number = [&values](Slot slot) { return static_cast<float>(values[slot]); };
        mesh_.positions.emplace_back(number(kX), number(kY), number(kZ));
        if (slots[kNx] >= 0 && slots[kNy] >= 0 && slots[kNz] >= 0) {
            mesh_.normals.emplace_back(number(kNx), number(kNy), number(kNz));
        }
        if (slots[kU] >= 0 && slots[kV] >= 0) { mesh_.uvs.emplace_back(number(kU), number(kV)); }
        if (slots[kRed] >= 0 && slots[kGreen] >= 0 && slots[kBlue] >= 0) {
            const auto color = [&](Slot slot) {
                return linearColor(values[slot], element.properties[static_cast<size_t>(slots[slot])].type);
            };
            mesh_.colors.emplace_back(color(kRed), color(kGreen), color(kBlue));
        }
    }

    bool readFaces(const PlyElement& element) {
        const int list = element.find({"vertex_indices", "vertex_index"});
        if (list < 0 || !element.properties[static_cast<size_t>(list)].isList ||
            isFloat(element.properties[static_cast<size_t>(list)].type)) {
            return headerFailure(
                element, "expected the property \"list uchar int vertex_indices\" in the element face");
        }
        if (mesh_.positions.empty()) {
            return headerFailure(element,
                                 "expected the element vertex, with at least one, before the element face");
        }
        for (uint64_t i = 0; i < element.count; ++i) {
            if (!source_.beginRecord()) { return false; }
            for (size_t p = 0; p < element.properties.size(); ++p) {
                const bool ok = static_cast<int>(p) == list ? readPolygon(element.properties[p])
                                                            : skipProperty(element.properties[p]);
                if (!ok) { return false; }
            }
            if (!source_.endRecord()) { return false; }
        }
        return true;
    }

    bool readPolygon(const PlyProperty& property) {
        uint64_t count = 0;
        if (!readCount(property, &count)) { return false; }
        if (count < 3) {
            return source_.fail(fmt::format("the face has {} corners; expected at least 3", count));
        }
        corners_.clear();
        for (uint64_t i = 0; i < count; ++i) {
            double index = 0.0;
            if (!source_.read(property.type, "a vertex number", &index)) { return false; }
            if (index < 0.0 || index >= static_cast<double>(mesh_.positions.size())) {
                return source_.fail(fmt::format("there is no vertex {}; they count from 0 to {}", index,
                                                mesh_.positions.size() - 1));
            }
            corners_.push_back(static_cast<uint32_t>(index));
        }
        return appendPolygon();
    }

    bool appendPolygon() {
        if (corners_.size() == 3) {
            mesh_.indices.insert(mesh_.indices.end(), corners_.begin(), corners_.end());
            return true;
        }
        polygon_.clear();
        for (const uint32_t corner : corners_) {
            polygon_.push_back(mesh_.positions[corner]);
        }
        triangles_.clear();
        if (!triangulatePolygon(polygon_, &triangles_)) {
            return source_.fail(
                fmt::format("the polygon has {} corners, too many of them not convex", corners_.size()));
        }
        for (const uint32_t corner : triangles_) {
            mesh_.indices.push_back(corners_[corner]);
        }
        return true;
    }

    bool readCount(const PlyProperty& property, uint64_t* count) {
        double number = 0.0;
        if (!source_.read(property.countType, "the number of items", &number)) { return false; }
        if (number < 0.0 || number > 4294967295.0 ||
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
    MeshData mesh_;
    std::vector<uint32_t> corners_;    ///< scratch
    std::vector<Vec3> polygon_;        ///< scratch
    std::vector<uint32_t> triangles_;  ///< scratch
};

}  // namespace

Result<std::shared_ptr<MeshData>> parsePly(const std::string& bytes, const std::string& path) {
    const Result<PlyHeader> header = parsePlyHeader(bytes, path);
    if (!header) { return header.error(); }
    Result<std::shared_ptr<MeshData>> mesh =
        header->format == PlyFormat::Ascii
            ? PlyBody(*header, PlyTextSource(bytes, path, header->bodyOffset)).run()
            : PlyBody(*header, PlyBinarySource(bytes, path, header->bodyOffset,
                                               header->format == PlyFormat::BinaryBigEndian))
                  .run();
    if (mesh && (*mesh)->indices.empty()) {
        return Error{"the file has no faces; expected a mesh (an element face with vertex_indices)",
                     {.file = path}};
    }
    return mesh;
}

Result<std::shared_ptr<MeshData>> loadPly(const std::string& path) {
    const Result<std::string> bytes = readFile(path);
    if (!bytes) { return bytes.error(); }
    return parsePly(*bytes, path);
}

}  // namespace glint
