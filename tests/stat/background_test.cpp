// An environment that is a background: rays from the camera see it, and it lights nothing, whichever
// integrator looks.
#include <gtest/gtest.h>

#include "engine/math/color.h"
#include "engine/scene/scene_use.h"
#include "tests/support/render_scene.h"
#include "tests/support/session_render.h"
#include "tests/support/test_scenes.h"

namespace glint::test {
namespace {

/// The upper half of the picture is sky, the lower half a floor.
SceneDescription floorUnderASky() {
    SceneDescription scene = emptyScene({0.0f, 1.0f, 6.0f}, {0.0f, 1.0f, 0.0f}, 40.0f, 32);
    scene.options.filterRadius = 0.5f;
    scene.options.filter = FilterKind::Box;
    scene.environment.color = Vec3(0.25f, 0.5f, 1.0f);
    addObject(&scene, ShapeKind::Plane, rotate({1, 0, 0}, -0.5f * kPi), diffuseMaterial(0.5f));
    return scene;
}

TEST(Background, IsSeenAndLightsNothing) {
    for (const IntegratorKind integrator : {IntegratorKind::PathTracing, IntegratorKind::Sppm}) {
        SceneDescription scene = floorUnderASky();
        scene.options.integrator = integrator;
        scene.sppm.photonsPerPass = 1000;
        const Film lit = renderSession(makeCpuBackend(2), scene, 4, 2).film;
        EXPECT_GT(meanLuminance(lit, 0, 20, 32, 32).mean, 0.1);
        scene.environment.seenOnly = true;
        const Film film = renderSession(makeCpuBackend(2), scene, 4, 2).film;
        EXPECT_EQ(meanLuminance(film, 0, 20, 32, 32).mean, 0.0);
        EXPECT_NEAR(meanLuminance(film, 0, 0, 32, 12).mean,
                    static_cast<double>(luminance(scene.environment.color)), 1e-5);
        EXPECT_EQ(meanLuminance(film, 0, 0, 32, 12).mean, meanLuminance(lit, 0, 0, 32, 12).mean);
    }
}

TEST(Background, IsNoLight) {
    SceneDescription scene = floorUnderASky();
    EXPECT_TRUE(hasLight(scene));
    scene.environment.seenOnly = true;
    EXPECT_FALSE(hasLight(scene));
}

}  // namespace
}  // namespace glint::test
