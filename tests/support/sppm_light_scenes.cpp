// Those of sppm_scenes.h that are lit through something: a picture, a portal.
#include <cmath>

#include "engine/math/equal_area.h"
#include "engine/scene/scene_building.h"
#include "tests/support/relief_scenes.h"
#include "tests/support/sppm_scenes.h"
#include "tests/support/test_scenes.h"

namespace glint::test {

SceneDescription projectorBox() {
    SceneDescription scene = small(cornellBox());
    for (Material& material : scene.materials) {
        material.emission.value = Vec3(0.0f);
    }
    std::erase_if(scene.objects, [](const Object& object) { return object.shape == ShapeKind::Sphere; });
    Light light;
    light.kind = LightKind::Projector;
    light.position = {0.1f, 1.7f, 0.95f};
    light.direction = {0.0f, -0.5f, -1.0f};
    light.strength = 6.0f;
    light.fovDeg = 110.0f;
    light.aspect = 1.25f;
    light.image.texture = addTexture(&scene, greyImage(16, 16, [](int x, int y) {
        const float u = (static_cast<float>(x) + 0.5f) / 16.0f, v = (static_cast<float>(y) + 0.5f) / 16.0f;
        return square(std::sin(kPi * u) * std::sin(kPi * v)) * (0.2f + u);
    }));
    scene.textures.back().wrapU = scene.textures.back().wrapV = WrapMode::Clamp;
    scene.lights.push_back(light);
    return scene;
}

SceneDescription goniometricBox() {
    SceneDescription scene = projectorBox();
    Light& light = scene.lights[0];
    light.kind = LightKind::Goniometric;
    light.position = {0.1f, 1.1f, 0.1f};
    light.direction = {0.3f, -1.0f, -0.4f};
    light.strength = 2.0f;
    scene.textures[0].image.floats = greyImage(64, 64, [](int x, int y) {
        const Vec3 d = equalAreaDirection(
            Vec2((static_cast<float>(x) + 0.5f) / 64.0f, (static_cast<float>(y) + 0.5f) / 64.0f));
        return 0.2f + 0.6f * square(maxf(d.z, 0.0f)) + 0.2f * d.x;
    });
    return scene;
}

SceneDescription portalBox() {
    SceneDescription scene = small(cornellBox());
    std::erase_if(scene.objects, [](const Object& object) {
        return object.shape == ShapeKind::Sphere || object.objectToWorld.translation.y > 1.9f;
    });
    const int white = addMaterial(&scene, diffuseMaterial(0.7f));
    const Vec3 down(0.0f, -1.0f, 0.0f);
    for (const float side : {-0.75f, 0.75f}) {
        addObject(&scene, ShapeKind::Rectangle, placeFlatShape({side, 2.0f, 0.0f}, down, 0.25f, 1.0f), white);
        addObject(&scene, ShapeKind::Rectangle, placeFlatShape({0.0f, 2.0f, side}, down, 0.5f, 0.25f), white);
    }
    addObject(&scene, ShapeKind::Disc, placeFlatShape({0.2f, 2.8f, 0.1f}, down, 0.4f, 0.4f),
              diffuseMaterial(0.0f));
    auto sky = std::make_shared<ImageF>(ImageF{32, 16, {}});
    for (int i = 0; i < 32 * 16; ++i) {
        const float around = (static_cast<float>(i % 32) + 0.5f) / 32.0f * kTwoPi;
        const float light = 2.0f + 1.5f * std::sin(around) + (i / 32 == 3 && i % 32 > 20 ? 20.0f : 0.0f);
        sky->rgb.insert(sky->rgb.end(), {light, 0.8f * light, 0.6f * light});
    }
    scene.environmentImages.push_back({.floats = sky});
    scene.environment.image = 0;
    scene.environment.color = Vec3(3.0f);
    scene.environment.rotationDeg = 40.0f;
    // Counter-clockwise from below.
    scene.environment.portal = {
        {-0.5f, 2.001f, -0.5f}, {0.5f, 2.001f, -0.5f}, {0.5f, 2.001f, 0.5f}, {-0.5f, 2.001f, 0.5f}};
    return scene;
}

}  // namespace glint::test
