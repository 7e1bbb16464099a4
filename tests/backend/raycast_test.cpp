// Ray casting: Phong's formula at known pixels, shadows, falloff, the light from the camera; the same
// as path tracing of depth 1 where surfaces are diffuse; the same bits for any number of threads and
// over a checkpoint.
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

constexpr int kSize = 33;

SessionCapture renderTo(uint32_t passes, SceneDescription scene, int threads = 2,
                        std::optional<ResumePoint> from = {}) {
    scene.options.integrator = IntegratorKind::RayCast;
    return renderSession(makeCpuBackend(threads), scene, passes, threads, std::move(from));
}

glm::dvec3 pixelOf(const SessionCapture& capture, int x, int y) {
    const FilmPixel& pixel = capture.film.pixels()[static_cast<size_t>(y * kSize + x)];
    return {pixel.mean[0], pixel.mean[1], pixel.mean[2]};
}

void expectNear(const glm::dvec3& a, const glm::dvec3& b, double relative) {
    for (int channel = 0; channel < 3; ++channel) {
        EXPECT_NEAR(a[channel], b[channel], relative * std::max(1e-3, std::abs(b[channel])));
    }
}

/// Rays go through the middle of each pixel, to a thousandth of it.
SceneDescription seenThroughMiddles(const Vec3& from, const Vec3& to, float fovDeg) {
    SceneDescription scene = emptyScene(from, to, fovDeg, kSize);
    scene.options.filterRadius = 1e-3f;
    return scene;
}

const Vec3 kAlbedo(0.6f, 0.3f, 0.1f);
const Vec3 kSpecular(0.2f, 0.5f, 0.4f);
constexpr float kExponent = 12.0f;

Material shiny() {
    Material material = diffuseMaterial(kAlbedo);
    material.phongSpecular = kSpecular;
    material.phongExponent = kExponent;
    return material;
}

/// The unit sphere from (0, 0, 5), 30 degrees high.
SceneDescription shinyBall() {
    SceneDescription scene = seenThroughMiddles({0.0f, 0.0f, 5.0f}, Vec3(0.0f), 30.0f);
    addObject(&scene, ShapeKind::Sphere, Affine(), shiny());
    return scene;
}

/// Where the pixel's ray meets the ball, in double; false: nowhere.
bool meetBall(int x, int y, glm::dvec3* direction, glm::dvec3* normal) {
    const double scale = std::tan(15.0 * kPiD / 180.0) * 2.0 / kSize;
    *direction =
        glm::normalize(glm::dvec3((x + 0.5 - 0.5 * kSize) * scale, -(y + 0.5 - 0.5 * kSize) * scale, -1.0));
    const glm::dvec3 origin(0.0, 0.0, 5.0);
    const double b = glm::dot(origin, *direction);
    const double discriminant = b * b - 24.0;
    if (discriminant < 0.0) { return false; }
    *normal = origin + (-b - std::sqrt(discriminant)) * *direction;
    return true;
}

/// Phong's formula, for light of this irradiance.
glm::dvec3 phong(const glm::dvec3& direction, const glm::dvec3& normal, const glm::dvec3& toLight,
                 const glm::dvec3& irradiance) {
    const double cosine = glm::dot(normal, toLight);
    if (cosine <= 0.0) { return glm::dvec3(0.0); }
    const glm::dvec3 mirrored = 2.0 * cosine * normal - toLight;
    const double highlight = std::pow(std::max(0.0, -glm::dot(mirrored, direction)), double{kExponent});
    return (glm::dvec3(kAlbedo) * cosine + glm::dvec3(kSpecular) * highlight) * irradiance / kPiD;
}

TEST(RayCast, ADirectionalLightIsPhongsFormulaInEveryPixel) {
    SceneDescription scene = shinyBall();
    scene.environment.color = {0.1f, 0.2f, 0.3f};
    scene.rayCast.ambient = {0.05f, 0.1f, 0.2f};
    scene.lights.push_back(directionalLight({-1.0f, -2.0f, -2.0f}, {3.0f, 2.0f, 1.0f}));
    const SessionCapture capture = renderTo(1, scene);
    const glm::dvec3 ambient = glm::dvec3(kAlbedo) * glm::dvec3(scene.rayCast.ambient);
    int onBall = 0;
    for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) {
            SCOPED_TRACE(testing::Message() << x << ", " << y);
            glm::dvec3 direction, normal;
            if (!meetBall(x, y, &direction, &normal)) {
                expectNear(pixelOf(capture, x, y), glm::dvec3(scene.environment.color), 1e-6);
                continue;
            }
            if (-glm::dot(direction, normal) < 0.2) { continue; }  // the pixel's middle is not known so well
            ++onBall;
            expectNear(pixelOf(capture, x, y),
                       ambient + phong(direction, normal, {1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0}, {3.0, 2.0, 1.0}),
                       5e-3);
        }
    }
    EXPECT_GT(onBall, 400);
}

TEST(RayCast, WithoutALightOneShinesFromTheCamera) {
    const SessionCapture capture = renderTo(1, shinyBall());
    glm::dvec3 direction, normal;
    ASSERT_TRUE(meetBall(20, 12, &direction, &normal));
    expectNear(pixelOf(capture, 20, 12), phong(direction, normal, -direction, glm::dvec3(kPiD)), 5e-3);
}

/// A floor, a point light two above its middle, and a small ball between that and the pixel in the middle.
SceneDescription ballOverFloor() {
    SceneDescription scene = seenThroughMiddles({4.0f, 4.0f, 4.0f}, Vec3(0.0f), 20.0f);
    addObject(&scene, ShapeKind::Rectangle, placeFlatShape(Vec3(0.0f), {0.0f, 1.0f, 0.0f}, 8.0f, 8.0f),
              diffuseMaterial(0.5f));
    addObject(&scene, ShapeKind::Sphere, translate({0.0f, 1.8f, 0.0f}) * scale(Vec3(0.1f)),
              diffuseMaterial(0.5f));
    Light light;
    light.position = {0.0f, 2.0f, 0.0f};
    light.color = Vec3(6.0f);
    scene.lights.push_back(light);
    return scene;
}

TEST(RayCast, LightsCastShadowsOrNot) {
    SceneDescription scene = ballOverFloor();
    constexpr int kMiddle = kSize / 2;
    EXPECT_EQ(pixelOf(renderTo(1, scene), kMiddle, kMiddle).x, 0.0);
    scene.rayCast.shadows = false;
    // Intensity over distance squared, times albedo over pi.
    expectNear(pixelOf(renderTo(1, scene), kMiddle, kMiddle), glm::dvec3(6.0 / 4.0 * 0.5 / kPiD), 1e-3);
}

TEST(RayCast, WithoutFalloffALightShinesEverywhereAsAtTheMiddle) {
    SceneDescription scene = ballOverFloor();
    scene.rayCast.shadows = scene.rayCast.falloff = false;
    const SessionCapture capture = renderTo(1, scene);
    // What has an end reaches from the floor to the ball's top.
    const double atMiddle = 6.0 / ((2.0 - 0.95) * (2.0 - 0.95));
    constexpr int kMiddle = kSize / 2;
    expectNear(pixelOf(capture, kMiddle, kMiddle), glm::dvec3(atMiddle * 0.5 / kPiD), 1e-3);
}

TEST(RayCast, OfDiffuseSurfacesItIsPathTracingOfDepthOne) {
    SceneDescription scene = ballOverFloor();
    scene.options.filterRadius = 0.5f;
    scene.options.maxDepth = 1;
    scene.lights.push_back(directionalLight({1.0f, -3.0f, 0.5f}, Vec3(0.7f)));
    Light spot = scene.lights[0];
    spot.kind = LightKind::Spot;
    spot.position = {2.0f, 3.0f, 1.0f};
    scene.lights.push_back(spot);
    const SessionCapture cast = renderTo(64, scene);
    const SessionCapture traced = renderSession(makeCpuBackend(2), scene, 64, 2);
    const Estimate exact = meanLuminance(cast.film);
    EXPECT_GT(exact.mean, 0.05);
    EXPECT_TRUE(agree(meanLuminance(traced.film), {exact.mean, 0.0}));
}

TEST(RayCast, HasLightsThatAreForItAlone) {
    SceneDescription scene = ballOverFloor();
    scene.rayCast.shadows = false;
    const SessionCapture all = renderTo(1, scene);
    scene.lights[0].onlyRayCast = true;
    expectSameBits(all.film, renderTo(1, scene).film);
    EXPECT_EQ(meanLuminance(renderSession(makeCpuBackend(2), scene, 4, 2).film).mean, 0.0);
}

TEST(RayCast, MirrorsGlassLampsAndTexturesShowTheirColours) {
    for (const SceneDescription& scene : {allMaterials(), texturedInputs(), emitterShapes()}) {
        const SessionCapture capture = renderTo(1, scene);
        EXPECT_GT(meanLuminance(capture.film).mean, 0.05) << scene.title;
        EXPECT_EQ(capture.film.faultCounts()[1] + capture.film.faultCounts()[2], 0u);
    }
}

TEST(RayCast, HasTheSameBitsForAnyNumberOfThreads) {
    const SessionCapture one = renderTo(3, cornellBox(), 1);
    expectSameBits(one.film, renderTo(3, cornellBox(), 2).film);
    expectSameBits(one.film, renderTo(3, cornellBox(), 3).film);
}

TEST(RayCast, GoesOnFromACheckpointOfTheSameHighlightsOnly) {
    SceneDescription scene = shinyBall();
    scene.options.integrator = IntegratorKind::RayCast;
    const TempFolder folder;
    const std::string path = folder.path("half.checkpoint");
    ASSERT_TRUE(saveCheckpoint(path, renderTo(3, scene)));
    Result<ResumePoint> half = loadCheckpoint(path, scene);
    ASSERT_TRUE(half) << half.error().format();
    expectSameBits(renderTo(6, scene, 1, std::move(*half)).film, renderTo(6, scene).film);
    scene.materials[0].phongExponent = 3.0f;
    EXPECT_FALSE(loadCheckpoint(path, scene));
    scene = shinyBall();
    scene.options.integrator = IntegratorKind::RayCast;
    scene.rayCast.shadows = false;
    EXPECT_FALSE(loadCheckpoint(path, scene));
}

}  // namespace
}  // namespace glint::test
