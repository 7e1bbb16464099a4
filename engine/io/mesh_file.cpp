#include "engine/io/mesh_file.h"

#include <filesystem>

#include "engine/io/file_path.h"
#include "engine/scene/scene_use.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

/// The path of a file's texture, which counts from the working folder as the file's own does, as it has to be
/// written beside `written`, the file's path in the scene.
std::string besideFile(const std::string& texture, const std::string& resolvedFile,
                       const std::string& written) {
    const fs::path relative = fs::path(texture).lexically_relative(fs::path(resolvedFile).parent_path());
    const bool sameFolder = fs::path(resolvedFile).parent_path().empty();
    return relative.empty() || sameFolder ? (fs::path(written).parent_path() / texture).string()
                                          : (fs::path(written).parent_path() / relative).string();
}

}  // namespace

Material unknownMaterial(const MeshPart& part) {
    Material material;
    material.name = part.materialName.empty() ? "default" : part.materialName;
    material.color.value = Vec3(part.mesh->colors.empty() ? 0.7f : 1.0f);
    return material;
}

std::shared_ptr<MeshData> joinParts(const std::vector<MeshPart>& parts) {
    if (parts.size() == 1) { return parts[0].mesh; }
    auto out = std::make_shared<MeshData>();
    const auto append = [&](auto& values, const auto& added, auto missing, size_t before, size_t count) {
        if (!values.empty() || !added.empty()) {
            values.resize(before, missing);
            values.insert(values.end(), added.begin(), added.end());
            values.resize(before + count, missing);
        }
    };
    for (const MeshPart& part : parts) {
        const MeshData& mesh = *part.mesh;
        const size_t before = out->positions.size();
        const size_t count = mesh.positions.size();
        append(out->normals, mesh.normals, Vec3(0.0f), before, count);
        append(out->uvs, mesh.uvs, Vec2(0.0f), before, count);
        append(out->colors, mesh.colors, Vec3(1.0f), before, count);
        out->positions.insert(out->positions.end(), mesh.positions.begin(), mesh.positions.end());
        for (const uint32_t index : mesh.indices) {
            out->indices.push_back(index + static_cast<uint32_t>(before));
        }
    }
    return out;
}

void appendMeshFile(const MeshFile& file, const std::string& path, const Object& prototype,
                    SceneDescription* scene) {
    const auto firstTexture = static_cast<int>(scene->textures.size());
    const auto firstMaterial = static_cast<int>(scene->materials.size());
    const std::string resolved = resolvePath(path, scene->path);
    for (Texture texture : file.textures) {
        texture.image.source = FileSource{besideFile(pathOf(texture.image.source), resolved, path)};
        scene->textures.push_back(std::move(texture));
    }
    for (Material material : file.materials) {
        for (int* texture : inputTextures(&material)) {
            *texture += *texture >= 0 ? firstTexture : 0;
        }
        scene->materials.push_back(std::move(material));
    }
    for (size_t i = 0; i < file.parts.size(); ++i) {
        const MeshPart& part = file.parts[i];
        Object object = prototype;
        object.name = part.name;
        object.shape = ShapeKind::Mesh;
        object.mesh = static_cast<int>(scene->meshes.size());
        object.material = firstMaterial + part.material;
        scene->meshes.push_back({part.name, FileSource{path, static_cast<int>(i)}, part.mesh});
        scene->objects.push_back(std::move(object));
    }
}

}  // namespace glint
