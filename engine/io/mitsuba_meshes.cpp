#include "engine/io/mitsuba_meshes.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "engine/io/atomic_file.h"
#include "engine/io/file_path.h"
#include "engine/io/mesh_normals.h"
#include "engine/io/mitsuba_attributes.h"
#include "engine/io/mitsuba_normals.h"
#include "engine/io/mitsuba_serialized.h"
#include "engine/io/obj_loader.h"
#include "engine/io/ply_loader.h"

namespace glint {

/// What makes one mesh another than the next.
struct MitsubaMeshes::Wish {
    std::string type;
    std::string file;  ///< as seen from the scene's folder
    std::string path;  ///< where it is
    int number = 0;    ///< serialized: which of the file's
    bool hasFacets = false, isFlipped = false, isMirrored = false;
    float smoothAngleDeg = -1.0f;  ///< below 0: none is given
    std::string attribute;
    Vec3 low{0.0f}, high{1.0f};

    Key key() const {
        return {file,           number,    (hasFacets ? 1 : 0) + (isFlipped ? 2 : 0) + (isMirrored ? 4 : 0),
                smoothAngleDeg, attribute, {low.x, low.y, low.z, high.x, high.y, high.z}};
    }
};

/// What a file holds.
struct MitsubaMeshes::Raw {
    std::shared_ptr<MeshData> mesh;
    std::string bytes;
    bool hasFacets = false;
    bool isOwn = false;  ///< the scene must hold the triangles, since Glint would read the file differently
    MeshFile file = {};  ///< obj and ply
};

MitsubaMeshes::Wish MitsubaMeshes::wishOf(MitsubaObject* shape, const MitsubaSurface& surface,
                                          bool isMirrored) {
    Wish wish;
    wish.type = shape->type();
    const MitsubaElement* file = shape->property("filename");
    if (file == nullptr) {
        context_.fail(shape->element(), "the shape has no \"filename\"");
    } else {
        wish.path = context_.xml.findFile(*file, file->attribute("value"));
        wish.file = context_.fileOf(*file, file->attribute("value"));
    }
    wish.number = shape->integer("shape_index", 0, 0, 1 << 24);
    wish.hasFacets = shape->flag("face_normals", false);
    wish.isFlipped = shape->flag("flip_normals", false);
    wish.isMirrored = isMirrored;
    wish.smoothAngleDeg = shape->number("max_smooth_angle", -1.0f, -1.0f, 180.0f);
    wish.attribute = surface.attribute;
    wish.low = surface.low;
    wish.high = surface.high;
    shape->passOver({"srgb", "collapse", "optimize"});
    return wish;
}

Result<MitsubaMeshes::Raw> MitsubaMeshes::read(const Wish& wish) {
    Result<std::string> bytes = readFile(wish.path);
    if (!bytes) { return bytes.error(); }
    Raw raw;
    raw.bytes = std::move(*bytes);
    if (wish.type == "serialized") {
        Result<SerializedMesh> mesh = parseSerialized(raw.bytes, wish.path, wish.number);
        if (!mesh) { return mesh.error(); }
        raw.mesh = std::move(mesh->mesh);
        raw.hasFacets = mesh->hasFaceNormals;
        raw.isOwn = true;
    } else {
        Result<MeshFile> file =
            wish.type == "obj" ? parseObj(raw.bytes, wish.path) : parsePly(raw.bytes, wish.path);
        if (!file) { return file.error(); }
        raw.file = std::move(*file);
        warnings_.insert(warnings_.end(), raw.file.warnings.begin(), raw.file.warnings.end());
        raw.mesh = joinParts(raw.file.parts);
    }
    if (LoadCounts* counts = context_.options.counts; counts != nullptr) {
        ++counts->meshFiles;
        counts->meshFileBytes += raw.bytes.size();
    }
    return raw;
}

bool MitsubaMeshes::addAttribute(const Wish& wish, Raw* raw) {
    MeshData& mesh = *raw->mesh;
    const auto colorOf = [&](const Vec3& value) { return wish.low + value * (wish.high - wish.low); };
    if (wish.type != "ply") {
        const bool isStored = wish.attribute == "vertex_color" && !mesh.colors.empty();
        std::ranges::transform(mesh.colors, mesh.colors.begin(), colorOf);
        return isStored;
    }
    const Result<PlyAttribute> attribute = readPlyAttribute(raw->bytes, wish.path, wish.attribute);
    if (!attribute) { return false; }
    if (attribute->corners.empty()) {
        if (attribute->values.size() != mesh.positions.size()) { return false; }
        mesh.colors.clear();
        std::ranges::transform(attribute->values, std::back_inserter(mesh.colors), colorOf);
        return true;
    }
    std::vector<Vec3> colors;
    for (size_t face = 0; face < attribute->values.size(); ++face) {
        const uint32_t corners = attribute->corners[face];
        if (corners >= 3 && colors.size() <= mesh.indices.size()) {
            colors.insert(colors.end(), 3 * (size_t{std::min(corners, 1u << 20)} - 2),
                          colorOf(attribute->values[face]));
        }
    }
    if (colors.size() != mesh.indices.size()) { return false; }
    if (mesh.normals.empty() && !wish.hasFacets) { smoothByVertices(&mesh); }
    partTriangles(&mesh);
    mesh.colors = std::move(colors);
    return true;
}

MitsubaMesh MitsubaMeshes::take(MitsubaObject* shape, const MitsubaSurface& surface, bool isMirrored) {
    const Wish wish = wishOf(shape, surface, isMirrored);
    if (context_.failed()) { return {}; }
    const auto known = taken_.find(wish.key());
    if (known != taken_.end()) { return known->second; }
    Result<Raw> raw = read(wish);
    if (!raw) {
        if (fileExists(wish.path)) {
            context_.error = context_.failed() ? context_.error : raw.error();
        } else {
            context_.refuse(shape->element(), fmt::format("the file \"{}\" cannot be read: {}", wish.path,
                                                          raw.error().message));
        }
        return taken_[wish.key()] = {};
    }
    const bool hadColors = !raw->mesh->colors.empty();
    const bool hasAttribute = !wish.attribute.empty() && addAttribute(wish, &*raw);
    if (!wish.attribute.empty() && !hasAttribute) {
        context_.remark(shape->element(),
                        "approximated: meshes without the attribute that their texture shows "
                        "are white",
                        wish.attribute);
    }
    if (!hasAttribute) { raw->mesh->colors.clear(); }
    raw->isOwn = raw->isOwn || hasAttribute || hadColors;
    return taken_[wish.key()] = add(wish, std::move(*raw));
}

/// Normals of a file are kept as they are; others follow the shape.
MitsubaMesh MitsubaMeshes::add(const Wish& wish, Raw raw) {
    MeshData& mesh = *raw.mesh;
    const bool hasNormals = !mesh.normals.empty() && std::ranges::none_of(mesh.normals, isZero);
    const bool hasFacets = wish.hasFacets || raw.hasFacets;
    const bool keepsNormals = hasNormals && !hasFacets && wish.smoothAngleDeg < 0.0f;
    raw.isOwn = raw.isOwn || !keepsNormals || wish.isFlipped;
    turnByNormals(&mesh);
    if (!keepsNormals) {
        // A mirror turns the normals that Mitsuba computes, but not those that a file brings.
        if (wish.isMirrored) { turnOver(&mesh); }
        mesh.normals.clear();
        if (wish.smoothAngleDeg >= 0.0f && !hasFacets) {
            smoothByAngle(wish.smoothAngleDeg, &mesh);
        } else if (!hasFacets) {
            smoothByVertices(&mesh);
        }
    }
    if (wish.isFlipped) { turnOver(&mesh); }
    Mesh out;
    out.name = std::filesystem::path(wish.file).stem().string();
    if (wish.type == "serialized") { out.name += fmt::format(" {}", wish.number); }
    if (!raw.isOwn) {
        out.source = FileSource{wish.file};
        completeNormals(wish.path, &raw.file);
        raw.mesh = joinParts(raw.file.parts);
    }
    const MitsubaMesh result{static_cast<int>(context_.scene.meshes.size()), isOpenMesh(*raw.mesh)};
    out.data = std::move(raw.mesh);
    context_.scene.meshes.push_back(std::move(out));
    return result;
}

MitsubaMesh MitsubaMeshes::cube(bool isFlipped) {
    MitsubaMesh& cube = cubes_[isFlipped ? 1 : 0];
    if (cube.index >= 0) { return cube; }
    auto mesh = std::make_shared<MeshData>();
    // Of each side: its normal, and the direction from its first corner to its second.
    constexpr int kSides[6][6] = {{0, -1, 0, 0, 0, 1}, {0, 1, 0, -1, 0, 0}, {1, 0, 0, 0, 1, 0},
                                  {0, 0, 1, 0, 1, 0},  {-1, 0, 0, 0, 1, 0}, {0, 0, -1, 0, -1, 0}};
    for (const int* side : kSides) {
        const Vec3 n(side[0], side[1], side[2]), along(side[3], side[4], side[5]);
        const Vec3 across = glm::cross(n, along);
        const auto first = static_cast<uint32_t>(mesh->positions.size());
        const Vec3 corners[] = {n - along - across, n + along - across, n + along + across,
                                n - along + across};
        constexpr Vec2 kUvs[] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
        for (int c = 0; c < 4; ++c) {
            mesh->positions.push_back(corners[c]);
            mesh->normals.push_back(n);
            mesh->uvs.push_back(kUvs[c]);
        }
        for (const uint32_t corner : {0u, 1u, 2u, 3u, 0u, 2u}) {
            mesh->indices.push_back(first + corner);
        }
    }
    if (isFlipped) { turnOver(mesh.get()); }
    cube.index = static_cast<int>(context_.scene.meshes.size());
    context_.scene.meshes.push_back({isFlipped ? "flipped cube" : "cube", {}, std::move(mesh)});
    return cube;
}

int MitsubaMeshes::reversed(int mesh) {
    const auto [known, isNew] = reversed_.try_emplace(mesh, static_cast<int>(context_.scene.meshes.size()));
    if (isNew) {
        const Mesh& front = context_.scene.meshes[static_cast<size_t>(mesh)];
        auto back = std::make_shared<MeshData>(*front.data);
        turnOver(back.get());
        back->colors.clear();
        context_.scene.meshes.push_back({front.name + " from behind", {}, std::move(back)});
    }
    return known->second;
}

}  // namespace glint
