// Sheets that let light through diffusely, against closed forms, in both integrators.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/render_scene.h"
#include "tests/support/sppm_render.h"

namespace glint::test {
namespace {

const Vec3 kReflected(0.3f, 0.2f, 0.6f), kPassed(0.5f, 0.7f, 0.1f);

/// The middle of a square sheet, seen along -z, under a directional light of irradiance 1.
SceneDescription sheetUnder(const Vec3& lightDirection) {
    SceneDescription scene = emptyScene({0, 0, 2}, {0, 0, 0}, 40.0f, 16);
    scene.camera.kind = ProjectionKind::Orthographic;
    scene.camera.viewHeight = 0.4f;
    scene.options.maxDepth = 1;
    Material sheet = diffuseMaterial(kReflected);
    sheet.kind = MaterialKind::Translucent;
    sheet.transmission.value = kPassed;
    addObject(&scene, ShapeKind::Rectangle, {}, sheet);
    scene.lights.push_back(directionalLight(lightDirection));
    return scene;
}

Vec3 meanOf(const std::vector<Vec3>& image) {
    Vec3 sum(0.0f);
    for (const Vec3& pixel : image) {
        sum += pixel;
    }
    return sum / static_cast<float>(image.size());
}

TEST(Translucent, BothSidesReflectAndLetThrough) {
    for (const bool isBehind : {false, true}) {
        const SceneDescription scene = sheetUnder({0, 0.6f, isBehind ? 0.8f : -0.8f});
        const Vec3 expected = (isBehind ? kPassed : kReflected) * (0.8f * kInvPi);
        SppmParams params;
        const Vec3 paths = meanOf(renderPaths(scene, 1, 1)),
                   sampled = meanOf(renderSppm(scene, params, 1).image);
        params.sampleDirectLight = false;
        params.photonsPerPass = 400000;
        const Vec3 photons = meanOf(renderSppm(scene, params, 10).image);
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(paths[c], expected[c], 1e-6f);
            EXPECT_NEAR(sampled[c], expected[c], 1e-6f);
            // About 30,000 photons land in the picture.
            EXPECT_NEAR(photons[c], expected[c], 0.03f * expected[c]) << (isBehind ? "behind" : "before");
        }
    }
}

/// What would reflect and pass more than all light lets less through.
TEST(Translucent, MakesNoLight) {
    SceneDescription scene = emptyScene({0, 0, 4}, {0, 0, 0}, 20.0f, 16);
    Material sheet = diffuseMaterial(0.7f);
    sheet.kind = MaterialKind::Translucent;
    sheet.transmission.value = Vec3(0.6f);
    addObject(&scene, ShapeKind::Sphere, {}, sheet);
    scene.environment.color = Vec3(0.5f);
    scene.options.maxDepth = 400;
    const Estimate furnace = meanLuminance(renderFilm(scene, 16));
    EXPECT_NEAR(furnace.mean, 0.5, kNormalQuantile * furnace.standardError + 1e-5);
    EXPECT_LT(furnace.standardError, 1e-2);
}

}  // namespace
}  // namespace glint::test
