#include "engine/io/scene_export.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "engine/io/baked_image.h"
#include "engine/io/embedded_files.h"
#include "engine/io/file_path.h"
#include "engine/io/image_io.h"
#include "engine/io/ply_writer.h"
#include "engine/scene/glasses.h"
#include "engine/scene/shape_forms.h"

namespace glint {

void warnOnce(std::string_view warning, std::vector<std::string>* warnings) {
    if (std::ranges::find(*warnings, warning) == warnings->end()) { warnings->emplace_back(warning); }
}

MeshData shapeMesh(const Object& object) {
    if (object.shape == ShapeKind::Revolved) { return turnedMesh(object); }
    const auto triangles = shapeForm(object.shape).triangles;
    return triangles != nullptr ? triangles() : MeshData{};
}

bool isCylinder(const Object& object, bool runsUpwards) {
    const std::vector<Vec2>& p = object.profile;
    return p.size() == 2 && !object.capped && p[0].x == p[1].x &&
           (runsUpwards ? p[0].y < p[1].y : p[0].y > p[1].y);
}

bool absorbsInside(const Material& material) { return !isZero(absorptionOf(material)); }

float oneIor(const Material& material, std::vector<std::string>* warnings) {
    if (material.ior.texture >= 0) { warnOnce("approximated: indices of refraction are constant", warnings); }
    if (!hasGlass(material) || (!replacesIor(material) && !(material.abbeNumber > 0.0f))) {
        return material.ior.value;
    }
    warnOnce("approximated: glass does not disperse", warnings);
    if (const auto glass = findGlass(material.glass)) { return glass->ior; }
    return material.glass.empty() && !isZero(material.iorRgb) ? material.iorRgb.y : material.ior.value;
}

UvRoughness uvRoughness(const Material& material, std::vector<std::string>* warnings) {
    if (!isAnisotropic(material)) { return {material.roughness, material.roughness}; }
    const float quarters = std::remainder(material.anisotropyRotationDeg, 180.0f) / 90.0f;
    if (material.anisotropyDirection.texture >= 0 || std::fabs(std::remainder(quarters, 1.0f)) > 1e-4f) {
        warnOnce("approximated: anisotropic roughness lies along u and v", warnings);
    }
    const bool isTurned = std::fabs(quarters) > 0.5f;
    return isTurned ? UvRoughness{material.crossRoughness, material.roughness}
                    : UvRoughness{material.roughness, material.crossRoughness};
}

void SceneExport::placeTextures() {
    status_ = writeEmbeddedFiles(&scene_, path_);
    for (Texture& texture : scene_.textures) {
        if (auto* file = std::get_if<FileSource>(&texture.image.source)) {
            file->path = rebasePath(file->path, scene_.path, path_);
        }
    }
}

std::string SceneExport::save(std::string_view ending, std::shared_ptr<const std::string> bytes) {
    std::string wanted = std::filesystem::path(path_).stem().string() + std::string(ending);
    if (!status_) { return wanted; }
    const Result<std::string> name = writeBeside({wanted, std::move(bytes)}, path_);
    if (!name) { status_ = name.error(); }
    return name ? *name : wanted;
}

std::string SceneExport::savePly(const MeshData& mesh) {
    if (!mesh.tangents.empty()) { warn("approximated: tangents run as the texture coordinates do"); }
    return save(fmt::format("-{}.ply", plyCount_++), std::make_shared<const std::string>(encodePly(mesh)));
}

std::string SceneExport::saveTriangles(const Object& object) {
    warn(fmt::format("approximated: {} shapes are triangles", shapeForm(object.shape).name));
    return savePly(shapeMesh(object));
}

std::string SceneExport::saveImage(std::string_view ending, const ImageF& image) {
    return save(ending, std::get<EmbeddedFile>(bakedImage(image, path_, 0)).bytes);
}

std::string SceneExport::saveEnvironment(ImageF map, const Vec3& factor) {
    for (size_t i = 0; i < map.rgb.size(); ++i) {
        map.rgb[i] *= factor[static_cast<int>(i % 3)];
    }
    return saveImage("-environment.exr", map);
}

std::shared_ptr<const ImageF> SceneExport::environmentImage() {
    const SceneImage& image = scene_.environmentImages[static_cast<size_t>(scene_.environment.image)];
    if (image.isRead()) { return linearColors(image); }
    if (status_) { status_ = Error{"the environment has not been read", {.file = path_}}; }
    return nullptr;
}

const MeshData* SceneExport::meshOf(const Object& object) {
    const Mesh& mesh = scene_.meshes[static_cast<size_t>(object.mesh)];
    if (!mesh.data && status_) {
        status_ = Error{fmt::format("the mesh \"{}\" has not been read", mesh.name), {.file = path_}};
    }
    return mesh.data.get();
}

}  // namespace glint
