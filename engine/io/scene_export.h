// What exporters of scenes share: the files that they write beside the scene, and what they say. For formats
// that other programs read.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"
#include "engine/scene/scene.h"
#include "engine/scene/scene_use.h"

namespace glint {

/// Appends a warning unless it is there.
void warnOnce(std::string_view warning, std::vector<std::string>* warnings);

/// Puts plastic of a like highlight in the place of Phong's and Ward's models, and principled materials in
/// that of coated metals unless the format `hasCoatedMetals`; warns where one is used.
void withUsualModels(SceneDescription* scene, bool hasCoatedMetals, std::vector<std::string>* warnings);

/// The index of refraction of a material, one for all colours and places; warns where it is not.
float oneIor(const Material& material, std::vector<std::string>* warnings);

/// Alphas along u and along v, for programs whose facets lie so; warns where they lie otherwise. Both are one
/// where the material has one.
struct UvRoughness {
    NumberInput u, v;
};
UvRoughness uvRoughness(const Material& material, std::vector<std::string>* warnings);

/// Whether it is a glass that takes light away on the way inside.
bool absorbsInside(const Material& material);

/// A revolved object's surface as triangles, in object space, with normals and texture coordinates.
MeshData turnedMesh(const Object& object);
/// The triangles of a shape that is no mesh, with normals where it is round, in object space.
MeshData shapeMesh(const Object& object);
/// Whether it is an open cylinder, and its profile runs upwards or downwards: the front lies outside.
bool isCylinder(const Object& object, bool runsUpwards);

/// The first error stays; what comes after it has usable values.
class SceneExport {
  protected:
    SceneExport(SceneDescription scene, const std::string& path, std::vector<std::string>* warnings,
                bool hasCoatedMetals = false)
        : scene_(std::move(scene)), path_(path), warnings_(*warnings) {
        if (!scene_.hiddenObjects.empty()) { warn("left out: hidden objects"); }
        const auto cast = std::erase_if(scene_.lights, [](const Light& light) { return light.onlyRayCast; });
        if (cast > 0) { warn("left out: lights of ray casting alone"); }
        withUsualModels(&scene_, hasCoatedMetals, &warnings_);
    }

    /// Writes images in memory beside the new file, and names all as seen from there.
    void placeTextures();
    /// Writes a file beside the new one, named after it; says under which name.
    std::string save(std::string_view ending, std::shared_ptr<const std::string> bytes);
    /// The same of a mesh; warns of what PLY does not hold.
    std::string savePly(const MeshData& mesh);
    /// The same of a shape that the format lacks; warns of it.
    std::string saveTriangles(const Object& object);
    /// The same of a picture, as EXR.
    std::string saveImage(std::string_view ending, const ImageF& image);
    /// Writes the environment's map, times `factor`, and says under which name.
    std::string saveEnvironment(ImageF map, const Vec3& factor);

    /// Linear. Null: it was not read.
    std::shared_ptr<const ImageF> environmentImage();
    const MeshData* meshOf(const Object& object);
    const Material& materialOf(const Object& object) const {
        return scene_.materials[static_cast<size_t>(object.material)];
    }
    bool isTextured(const Object& object) const { return !usedTextures(materialOf(object)).empty(); }
    void warn(std::string_view sentence) { warnOnce(sentence, &warnings_); }

    SceneDescription scene_;
    std::string path_;
    std::vector<std::string>& warnings_;
    Status status_;

  private:
    int plyCount_ = 0;
};

}  // namespace glint
