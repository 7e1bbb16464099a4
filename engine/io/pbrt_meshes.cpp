#include "engine/io/pbrt_meshes.h"

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "engine/base/parallel.h"
#include "engine/io/file_path.h"
#include "engine/io/files_read.h"
#include "engine/io/gzip_file.h"
#include "engine/io/mesh_normals.h"
#include "engine/io/mitsuba_normals.h"
#include "engine/io/pbrt_grid.h"
#include "engine/io/ply_loader.h"

namespace glint {
namespace {

/// pbrt's coordinates of a triangle that has none.
void addUsualUvs(MeshData* mesh) {
    partTriangles(mesh);
    mesh->uvs.clear();
    for (size_t i = 0; i < mesh->positions.size(); ++i) {
        mesh->uvs.emplace_back(i % 3 == 0 ? 0.0f : 1.0f, i % 3 == 2 ? 1.0f : 0.0f);
    }
}

bool isFlat(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const Vec3 u = b - a, v = c - a, w = d - a;
    return std::fabs(glm::dot(glm::cross(u, v), w)) <=
           1e-4f * glm::length(u) * glm::length(v) * glm::length(w);
}

}  // namespace

int PbrtMeshes::add(std::string name, std::shared_ptr<MeshData> data, bool isReversed) {
    if (context_.failed() || (data && data->indices.empty())) { return -1; }
    if (data && isReversed) { turnOver(data.get()); }
    const auto index = static_cast<int>(context_.scene.meshes.size());
    context_.scene.meshes.push_back(
        {fmt::format("{} {}", name, index), {}, std::shared_ptr<const MeshData>(std::move(data))});
    return index;
}

PbrtMeshes::Arrays PbrtMeshes::arraysOf(const PbrtParams& params) {
    Arrays arrays;
    arrays.positions = params.points("P");
    arrays.normals = params.points("N");
    const std::vector<float>& uvs = params.numbers(params.has("uv") ? "uv" : "st", 2);
    for (size_t i = 0; i + 1 < uvs.size(); i += 2) {
        arrays.uvs.emplace_back(uvs[i], uvs[i + 1]);
    }
    params.passOver({"uv", "st", "S", "faceIndices", "emissionfilename"});
    if (arrays.positions.empty()) { params.fail("the mesh has no points \"P\""); }
    if (!arrays.normals.empty() && arrays.normals.size() != arrays.positions.size()) {
        params.approximated("normals that are not as many as points are left out");
        arrays.normals.clear();
    }
    if (!arrays.uvs.empty() && arrays.uvs.size() != arrays.positions.size()) {
        params.approximated("texture coordinates that are not as many as points are left out");
        arrays.uvs.clear();
    }
    return arrays;
}

std::vector<uint32_t> PbrtMeshes::cornersOf(const PbrtParams& params, size_t group, size_t vertices,
                                            size_t usual) {
    const std::vector<int>& indices = params.integers("indices", group);
    std::vector<uint32_t> corners(indices.size());
    for (size_t i = 0; i < indices.size(); ++i) {
        if (indices[i] < 0 || static_cast<size_t>(indices[i]) >= vertices) {
            context_.fail(
                params.find("indices")->place,
                fmt::format("the index {} is none of those of the {} points in \"P\", which count from 0",
                            indices[i], vertices));
            return {};
        }
        corners[i] = static_cast<uint32_t>(indices[i]);
    }
    if (corners.empty() && vertices == usual) {
        corners.resize(usual);
        std::iota(corners.begin(), corners.end(), 0u);
    } else if (corners.empty() && !context_.failed()) {
        params.fail("the mesh has no \"indices\"");
    }
    return corners;
}

int PbrtMeshes::triangles(const PbrtParams& params, bool needsUvs, bool isReversed) {
    Arrays arrays = arraysOf(params);
    auto mesh = std::make_shared<MeshData>();
    mesh->indices = cornersOf(params, 3, arrays.positions.size(), 3);
    mesh->positions = std::move(arrays.positions);
    mesh->normals = std::move(arrays.normals);
    mesh->uvs = std::move(arrays.uvs);
    if (context_.failed()) { return -1; }
    turnByNormals(mesh.get());
    if (needsUvs && mesh->uvs.empty()) { addUsualUvs(mesh.get()); }
    return add("triangles", std::move(mesh), isReversed);
}

std::optional<Affine> PbrtMeshes::rectangle(const PbrtParams& params) {
    const std::vector<int>& order = params.integers("indices", 4);
    if (params.has("N") || params.has("uv") || params.numbers("P", 3).size() != 12 ||
        !(order.empty() || order == std::vector<int>{0, 1, 2, 3})) {
        return std::nullopt;
    }
    const std::vector<Vec3> p = params.points("P");
    const Vec3 u = 0.5f * (p[1] - p[0]), v = 0.5f * (p[2] - p[0]), bend = p[3] - p[2] - 2.0f * u;
    const Vec3 normal = glm::cross(u, v);
    const float size = std::sqrt(glm::length(normal));
    if (!(size > 0.0f) || glm::length(bend) > 1e-6f * (glm::length(u) + glm::length(v))) {
        return std::nullopt;
    }
    return Affine{Mat3(u, v, normal / size), p[0] + u + v};
}

/// Corners stand at (0, 0), (1, 0), (0, 1) and (1, 1). What is bent gets 8 x 8 pieces.
int PbrtMeshes::patches(const PbrtParams& params, bool isReversed) {
    const Arrays arrays = arraysOf(params);
    const std::vector<uint32_t> corners = cornersOf(params, 4, arrays.positions.size(), 4);
    auto mesh = std::make_shared<MeshData>();
    for (size_t i = 0; i + 3 < corners.size(); i += 4) {
        const auto corner = [&](size_t k) { return arrays.positions[corners[i + k]]; };
        const auto blended = [&](const auto& values, float u, float v) {
            const auto at = [&](size_t k) { return values[corners[i + k]]; };
            return glm::mix(glm::mix(at(0), at(1), u), glm::mix(at(2), at(3), u), v);
        };
        constexpr int kPieces = 8;
        const int pieces = isFlat(corner(0), corner(1), corner(2), corner(3)) ? 1 : kPieces;
        const auto patch = gridMesh(pieces, pieces, [&](float u, float v) {
            const Vec3 du = glm::mix(corner(1) - corner(0), corner(3) - corner(2), v);
            const Vec3 dv = glm::mix(corner(2) - corner(0), corner(3) - corner(1), u);
            const Vec3 n = arrays.normals.empty() ? glm::cross(du, dv) : blended(arrays.normals, u, v);
            return GridPoint{blended(arrays.positions, u, v), isZero(n) ? n : glm::normalize(n)};
        });
        for (Vec2& uv : patch->uvs) {
            uv = arrays.uvs.empty() ? uv : blended(arrays.uvs, uv.x, uv.y);
        }
        const auto first = static_cast<uint32_t>(mesh->positions.size());
        const auto append = [](const auto& from, auto* to) {
            to->insert(to->end(), from.begin(), from.end());
        };
        append(patch->positions, &mesh->positions);
        append(patch->normals, &mesh->normals);
        append(patch->uvs, &mesh->uvs);
        for (const uint32_t index : patch->indices) {
            mesh->indices.push_back(first + index);
        }
    }
    turnByNormals(mesh.get());
    return add("patches", std::move(mesh), isReversed);
}

int PbrtMeshes::subdivided(const PbrtParams& params, bool isReversed) {
    constexpr int kMostLevels = 12;
    const int levels = params.integer(params.has("levels") ? "levels" : "nlevels", 3, 0, kMostLevels);
    params.passOver({"scheme"});
    std::vector<Vec3> positions = params.points("P");
    std::vector<uint32_t> indices = cornersOf(params, 3, positions.size(), 3);
    if (context_.failed()) { return -1; }
    return add("subdivided", loopSubdivided(std::move(positions), std::move(indices), levels), isReversed);
}

int PbrtMeshes::file(const PbrtParams& params, bool needsUvs, bool isReversed) {
    const std::string name = params.text("filename");
    if (name.empty()) { params.fail("the shape has no \"filename\""); }
    if (context_.failed()) { return -1; }
    const std::string path = context_.findFile(params.place(), name);
    const auto [known, isNew] = files_.try_emplace({path, needsUvs, isReversed}, -1);
    if (!isNew) { return known->second; }
    if (!fileExists(path)) {
        const Result<std::string> bytes = readUnpacked(path);
        context_.refuse(params.place(),
                        fmt::format("the file \"{}\" cannot be read: {}", path, bytes.error().message));
        return -1;
    }
    known->second = add(std::filesystem::path(name).stem().string(), nullptr, isReversed);
    waiting_.push_back({path, needsUvs, isReversed, known->second});
    context_.scene.meshes.back().source = FileSource{context_.fileOf(params.place(), name)};
    return known->second;
}

PbrtMeshes::Content PbrtMeshes::contentOf(const File& file) {
    Content content;
    const Result<std::string> bytes = readUnpacked(file.path);
    const Result<MeshFile> read = bytes ? parsePly(*bytes, file.path) : Result<MeshFile>(bytes.error());
    if (!read) {
        content.error = read.error();
        return content;
    }
    content.warnings = read->warnings;
    content.bytes = bytes->size();
    content.mesh = joinParts(read->parts);
    MeshData* mesh = content.mesh.get();
    const bool hasNormals = !mesh->normals.empty() && std::ranges::none_of(mesh->normals, isZero);
    const bool lacksUvs = file.needsUvs && mesh->uvs.empty();
    const bool isPacked = hasExtension(file.path, ".gz");
    // Others Glint would read differently: it smooths what has no normals, and shows colours.
    content.staysFile = hasNormals && mesh->colors.empty() && !file.isReversed && !isPacked && !lacksUvs;
    if (!hasNormals) { mesh->normals.clear(); }
    mesh->colors.clear();
    turnByNormals(mesh);
    if (lacksUvs) { addUsualUvs(mesh); }
    if (file.isReversed) { turnOver(mesh); }
    return content;
}

void PbrtMeshes::readFiles() {
    const std::vector<File> files = std::exchange(waiting_, {});
    std::vector<Content> contents(files.size());
    for (const File& file : files) {  // other threads' reading is not noted
        FilesRead::note(file.path);
    }
    parallelChunks(static_cast<int64_t>(files.size()), 1, 0, [&](int64_t begin, int64_t) {
        contents[static_cast<size_t>(begin)] = contentOf(files[static_cast<size_t>(begin)]);
    });
    for (size_t i = 0; i < files.size(); ++i) {
        Content& content = contents[i];
        if (content.error) {  // which comes before what was met since
            context_.error = content.error;
            return;
        }
        context_.meshWarnings.insert(context_.meshWarnings.end(), content.warnings.begin(),
                                     content.warnings.end());
        if (LoadCounts* counts = context_.options.counts; counts != nullptr) {
            ++counts->meshFiles;
            counts->meshFileBytes += content.bytes;
        }
        Mesh& mesh = context_.scene.meshes[static_cast<size_t>(files[i].mesh)];
        mesh.data = std::move(content.mesh);
        if (!content.staysFile) { mesh.source = {}; }
    }
}

}  // namespace glint
