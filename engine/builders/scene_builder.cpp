// The edit table in code: each part asks whether an edit concerns it, and is shared with the previous scene
// otherwise. The order is that of the parts' dependencies: origin, meshes, textures, materials, tangents,
// lights, instances, camera, features.
#include "engine/builders/scene_builder.h"

#include <algorithm>
#include <chrono>
#include <unordered_map>
#include <unordered_set>

#include "engine/builders/camera_builder.h"
#include "engine/builders/feature_scan.h"
#include "engine/builders/instance_builder.h"
#include "engine/builders/light_table.h"
#include "engine/builders/material_table.h"
#include "engine/builders/mesh_builder.h"
#include "engine/builders/recentring.h"
#include "engine/builders/scene_validation.h"
#include "engine/builders/tangent_builder.h"
#include "engine/builders/texture_table.h"
#include "engine/kernels/bsdf/bsdf.h"
#include "engine/scene/scene_use.h"

namespace glint {
namespace {

using BuiltMeshes = std::vector<std::shared_ptr<const BuiltMesh>>;

constexpr EditKind kMaterials = EditKind::MaterialParameters | EditKind::MaterialKind;

/// Whether an object now places a mesh that was left unbuilt because none did.
bool placesUnbuiltMesh(const SceneDescription& scene, const BuiltScene& previous) {
    const std::vector<bool> used = usedMeshes(scene);
    for (size_t i = 0; i < used.size(); ++i) {
        if (used[i] && !previous.meshes[i]->isReady) { return true; }
    }
    return false;
}

/// Whether the mesh at this place differs only in what does not concern its structure.
bool hasTrianglesAt(const BuiltScene& scene, size_t index, const MeshData& data) {
    return index < scene.meshes.size() && scene.meshes[index]->isReady &&
           sameTriangles(*scene.meshes[index]->data, data);
}

/// What `edit` really concerns: everything, when parts appeared or vanished without its saying so.
EditKind concernedKinds(const SceneEdit& edit, const BuiltScene* previous) {
    const SceneDescription& scene = *edit.scene;
    const bool complete = previous != nullptr && previous->instances && previous->materials &&
                          previous->textures && previous->lights;
    if (!complete || scene.objects.size() != previous->instances->instances.size() ||
        scene.meshes.size() != previous->meshes.size() ||
        scene.materials.size() != previous->materials->materials.size() ||
        placesUnbuiltMesh(scene, *previous)) {
        return edit.kinds | EditKind::Everything;
    }
    return edit.kinds;
}

class SceneBuild {
  public:
    SceneBuild(const SceneEdit& edit, const BuiltScene* previous, int threads, const std::atomic<bool>* stop,
               BuildReport* report)
        : scene_(edit.scene.get()),
          kinds_(concernedKinds(edit, previous)),
          threads_(threads),
          stop_(stop),
          report_(*report),
          built_(previous != nullptr ? std::make_shared<BuiltScene>(*previous)
                                     : std::make_shared<BuiltScene>()) {}

    Result<std::shared_ptr<const BuiltScene>> run() {
        for (Status (SceneBuild::*step)() :
             {&SceneBuild::validate, &SceneBuild::recentre, &SceneBuild::meshes, &SceneBuild::textures,
              &SceneBuild::materials, &SceneBuild::tangents, &SceneBuild::lights, &SceneBuild::instances,
              &SceneBuild::camera, &SceneBuild::features}) {
            if (stop_ != nullptr && *stop_) { return Error{"the build was given up", {}}; }
            if (Status done = (this->*step)(); !done) { return done.error(); }
        }
        return std::shared_ptr<const BuiltScene>(std::move(built_));
    }

  private:
    bool concerns(EditKind kinds) const { return has(kinds_, kinds | EditKind::Everything); }

    Status validate() { return validateScene(*scene_, kinds_); }

    /// All that follows sees the moved description.
    Status recentre() {
        if (concerns(EditKind::ObjectTransform)) {
            auto found = findRecentring(*scene_, built_->recentring.get());
            if (!samePlaces(found.get(), built_->recentring.get())) { kinds_ |= EditKind::Everything; }
            built_->recentring = std::move(found);
        }
        if (built_->recentring) {
            moved_ = recentred(*scene_, *built_->recentring);
            scene_ = &moved_;
        }
        return {};
    }

    Status meshes() {
        if (!concerns(EditKind::Accelerator)) { return {}; }
        const AcceleratorKind kind = scene_->options.accelerator;
        std::unordered_map<const MeshData*, std::shared_ptr<const BuiltMesh>> known;
        for (const auto& mesh : built_->meshes) {
            known[mesh->data.get()] = mesh;
        }
        const std::vector<bool> used = usedMeshes(*scene_);
        BuiltMeshes meshes;
        meshes.reserve(scene_->meshes.size());
        for (size_t i = 0; i < scene_->meshes.size(); ++i) {
            const Mesh& mesh = scene_->meshes[i];
            if (stop_ != nullptr && *stop_) { return Error{"the build was given up", {}}; }
            std::shared_ptr<const BuiltMesh>& built = known[mesh.data.get()];
            if (!built && used[i] && hasTrianglesAt(*built_, i, *mesh.data)) {
                built = withVertexData(*built_->meshes[i], mesh.data);
            }
            const bool isReady = built && built->isReady && built->accelerator.view.kind == kind;
            if (used[i] && !isReady) {
                built = buildMesh(mesh.data, threads_, kind);
                ++report_.meshesBuilt;
            } else if (!built) {
                built = leaveMeshUnbuilt(mesh.data);
            }
            meshes.push_back(built);
        }
        built_->meshes = std::move(meshes);
        return {};
    }

    Status textures() {
        if (!concerns(EditKind::MaterialKind) && !(concerns(EditKind::Lights) && showImages())) { return {}; }
        auto table = buildTextureTable(*scene_, built_->textures);
        if (!table) { return table.error(); }
        report_.texturesBuilt = *table != built_->textures;
        built_->textures = std::move(table).value();
        return {};
    }

    Status materials() {
        if (!concerns(kMaterials)) { return {}; }
        auto table = buildMaterialTable(*scene_, *built_->textures, built_->materials);
        if (!table) { return table.error(); }
        report_.materialsBuilt = *table != built_->materials;
        emissionChanged_ =
            !sameEmission(built_->materials.get(), **table) ||
            (report_.texturesBuilt && std::ranges::any_of((*table)->materials, [](const MaterialData& m) {
                 return m.emissionTexture != kNone;
             }));
        materialFeaturesChanged_ = !sameFeatures(built_->materials.get(), **table);
        built_->materials = std::move(table).value();
        return {};
    }

    Status tangents() {
        if (!concerns(kMaterials | EditKind::ObjectTransform | EditKind::Accelerator)) { return {}; }
        auto tangents = buildTangents(*scene_, built_->tangents);
        tangentsChanged_ = tangents != built_->tangents;
        built_->tangents = std::move(tangents);
        return {};
    }

    bool showImages() const { return std::ranges::any_of(scene_->lights, showsImage); }

    Status lights() {
        const bool emittersMoved = concerns(EditKind::ObjectTransform) && shapesEmit();
        const bool imagesMoved = report_.texturesBuilt && showImages();
        if (!concerns(EditKind::Lights) && !emittersMoved && !emissionChanged_ && !imagesMoved) { return {}; }
        auto table = buildLightTable(*scene_, *built_->textures, built_->lights, threads_);
        emittersMoved_ = !built_->lights || table->firstEmitter != built_->lights->firstEmitter;
        report_.lightsBuilt = table != built_->lights;
        built_->lights = std::move(table);
        return {};
    }

    Status instances() {
        if (concerns(EditKind::ObjectTransform | EditKind::Accelerator) || emittersMoved_ ||
            tangentsChanged_) {
            built_->instances =
                buildInstances(*scene_, built_->meshes, built_->lights->firstEmitter, built_->tangents);
            report_.topLevelBuilt = true;
        }
        return {};
    }

    Status camera() {
        if (!concerns(EditKind::Camera | EditKind::Resolution)) { return {}; }
        const float aspect =
            static_cast<float>(scene_->resolution.width) / static_cast<float>(scene_->resolution.height);
        auto camera = buildCamera(scene_->camera, aspect);
        if (!camera) { return camera.error(); }
        built_->camera = *camera;
        return {};
    }

    /// The mask may only grow while a scene is edited: a kernel that was good enough stays so, and a slider
    /// that passes through zero does not switch kernels back and forth. The choice of an acceleration
    /// structure is no slider.
    Status features() {
        FeatureMask mask = concerns(EditKind::Everything) ? 0 : built_->features & ~kFeatureAccelerators;
        if (concerns(EditKind::ObjectTransform) || materialFeaturesChanged_) {
            mask |= scanFeatures(*scene_, *built_->materials);
            report_.featuresScanned = true;
        }
        if (built_->camera.hasArea()) { mask |= kFeatureCameraArea; }
        if (scene_->options.accelerator != AcceleratorKind::Bvh) { mask |= kFeatureAccelerators; }
        built_->features = mask | built_->lights->features();
        return {};
    }

    bool shapesEmit() const {
        for (const Material& material : scene_->materials) {
            if (material.emissive()) { return true; }
        }
        return built_->lights && (built_->lights->features() & kFeatureAreaLights) != 0;
    }

    static bool sameEmission(const MaterialTable* before, const MaterialTable& after) {
        if (before == nullptr || before->materials.size() != after.materials.size()) { return false; }
        constexpr uint8_t kEmissionFlags = kMaterialEmissive | kMaterialEmitsBothSides;
        for (size_t i = 0; i < after.materials.size(); ++i) {
            const MaterialData &a = before->materials[i], &b = after.materials[i];
            if (a.emission != b.emission || a.emissionTexture != b.emissionTexture ||
                ((a.flags ^ b.flags) & kEmissionFlags) != 0) {
                return false;
            }
        }
        return true;
    }

    /// Whether all materials need the same of the kernels.
    static bool sameFeatures(const MaterialTable* before, const MaterialTable& after) {
        return before != nullptr &&
               std::ranges::equal(before->materials, after.materials, {}, materialFeatures, materialFeatures);
    }

    const SceneDescription* scene_;
    SceneDescription moved_;  ///< what scene_ points to where the scene is far from the origin
    EditKind kinds_;
    int threads_;
    const std::atomic<bool>* stop_;
    BuildReport& report_;
    std::shared_ptr<BuiltScene> built_;
    bool emissionChanged_ = false;
    bool emittersMoved_ = false;
    bool tangentsChanged_ = false;
    bool materialFeaturesChanged_ = false;
};

}  // namespace

Result<std::shared_ptr<const BuiltScene>> buildScene(const SceneEdit& edit, const BuiltScene* previous,
                                                     int threads, const std::atomic<bool>* stop,
                                                     BuildReport* report) {
    const auto began = std::chrono::steady_clock::now();
    BuildReport unused;
    BuildReport& parts = report != nullptr ? *report : unused;
    auto built = SceneBuild(edit, previous, threads, stop, &parts).run();
    parts.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    return built;
}

size_t trianglesToBuild(const SceneDescription& scene, const BuiltScene* previous) {
    std::unordered_set<const MeshData*> known;
    if (previous != nullptr) {
        for (const auto& mesh : previous->meshes) {
            if (mesh->isReady) { known.insert(mesh->data.get()); }
        }
    }
    const std::vector<bool> used = usedMeshes(scene);
    size_t triangles = 0;
    for (size_t i = 0; i < used.size(); ++i) {
        const MeshData* data = scene.meshes[i].data.get();
        const bool isNew = used[i] && data != nullptr && known.insert(data).second;
        if (isNew && !(previous != nullptr && hasTrianglesAt(*previous, i, *data))) {
            triangles += data->triangleCount();
        }
    }
    return triangles;
}

}  // namespace glint
