// The key light is the sun of a generated sky (generated_sky.h), as large as a softbox: an object would stand
// in the way, and be framed with the model.
#include "engine/io/studio.h"

#include <algorithm>

#include "engine/scene/object_box.h"

namespace glint {
namespace {

constexpr std::string_view kGroundName = "studio ground";

bool isGround(const Object& object) { return object.shape == ShapeKind::Plane && object.name == kGroundName; }

SkySource studioLight() {
    SkySource light;
    light.zenith = light.horizon = light.ground = Vec3(0.26f);
    light.sun = Vec3(7.35f);  // irradiance 0.86 pi on what faces it: white stays below 1
    light.sunElevationDeg = 55.0f;
    light.sunAzimuthDeg = -77.0f;
    light.sunRadiusDeg = 20.0f;
    light.width = 128;
    return light;
}

Object groundUnder(const Bounds& bounds) {
    // So far below that it lies in no floor's own plane.
    const float gap = 2e-4f * maxComponent(bounds.extent());
    Object ground;
    ground.name = kGroundName;
    ground.shape = ShapeKind::Plane;
    ground.objectToWorld = {{Vec3(1, 0, 0), Vec3(0, 0, -1), Vec3(0, 1, 0)},  // +z becomes up
                            Vec3(0.0f, bounds.lo.y - gap, 0.0f)};
    return ground;
}

}  // namespace

void addStudio(SceneDescription* scene) {
    Environment& environment = scene->environment;
    environment = {.color = Vec3(1.0f), .image = static_cast<int>(scene->environmentImages.size())};
    scene->environmentImages.push_back({studioLight()});
    const Bounds bounds = sceneBounds(*scene);
    if (bounds.empty()) { return; }
    Material material;
    material.name = kGroundName;
    material.color.value = Vec3(0.27f);  // as bright as the background where no shadow falls
    Object ground = groundUnder(bounds);
    ground.material = static_cast<int>(scene->materials.size());
    scene->materials.push_back(std::move(material));
    scene->objects.push_back(std::move(ground));
}

bool hasStudio(const SceneDescription& scene) { return std::ranges::any_of(scene.objects, isGround); }

void removeStudio(SceneDescription* scene) {
    std::erase_if(scene->objects, isGround);
    scene->environment = {.color = Vec3(1.0f)};
}

}  // namespace glint
