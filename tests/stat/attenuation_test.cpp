// What glass absorbs on the way inside, against closed forms: of straight ways exactly, behind boundaries
// within their noise. Each comparison at a significance of 1e-6.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/render_scene.h"
#include "tests/support/sppm_render.h"

namespace glint::test {
namespace {

Material glassOf(const Vec3& left, float distance, float ior) {
    Material glass = diffuseMaterial(1.0f);
    glass.kind = MaterialKind::Dielectric;
    glass.ior.value = ior;
    glass.attenuationColor = left;
    glass.attenuationDistance = distance;
    return glass;
}

/// Parallel rays along -z, 0.1 m a pixel, in the middle of each pixel, before an even white background.
SceneDescription straightScene() {
    SceneDescription scene = emptyScene({0, 0, 4}, {0, 0, 0}, 40.0f, 24);
    scene.camera.kind = ProjectionKind::Orthographic;
    scene.camera.viewHeight = 2.4f;
    scene.options.filterRadius = 0.001f;
    scene.options.rouletteStartDepth = 100;
    scene.options.maxDepth = 8;
    scene.environment.color = Vec3(1.0f);
    return scene;
}

void addBall(SceneDescription* scene, float radius, const Material& glass) {
    addObject(scene, ShapeKind::Sphere, scale(Vec3(radius)), glass);
}

/// How far the ray of a pixel goes inside a ball around the origin.
double chord(int x, int y, double radius) {
    const double off = std::hypot((x + 0.5) * 0.1 - 1.2, (y + 0.5) * 0.1 - 1.2);
    return off < radius ? 2.0 * std::sqrt(radius * radius - off * off) : 0.0;
}

/// The pictures of both integrators are exp(-sum of optical depths), wayOf(x, y) their sum for each channel.
template <class Way>
void expectLeft(const SceneDescription& scene, const Way& opticalDepth) {
    for (const auto& image : {renderPaths(scene, 1, 1), renderSppm(scene, {}, 1).image}) {
        for (int y = 0; y < 24; ++y) {
            for (int x = 0; x < 24; ++x) {
                const glm::dvec3 depth = opticalDepth(x, y);
                for (int c = 0; c < 3; ++c) {
                    // Pixels at a ball's rim see it change within a thousandth of a pixel.
                    EXPECT_NEAR(image[static_cast<size_t>(y * 24 + x)][c], std::exp(-depth[c]), 4e-3)
                        << x << " " << y << " channel " << c;
                }
            }
        }
    }
}

const Vec3 kLeft(0.5f, 0.125f, 1.0f);
const glm::dvec3 kPerMetre = -glm::log(glm::dvec3(kLeft)) / 0.7;

TEST(Attenuation, FollowsTheWayInside) {
    SceneDescription scene = straightScene();
    addBall(&scene, 1.0f, glassOf(kLeft, 0.7f, 1.0f));
    expectLeft(scene, [](int x, int y) { return kPerMetre * chord(x, y, 1.0); });
}

TEST(Attenuation, TheGlassEnteredLastAbsorbs) {
    SceneDescription scene = straightScene();
    addBall(&scene, 1.0f, glassOf(kLeft, 0.7f, 1.0f));
    addBall(&scene, 0.8f, glassOf(Vec3(1.0f), 1.0f, 1.0f));
    addBall(&scene, 0.5f, glassOf(Vec3(0.25f, 1.0f, 0.5f), 2.0f, 1.0f));
    const glm::dvec3 inner = -glm::log(glm::dvec3(0.25, 1.0, 0.5)) / 2.0;
    expectLeft(scene, [&](int x, int y) {
        return kPerMetre * (chord(x, y, 1.0) - chord(x, y, 0.8)) + inner * chord(x, y, 0.5);
    });
}

TEST(Attenuation, CountsFromACameraWithinGlass) {
    SceneDescription scene = straightScene();
    scene.camera.position = {0, 0, 0};
    scene.camera.target = {0, 0, -1};
    addBall(&scene, 1.0f, glassOf(kLeft, 0.7f, 1.0f));
    expectLeft(scene, [](int x, int y) { return kPerMetre * 0.5 * chord(x, y, 1.0); });
}

TEST(Attenuation, ASheetAbsorbsNothing) {
    SceneDescription scene = straightScene();
    Material sheet = glassOf(kLeft, 0.7f, 1.0f);
    sheet.thin = true;
    addBall(&scene, 1.0f, sheet);
    expectLeft(scene, [](int, int) { return glm::dvec3(0.0); });
}

/// What a principled body lets pass is absorbed as in glass.
TEST(Attenuation, PrincipledBodiesAbsorb) {
    SceneDescription scene = straightScene();
    Material body = glassOf(kLeft, 0.7f, 1.0f);
    body.kind = MaterialKind::Principled;
    body.specularTransmission.value = 1.0f;
    addBall(&scene, 1.0f, body);
    expectLeft(scene, [](int x, int y) { return kPerMetre * chord(x, y, 1.0); });
    body.thin = true;
    scene.objects.clear();
    addBall(&scene, 1.0f, body);
    expectLeft(scene, [](int, int) { return glm::dvec3(0.0); });
}

/// A slab of index 1.5, 0.3 m thick, square to the rays: each boundary reflects 0.04.
constexpr double kReflected = 0.04, kThick = 0.3, kSigma = 2.0;

void addSlab(SceneDescription* scene, const Vec3& lo, const Vec3& hi) {
    MeshData box;
    addBox(&box, lo, hi, false);
    addMeshObject(
        scene, std::move(box), {},
        glassOf(Vec3(static_cast<float>(std::exp(-kSigma * kThick))), static_cast<float>(kThick), 1.5f));
}

TEST(Attenuation, ASlabReflectsAndPassesWhatFresnelAndBeerSay) {
    SceneDescription scene = straightScene();
    addSlab(&scene, {-20, -20, -0.3f}, {20, 20, 0});
    const double a = std::exp(-kSigma * kThick), t = (1.0 - kReflected) * (1.0 - kReflected) * a;
    const double loop = 1.0 / (1.0 - kReflected * kReflected * a * a);
    const double once = kReflected + t, all = kReflected + t * kReflected * a * loop + t * loop;
    for (const auto& [depth, expected] : {std::pair{2, once}, std::pair{40, all}}) {
        scene.options.maxDepth = depth;
        const Estimate found = meanLuminance(renderFilm(scene, 256));
        EXPECT_LT(found.standardError, 1e-3);
        EXPECT_NEAR(found.mean, expected, kNormalQuantile * found.standardError + 1e-5) << depth;
    }
}

/// A lamp behind the slab lights a floor, which photons alone can tell: seen from between the two.
TEST(Attenuation, PhotonsAreTheAdjoint) {
    SceneDescription scene = emptyScene({0, -0.1f, 0}, {0, -1, 0}, 40.0f, 32);
    scene.camera.kind = ProjectionKind::Orthographic;
    scene.camera.viewHeight = 0.5f;
    scene.options.maxDepth = 3;
    addSlab(&scene, {-1, 0, -1}, {1, 0.3f, 1});
    addObject(&scene, ShapeKind::Rectangle, placeFlatShape({0, -1, 0}, {0, 1, 0}, 1, 1),
              diffuseMaterial(0.5f));
    scene.lights.push_back(directionalLight({0, -1, 0}));
    SppmParams params;
    params.photonsPerPass = 40000;
    RunningMean mean;
    for (uint32_t seed = 1; seed <= 12; ++seed) {
        params.pass.seed = seed;
        mean.add(blockMean(renderSppm(scene, params, 12).image, 32, 0, 0, 32));
    }
    const double expected = 0.5 / M_PI * (1.0 - kReflected) * (1.0 - kReflected) * std::exp(-kSigma * kThick);
    EXPECT_LT(mean.standardError(), 0.01 * expected);
    constexpr double kStudentQuantile = 9.0;  // t(11), two-sided at 2e-6
    EXPECT_NEAR(mean.mean(), expected, kStudentQuantile * mean.standardError());
}

/// A lamp inside rough glass: sampled light is absorbed as light is that a path runs into.
TEST(Attenuation, SampledLightIsAbsorbedAlike) {
    SceneDescription scene = emptyScene({0, 0, 5}, {0, 0, 0}, 30.0f, 32);
    Material rough = glassOf(Vec3(0.2f), 0.5f, 1.3f);
    rough.roughness.value = 0.4f;
    addBall(&scene, 1.0f, rough);
    addObject(&scene, ShapeKind::Rectangle, placeFlatShape({0.2f, 0.1f, -0.1f}, {0.3f, 0.4f, 1}, 0.4f, 0.3f),
              emissiveMaterial(Vec3(2.0f), true));
    scene.options.maxDepth = 6;
    const Estimate both = meanLuminance(renderFilm(scene, 128, DirectLightTag::Mis));
    const Estimate paths = meanLuminance(renderFilm(scene, 512, DirectLightTag::BsdfOnly));
    EXPECT_TRUE(agree(both, paths, 1e-3)) << both.mean << " and " << paths.mean;
    EXPECT_LT(paths.standardError, 0.02 * paths.mean);
}

}  // namespace
}  // namespace glint::test
