// A bounding sphere of the scene decides the camera.
#include "engine/io/default_view.h"

#include <cmath>

#include "engine/io/studio.h"
#include "engine/scene/mesh_area.h"
#include "engine/scene/object_box.h"
#include "engine/scene/scene_use.h"

namespace glint {
namespace {

void frame(const Bounds& bounds, Camera* camera) {
    constexpr float kMargin = 1.05f;
    const Vec3 fromTarget = glm::normalize(Vec3(0.55f, 0.4f, 1.0f));  // front right, above
    float radius = 0.5f * glm::length(bounds.extent());
    radius = radius > 0.0f ? radius : 1.0f;
    camera->verticalFovDeg = 35.0f;
    const float distance = kMargin * radius / std::sin(0.5f * camera->verticalFovDeg * kPi / 180.0f);
    camera->target = bounds.center();
    camera->position = camera->target + distance * fromTarget;
    camera->up = Vec3(0.0f, 1.0f, 0.0f);
    camera->focalDistance = distance;
    camera->apertureDiameter = 0.0f;
}

/// Of an object's mesh, 0 where it is none.
double areaOf(const SceneDescription& scene, const Object& object) {
    if (object.shape != ShapeKind::Mesh) { return 0.0; }
    return areaOf(*scene.meshes[static_cast<size_t>(object.mesh)].data, object.objectToWorld);
}

/// Whether all that shines are labels, screens and small lights: no brighter than white paper, and together
/// too little for the surfaces around. Viewers light such models. What has no area lights nothing.
bool isLitByScreensAlone(const SceneDescription& scene) {
    constexpr double kLeastMean = 0.05;
    if (!scene.lights.empty() || scene.environment.emissive()) { return false; }
    const auto materialOf = [&](const Object& object) -> const Material& {
        return scene.materials[static_cast<size_t>(object.material)];
    };
    double emitted = 0.0;
    double area = 0.0;
    for (const Object& object : scene.objects) {
        const Material& material = materialOf(object);
        if (!material.emissive()) { continue; }
        if (object.shape != ShapeKind::Mesh) { return false; }
        const double own = areaOf(scene, object);
        const float radiance = material.emissionStrength * maxComponent(material.emission.value);
        // A strength above 1 is a lamp's, however dim.
        if (own > 0.0 && maxf(radiance, material.emissionStrength) > 1.0f) { return false; }
        // What shows an image is a label or a screen.
        if (material.emission.texture < 0) { emitted += own * static_cast<double>(radiance); }
        area += own;
    }
    for (const Object& object : scene.objects) {
        if (emitted < kLeastMean * area) { return true; }
        if (!materialOf(object).emissive()) { area += areaOf(scene, object); }
    }
    return emitted < kLeastMean * area || emitted == 0.0;
}

}  // namespace

void applyDefaultView(SceneDescription* scene, bool noStudio) {
    scene->resolution = {800, 600};
    if (scene->objects.empty()) { return; }
    const Bounds bounds = sceneBounds(*scene);
    frame(bounds.empty() ? Bounds{Vec3(-1.0f), Vec3(1.0f)} : bounds, &scene->camera);
    if (scene->materials.empty()) {
        Material material;
        material.name = "default";
        material.color.value = Vec3(0.7f);
        scene->materials.push_back(std::move(material));
    }
    if (!hasLight(*scene) || isLitByScreensAlone(*scene)) { lightModel(scene, noStudio); }
}

void lightModel(SceneDescription* scene, bool noStudio) {
    if (noStudio) {
        scene->environment = {.color = Vec3(1.0f)};
        return;
    }
    addStudio(scene);
    scene->notes.emplace_back(
        "no light of the file shows its form: a studio with a ground lights it (--no-studio: white light all "
        "round)");
}

}  // namespace glint
