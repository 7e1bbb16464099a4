// A bounding sphere of the scene decides the camera.
#include "engine/io/default_view.h"

#include <cmath>

#include "engine/io/studio.h"
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
    if (!hasLight(*scene)) { lightModel(scene, noStudio); }
}

void lightModel(SceneDescription* scene, bool noStudio) {
    if (noStudio) {
        scene->environment = {.color = Vec3(1.0f)};
        return;
    }
    addStudio(scene);
    scene->notes.emplace_back(
        "the file brings no light: a studio with a ground lights it (--no-studio: white light from "
        "everywhere)");
}

}  // namespace glint
