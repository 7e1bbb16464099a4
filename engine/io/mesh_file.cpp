#include "engine/io/mesh_file.h"

#include <filesystem>
#include <map>
#include <type_traits>
#include <utility>

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

void appendTriangles(const MeshData& mesh, MeshData* out) {
    const size_t before = out->positions.size();
    const size_t count = mesh.positions.size();
    const auto append = [&](auto& values, const auto& added, auto missing) {
        if (!values.empty() || !added.empty()) {
            values.resize(before, missing);
            values.insert(values.end(), added.begin(), added.end());
            values.resize(before + count, missing);
        }
    };
    append(out->normals, mesh.normals, Vec3(0.0f));
    append(out->uvs, mesh.uvs, Vec2(0.0f));
    append(out->colors, mesh.colors, Vec3(1.0f));
    append(out->tangents, mesh.tangents, Vec4(0.0f));
    out->positions.insert(out->positions.end(), mesh.positions.begin(), mesh.positions.end());
    for (const uint32_t index : mesh.indices) {
        out->indices.push_back(index + static_cast<uint32_t>(before));
    }
}

/// Room for `more`, unless it comes by itself while vectors double.
void makeRoom(auto* values, size_t more) {
    if (more > values->size()) { values->reserve(values->size() + more + kLateComers); }
}

/// Appends `part` to `whole`, of the same material.
void addPart(MeshPart part, MeshPart* whole) {
    const uint32_t before = whole->mesh->triangleCount();
    if (!part.smoothing.empty() && whole->smoothing.empty()) { whole->smoothing.emplace_back(); }
    if (part.smoothing.empty() && !whole->smoothing.empty()) { part.smoothing.emplace_back(); }
    for (SmoothingRun run : part.smoothing) {
        run.firstTriangle += before;
        whole->smoothing.push_back(run);
    }
    appendTriangles(*part.mesh, whole->mesh.get());
}

/// `File` is const where it keeps what it has; else its meshes alone stay.
template <class File>
void append(File& file, const std::string& path, const Object& prototype, SceneDescription* scene) {
    const auto take = [](auto& value) -> decltype(auto) {
        if constexpr (std::is_const_v<File>) {
            return (value);
        } else {
            return std::move(value);
        }
    };
    const auto firstTexture = static_cast<int>(scene->textures.size());
    const auto firstMaterial = static_cast<int>(scene->materials.size());
    const std::string resolved = resolvePath(path, scene->path);
    for (auto& texture : file.textures) {
        scene->textures.push_back(take(texture));
        SceneImage& image = scene->textures.back().image;
        image.source = FileSource{besideFile(pathOf(image.source), resolved, path)};
    }
    if (scene->materials.empty()) {
        scene->materials = take(file.materials);
    } else {
        scene->materials.insert(scene->materials.end(), file.materials.begin(), file.materials.end());
    }
    for (size_t i = static_cast<size_t>(firstMaterial); i < scene->materials.size(); ++i) {
        for (int* texture : inputTextures(&scene->materials[i])) {
            *texture += *texture >= 0 ? firstTexture : 0;
        }
    }
    makeRoom(&scene->meshes, file.parts.size());
    makeRoom(&scene->objects, file.parts.size());
    for (size_t i = 0; i < file.parts.size(); ++i) {
        auto& part = file.parts[i];
        Object object = prototype;
        object.name = part.name;
        object.shape = ShapeKind::Mesh;
        object.mesh = static_cast<int>(scene->meshes.size());
        object.material = firstMaterial + part.material;
        scene->meshes.push_back({take(part.name), FileSource{path, static_cast<int>(i)}, part.mesh});
        scene->objects.push_back(std::move(object));
    }
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
    for (const MeshPart& part : parts) {
        appendTriangles(*part.mesh, out.get());
    }
    return out;
}

bool joinByMaterial(std::vector<MeshPart>* parts, const std::function<bool(const std::string&)>& isDefined) {
    std::map<std::string, size_t, std::less<>> places;
    std::vector<MeshPart> joined;
    std::function<std::string(const MeshPart&)> keyOf = [](const MeshPart& part) {
        return part.materialName;
    };
    const auto findPlaces = [&] {
        places.clear();
        for (const MeshPart& part : *parts) {
            places.try_emplace(keyOf(part), places.size());
        }
    };
    findPlaces();
    if (places.size() > kMostSeparateParts) {
        keyOf = [&](const MeshPart& part) -> std::string {
            if (isDefined(part.materialName)) { return part.materialName; }
            return part.mesh->colors.empty() ? "\n" : "\nc";
        };
        findPlaces();
    }
    if (places.size() == parts->size()) { return false; }
    for (MeshPart& part : *parts) {
        const size_t place = places.find(keyOf(part))->second;
        if (place == joined.size()) {
            joined.push_back(std::move(part));
        } else {
            addPart(std::move(part), &joined[place]);
        }
    }
    *parts = std::move(joined);
    return true;
}

void appendMeshFile(const MeshFile& file, const std::string& path, const Object& prototype,
                    SceneDescription* scene) {
    append(file, path, prototype, scene);
}

void appendMeshFile(MeshFile&& file, const std::string& path, SceneDescription* scene) {
    append(file, path, {}, scene);
}

}  // namespace glint
