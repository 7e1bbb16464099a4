// Ambient occlusion against closed forms; the same bits for any number of threads and over a checkpoint.
#include <cmath>

#include <gtest/gtest.h>

#include "engine/render/checkpoint.h"
#include "engine/scene/scene_building.h"
#include "tests/support/film_bits.h"
#include "tests/support/render_scene.h"
#include "tests/support/session_render.h"
#include "tests/support/temp_folder.h"
#include "tests/support/test_scenes.h"

namespace glint::test {
namespace {

SessionCapture renderTo(uint32_t passes, SceneDescription scene, int threads = 2,
                        std::optional<ResumePoint> from = {}) {
    scene.options.integrator = IntegratorKind::AmbientOcclusion;
    return renderSession(makeCpuBackend(threads), scene, passes, threads, std::move(from));
}

void addPlane(SceneDescription* scene, const Vec3& normal) {
    addObject(scene, ShapeKind::Plane, placeFlatShape(Vec3(0.0f), normal, 1.0f, 1.0f), diffuseMaterial(0.5f));
}

/// A camera that sees all but one place: the floor at (3, 3, 0).
SceneDescription overTheFloor() {
    SceneDescription scene = emptyScene({3.0f, 3.0f, 5.0f}, {3.0f, 3.0f, 0.0f}, 0.01f, 16);
    addPlane(&scene, {0.0f, 0.0f, 1.0f});
    return scene;
}

/// So small that they shade nothing, and so far apart that the automatic radius is 10.
void addFarMarkers(SceneDescription* scene) {
    for (const float y : {-50.0f, 50.0f}) {
        Affine place;
        place.linear = Mat3(1e-3f);
        place.translation = Vec3(20.0f, y, 20.0f);
        addObject(scene, ShapeKind::Sphere, place, diffuseMaterial(0.5f));
    }
}

/// A ray's direction over the floor, seen from above, is uniform in the unit disc. It meets a wall at a
/// distance of c radii when it goes c towards it: this part of the disc.
double blockedByWall(double c) { return (std::acos(c) - c * std::sqrt(1.0 - c * c)) / 3.14159265358979324; }

void expectMean(const SceneDescription& scene, double expected) {
    const Estimate seen = meanLuminance(renderTo(256, scene).film);
    EXPECT_TRUE(agree(seen, {expected, 0.0})) << seen.mean << " +- " << seen.standardError;
}

TEST(AmbientOcclusion, AnOpenPlaneIsWhite) {
    const SessionCapture capture = renderTo(8, overTheFloor());
    for (const FilmPixel& pixel : capture.film.pixels()) {
        ASSERT_EQ(pixel.mean[1], 1.0);
    }
}

TEST(AmbientOcclusion, AClosedBoxIsBlackInside) {
    SceneDescription scene = emptyScene({0.1f, 0.2f, 0.3f}, {1.0f, 0.2f, 0.3f}, 90.0f, 16);
    for (int axis = 0; axis < 3; ++axis) {
        for (const float side : {-1.0f, 1.0f}) {
            Vec3 out(0.0f);
            out[axis] = side;
            addObject(&scene, ShapeKind::Rectangle, placeFlatShape(out, -out, 1.0f, 1.0f),
                      diffuseMaterial(0.5f));
        }
    }
    addFarMarkers(&scene);
    const SessionCapture capture = renderTo(8, scene);
    for (const FilmPixel& pixel : capture.film.pixels()) {
        ASSERT_EQ(pixel.mean[1], 0.0);
    }
}

TEST(AmbientOcclusion, WallsWithoutEndTakeHalfOfWhatTheyStandOver) {
    SceneDescription scene = overTheFloor();
    addPlane(&scene, {1.0f, 0.0f, 0.0f});
    expectMean(scene, 0.5);
    addPlane(&scene, {0.0f, 1.0f, 0.0f});
    expectMean(scene, 0.25);
}

TEST(AmbientOcclusion, TheRadiusIsATenthOfTheScenesSize) {
    SceneDescription scene = overTheFloor();
    addFarMarkers(&scene);
    addPlane(&scene, {1.0f, 0.0f, 0.0f});
    expectMean(scene, 1.0 - blockedByWall(0.3));
}

TEST(AmbientOcclusion, NothingIsBlack) {
    const SceneDescription scene = emptyScene({0.0f, 0.0f, 5.0f}, {0.0f, 0.0f, 0.0f}, 30.0f, 8);
    EXPECT_EQ(meanLuminance(renderTo(2, scene).film).mean, 0.0);
}

TEST(AmbientOcclusion, HasTheSameBitsForAnyNumberOfThreads) {
    const SceneDescription scene = cornellBox();
    const SessionCapture one = renderTo(3, scene, 1);
    EXPECT_GT(meanLuminance(one.film).mean, 0.1);
    expectSameBits(one.film, renderTo(3, scene, 2).film);
    expectSameBits(one.film, renderTo(3, scene, 3).film);
}

TEST(AmbientOcclusion, GoesOnFromACheckpointToTheLastBit) {
    SceneDescription scene = cornellBox();
    scene.options.integrator = IntegratorKind::AmbientOcclusion;
    const TempFolder folder;
    const std::string path = folder.path("half.checkpoint");
    ASSERT_TRUE(saveCheckpoint(path, renderTo(3, scene)));
    Result<ResumePoint> half = loadCheckpoint(path, scene);
    ASSERT_TRUE(half) << half.error().format();
    expectSameBits(renderTo(6, scene, 1, std::move(*half)).film, renderTo(6, scene).film);
}

}  // namespace
}  // namespace glint::test
