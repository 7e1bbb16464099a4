// Collects the parts' views. Parts may be missing in scenes that only tests make.
#include "engine/builders/built_scene.h"

#include "engine/builders/instance_builder.h"
#include "engine/builders/light_table.h"
#include "engine/builders/material_table.h"
#include "engine/builders/recentring.h"
#include "engine/builders/texture_table.h"

namespace glint {

Vec3 BuiltScene::origin() const { return recentring ? recentring->origin : Vec3(0.0f); }

SceneView BuiltScene::view() const {
    SceneView scene;
    if (instances) { scene.geometry = instances->view(); }
    if (materials) {
        scene.materials = viewOf(materials->materials);
        scene.coats = viewOf(materials->coats);
        scene.spectrum = viewOf(materials->spectrum);
    }
    if (textures) { scene.textures = viewOf(textures->textures); }
    if (lights) { scene.lights = lights->view(); }
    scene.camera = camera;
    Bounds all = scene.geometry.bounds;
    all.grow(camera.position);
    scene.sceneCenter = all.center();
    const float radius = 0.5f * glm::length(all.extent());
    scene.sceneRadius = radius > 0.0f && std::isfinite(radius) ? radius : 1.0f;
    return scene;
}

bool BuiltScene::looksLike(const BuiltScene& other) const {
    const bool isComplete = instances && materials && textures && lights;
    return isComplete && meshes == other.meshes && instances == other.instances &&
           materials == other.materials && textures == other.textures && lights == other.lights &&
           camera == other.camera && recentring == other.recentring;
}

}  // namespace glint
