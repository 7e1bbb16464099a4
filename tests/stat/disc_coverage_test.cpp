// What edges cut off the discs around visible points, and what is left of the bias: closed forms, and
// path tracing.
//
// Means over independent seeds, against truths: Student's t with 15 degrees of freedom, two-sided at 1e-6.
#include "engine/kernels/disc_coverage.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "engine/math/color.h"
#include "engine/scene/scene_building.h"
#include "tests/support/sppm_render.h"
#include "tests/support/sppm_scenes.h"
#include "tests/support/statistics.h"
#include "tests/support/test_scenes.h"

namespace glint::test {
namespace {

constexpr uint32_t kSeeds = 16;
constexpr double kStudentQuantile = 8.0;
constexpr uint32_t kPasses = 48;
constexpr float kRadius = 0.2f;

TEST(CoverageFactor, IsOneToTheLastBitUnlessSomethingIsMissing) {
    SppmPixel pixel;
    EXPECT_EQ(coverageFactor(pixel), 1.0);
    pixel.probes = pixel.covered = 8.0f;
    EXPECT_EQ(coverageFactor(pixel), 1.0);
    pixel.probes = 99.0f;
    pixel.covered = 49.0f;
    EXPECT_EQ(coverageFactor(pixel), 2.0);
    pixel.covered = 0.0f;
    EXPECT_EQ(coverageFactor(pixel), 8.0);
}

/// Mean luminances of all seeds, and the statistics of the last one.
struct Measured {
    RunningMean luminance;
    SppmState state;
};

/// A few pixels around `seen` from a camera at `from`, with photons of the light alone.
Measured measure(SceneDescription scene, const Vec3& from, const Vec3& seen) {
    scene.camera.position = from;
    scene.camera.target = seen;
    scene.options.maxDepth = 1;
    SppmParams params;
    params.photonsPerPass = 16000;
    params.radiusWorld = kRadius;
    params.sampleDirectLight = false;
    Measured measured;
    for (uint32_t seed = 1; seed <= kSeeds; ++seed) {
        params.pass.seed = seed;
        SppmRender render = renderSppm(scene, params, kPasses);
        measured.luminance.add(blockMean(render.image, 4, 0, 0, 4));
        measured.state = std::move(render.state);
    }
    return measured;
}

/// A floor of half size 1 under a sun at the zenith. Its radiance is kFloorRadiance.
SceneDescription litFloor() {
    SceneDescription scene = emptyScene({0, 1, 0}, {0, 0, 0}, 0.1f, 4);
    scene.camera.up = {0, 0, 1};
    addObject(&scene, ShapeKind::Rectangle, placeFlatShape(Vec3(0.0f), {0, 1, 0}, 1.0f, 1.0f),
              diffuseMaterial(0.5f));
    scene.lights.push_back(directionalLight({0, -1, 0}));
    return scene;
}
constexpr double kFloorRadiance = 0.5 / std::numbers::pi;

/// The radiance where discs are covered by this part, the prior of coverageFactor() included.
double radianceWith(double covered) {
    return kFloorRadiance * covered * (kPasses + 1.0) / (covered * kPasses + 1.0);
}

void expectRadiance(const Measured& measured, double expected, double slack) {
    EXPECT_NEAR(measured.luminance.mean(), expected,
                kStudentQuantile * measured.luminance.standardError() + slack * expected);
    EXPECT_LT(measured.luminance.standardError(), 0.01 * expected) << "too noisy to tell";
}

TEST(DiscCoverage, NothingIsMissingInside) {
    const Measured inside = measure(litFloor(), {0.1f, 1, 0.2f}, {0, 0, 0});
    for (const SppmPixel& pixel : inside.state.pixels) {
        EXPECT_EQ(pixel.probes, static_cast<float>(kProbingPasses));
        EXPECT_EQ(pixel.covered, pixel.probes);
    }
    expectRadiance(inside, kFloorRadiance, 0.001);
}

/// Two tiles, or four around a corner, with their fronts on either side in turn.
SceneDescription tiledFloor(bool isTurned) {
    SceneDescription scene = litFloor();
    scene.objects.clear();
    for (int i = 0; i < 4; ++i) {
        const float x = i % 2 == 0 ? -0.5f : 0.5f, z = i / 2 == 0 ? -0.5f : 0.5f;
        const float side = ((i % 2 == i / 2) != isTurned) ? 1.0f : -1.0f;
        addObject(&scene, ShapeKind::Rectangle, placeFlatShape({x, 0, z}, {0, side, 0}, 0.5f, 0.5f), 0);
    }
    return scene;
}

TEST(DiscCoverage, TilesWoundInOppositeWaysAreOneFloor) {
    for (const bool isTurned : {false, true}) {
        for (const Vec3& seen : {Vec3(0), Vec3(0.01f, 0, 0.5f)}) {
            const Measured seam = measure(tiledFloor(isTurned), seen + Vec3(0.1f, 1, 0.2f), seen);
            for (const SppmPixel& pixel : seam.state.pixels) {
                EXPECT_EQ(pixel.covered, pixel.probes);
            }
            expectRadiance(seam, kFloorRadiance, 0.001);
        }
    }
}

/// Light from both sides on a floor that is seen from one, with a tile under it that faces down.
TEST(DiscCoverage, SheetsBelowAndLightFromBelowAddNothing) {
    SceneDescription scene = litFloor();
    scene.lights.push_back(directionalLight({0, 1, 0}));
    addObject(&scene, ShapeKind::Rectangle, placeFlatShape({0, -0.02f, 0}, {0, -1, 0}, 1.0f, 1.0f), 0);
    expectRadiance(measure(scene, {0.1f, 1, 0.2f}, {0, 0, 0}), kFloorRadiance, 0.001);
}

/// The bottom of a box stands on the floor, with its front on the other side.
TEST(DiscCoverage, ABoxOnAFloorIsNoTileOfIt) {
    SceneDescription scene = litFloor();
    const int black = addMaterial(&scene, diffuseMaterial(0.0f));
    addObject(&scene, ShapeKind::Rectangle, placeFlatShape({0.5f, 0, 0}, {0, -1, 0}, 0.5f, 0.5f), 0);
    addObject(&scene, ShapeKind::Rectangle, placeFlatShape({0.5f, 0.4f, 0}, {0, 1, 0}, 0.5f, 0.5f), black);
    addObject(&scene, ShapeKind::Rectangle, placeFlatShape({0, 0.2f, 0}, {-1, 0, 0}, 0.5f, 0.2f), black);
    const Measured beside = measure(scene, {-0.8f, 1, 0}, {-0.01f, 0, 0});
    expectRadiance(beside, kFloorRadiance, 0.02);
    for (const SppmPixel& pixel : beside.state.pixels) {
        EXPECT_LT(pixel.covered, 0.65f * pixel.probes);
    }
}

TEST(DiscCoverage, EdgesAndCornersAreAsBright) {
    expectRadiance(measure(litFloor(), {0.5f, 1, 0}, {0.998f, 0, 0}), radianceWith(0.51), 0.01);
    expectRadiance(measure(litFloor(), {0.5f, 1, 0.5f}, {0.998f, 0, 0.998f}), radianceWith(0.26), 0.02);
}

/// A wall of no thickness on the floor, which goes on behind it.
SceneDescription floorWithWall() {
    SceneDescription scene = litFloor();
    addObject(&scene, ShapeKind::Rectangle, placeFlatShape({0, 0.3f, 0}, {1, 0, 0}, 1.0f, 0.3f),
              diffuseMaterial(0.0f));
    return scene;
}

TEST(DiscCoverage, LightBehindAWallNeitherCountsNorIsMissed) {
    const Vec3 from(-0.8f, 1, 0), seen(-0.01f, 0, 0);
    const Measured lit = measure(floorWithWall(), from, seen);
    expectRadiance(lit, kFloorRadiance, 0.01);
    for (const SppmPixel& pixel : lit.state.pixels) {
        EXPECT_LT(pixel.covered, 0.65f * pixel.probes) << "the wall is seen";
    }
    SceneDescription dark = floorWithWall();
    addObject(&dark, ShapeKind::Rectangle, placeFlatShape({0.75f, 0.5f, 0}, {0, 1, 0}, 0.75f, 2.0f),
              diffuseMaterial(0.0f));
    // Passes before one misses look along one ray only, and find the wall every other time.
    expectRadiance(measure(dark, from, seen), radianceWith(0.52), 0.03);
}

TEST(DiscCoverage, BallsThatTheRadiusIsSmallerThanAreCoveredAllOver) {
    SceneDescription scene = litFloor();
    scene.objects.clear();
    addObject(&scene, ShapeKind::Sphere, scale(Vec3(2.0f * kRadius)), 0);
    const Measured top = measure(scene, {0.1f, 1.5f, 0}, {0, 2.0f * kRadius, 0});
    for (const SppmPixel& pixel : top.state.pixels) {
        EXPECT_EQ(pixel.covered, pixel.probes);
    }
}

/// Over the pixels at edges of a room: what the picture is too bright or dark by, and what the map says.
TEST(DiscCoverage, TheBiasMapTellsWhatIsLeftAtEdges) {
    SceneDescription scene = small(cornellBox());
    const std::vector<Vec3> paths = renderPaths(scene, 77, 2000);
    RunningMean truth, map, brightness;
    for (uint32_t seed = 1; seed <= kSeeds; ++seed) {
        SppmParams params;
        params.photonsPerPass = 8000;
        params.sampleDirectLight = false;
        params.pass.seed = seed;
        const SppmRender render = renderSppm(scene, params, 24);
        RunningMean ofPicture, ofMap;
        for (size_t i = 0; i < paths.size(); ++i) {
            const SppmPixel& pixel = render.state.pixels[i];
            if (!(pixel.covered < pixel.probes)) { continue; }
            ofPicture.add(static_cast<double>(luminance(render.image[i]) - luminance(paths[i])));
            ofMap.add(render.state.biasOf(i));
            brightness.add(static_cast<double>(luminance(paths[i])));
        }
        truth.add(ofPicture.mean());
        map.add(ofMap.mean());
    }
    const double slack = kStudentQuantile * std::hypot(truth.standardError(), map.standardError());
    EXPECT_LT(slack, 0.04 * brightness.mean()) << "too noisy to tell";
    EXPECT_NEAR(map.mean(), truth.mean(), slack + 0.01 * brightness.mean());
}

}  // namespace
}  // namespace glint::test
