// The reader behind readSceneText: recursive descent over the blocks, one file per part. Internal
// to engine/io.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/io/asset_cache.h"
#include "engine/io/load_options.h"
#include "engine/io/remarks.h"
#include "engine/io/scene_text_tokens.h"
#include "engine/scene/scene.h"

namespace glint {

class SceneTextReader {
  public:
    SceneTextReader(TextSource source, const LoadOptions& options);

    Result<SceneDescription> read();

  private:
    // scene_text.cpp: blocks around the objects, and what is settled once all is read.
    void readBlocks();
    void readBlock(std::string_view word);
    void readCamera();
    void placeCamera(const TextToken& at, const Vec3& direction, const Vec3& up, float angleDeg,
                     float focalLength, float halfAperture);
    void readBackground();
    void readLights();
    void readDiskLights();
    void finish();
    /// The textures, once it is known which materials objects have.
    void readTextures();
    /// Gives bumps of meshes, which the original ignored, heights in proportion to their images.
    void scaleMeshBumps();
    /// Turns the Lights block's Phong lights into physical ones, when nothing else shines.
    void useLights(bool onlyToCastRays);
    Vec3 sceneCenter() const;

    // scene_text_materials.cpp
    void readMaterials();
    void readMaterial();
    void setScattering(const TextToken& at, const Vec3& weights, bool hasIor, float ior, Material* material);
    int addTexture(const TextToken& at, const std::string& path);

    // scene_text_objects.cpp
    void readGroup(const Affine& toWorld, int depth);
    void readObject(const Affine& toWorld, int depth);
    void readTransform(const Affine& toWorld, int depth);
    bool readOperation(Affine* transform);
    void readSphere(const Affine& toWorld);
    void readPlane(const Affine& toWorld);
    void readTriangle(const Affine& toWorld);
    void readMesh(const Affine& toWorld);
    void readRevSurface(const Affine& toWorld);
    Object readCurve();
    void addObject(const TextToken& at, ShapeKind shape, const Affine& toWorld, int mesh, bool frontOnly);
    int addMesh(const std::string& path, int part, std::shared_ptr<const MeshData> data);

    /// Something the scene asks for and does not get: reported once all is read. `kind` is as Remarks
    /// wants it.
    void remark(const TextToken& at, std::string_view kind, std::string_view detail);
    /// `path` as it has to be written to be found from the scene's folder: as it is, or from the
    /// folder above.
    std::string locate(const std::string& path) const;

    SceneTextTokens tokens_;
    LoadOptions options_;
    AssetCache assets_;
    SceneDescription scene_;
    Remarks remarks_;
    std::optional<Error> missingMesh_;  ///< the first one
    std::vector<std::string> seenBlocks_;
    std::map<std::string, int> textures_;   ///< by path
    std::vector<TextToken> texturePlaces_;  ///< where each is named first
    std::map<std::pair<std::string, int>, int> meshes_;
    int materialIndex_ = 0;
};

}  // namespace glint
