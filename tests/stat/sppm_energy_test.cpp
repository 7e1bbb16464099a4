// Photons' power: what lights send out is what their formulas say, and all of it is absorbed or escapes.
//
// The balance holds photon by photon on average: power emitted, minus what escaped, minus what surfaces of
// one known albedo absorbed of every photon that reached them. Each at a significance of 1e-6 (statistics.h).
#include <cmath>

#include <gtest/gtest.h>

#include "engine/builders/power_distribution.h"
#include "engine/builders/scene_builder.h"
#include "engine/kernels/sppm_photon_kernel.h"
#include "engine/math/color.h"
#include "engine/render/pass_params.h"
#include "tests/support/sppm_render.h"
#include "tests/support/statistics.h"

namespace glint::test {
namespace {

/// One light inside a closed diffuse sphere.
SceneDescription closedSphere(const Material& emitterMaterial, ShapeKind emitterShape,
                              const Affine& emitterTransform) {
    SceneDescription scene;
    scene.resolution = {8, 8};
    scene.options.maxDepth = 64;
    Material wall;
    wall.name = "wall";
    wall.color.value = Vec3(0.6f);
    scene.materials = {wall, emitterMaterial};
    Object shell;
    shell.shape = ShapeKind::Sphere;
    shell.objectToWorld = scale(Vec3(3.0f));
    scene.objects.push_back(shell);
    Object emitter;
    emitter.shape = emitterShape;
    emitter.material = 1;
    emitter.objectToWorld = emitterTransform;
    scene.objects.push_back(emitter);
    scene.camera.position = Vec3(0, 0, 2.5f);
    scene.camera.target = Vec3(0.0f);
    return scene;
}

struct EnergyCase {
    const char* name;
    ShapeKind shape;
    bool bothSides;
    Affine transform;
    double power;  ///< luminance, W
};

class PhotonEnergy : public testing::TestWithParam<EnergyCase> {};

TEST_P(PhotonEnergy, EmittedPowerIsTheEmittersAndNothingEscapes) {
    const EnergyCase& emitterCase = GetParam();
    Material emitter;
    emitter.name = "lamp";
    emitter.color.value = Vec3(0.0f);
    emitter.emission.value = Vec3(2.0f);
    emitter.emitsBothSides = emitterCase.bothSides;
    SppmParams params;
    params.photonsPerPass = 50000;
    const SppmRender render =
        renderSppm(closedSphere(emitter, emitterCase.shape, emitterCase.transform), params, 1);
    EXPECT_NEAR(render.lastPass.photons.emitted / params.photonsPerPass, emitterCase.power,
                0.01 * emitterCase.power);
    EXPECT_EQ(render.lastPass.photons.escaped, 0.0);
    EXPECT_EQ(render.lastPass.photons.faulty, 0u);
}

INSTANTIATE_TEST_SUITE_P(
    Emitters, PhotonEnergy,
    testing::Values(EnergyCase{"Sphere", ShapeKind::Sphere, false, scale(Vec3(0.5f)),
                               2.0 * kPiD * 4.0 * kPiD * 0.25},
                    EnergyCase{"Rectangle", ShapeKind::Rectangle, false, scale(Vec3(0.5f, 0.25f, 1.0f)),
                               2.0 * kPiD * 0.5},
                    EnergyCase{"RectangleBothSides", ShapeKind::Rectangle, true, scale(Vec3(0.5f)),
                               2.0 * 2.0 * kPiD * 1.0},
                    EnergyCase{"Disc", ShapeKind::Disc, false, scale(Vec3(0.5f)), 2.0 * kPiD* kPiD * 0.25},
                    // A prolate spheroid with half axes 0.4, 0.4, 0.8: area 2 pi a^2 (1 + c / (a e) asin e),
                    // e^2 = 1 - a^2 / c^2.
                    EnergyCase{"Ellipsoid", ShapeKind::Sphere, false, scale(Vec3(0.4f, 0.4f, 0.8f)),
                               2.0 * kPiD * 2.0 * kPiD * 0.16 *
                                   (1.0 + 2.0 / std::sqrt(0.75) * std::asin(std::sqrt(0.75)))}),
    [](const auto& emitterCase) { return emitterCase.param.name; });

TEST(PhotonEnergyOf, PointSpotDirectionalAndEnvironment) {
    Material dark;
    dark.name = "dark";
    dark.color.value = Vec3(0.0f);
    SppmParams params;
    params.photonsPerPass = 50000;
    const SceneDescription empty = closedSphere(dark, ShapeKind::Sphere, scale(Vec3(0.1f)));
    SceneDescription scene = empty;
    scene.lights = {Light{}};
    scene.lights[0].position = Vec3(0.0f, 1.0f, 0.0f);
    const double point = renderSppm(scene, params, 1).lastPass.photons.emitted / params.photonsPerPass;
    EXPECT_NEAR(point, 4.0 * kPiD, 1e-3);
    scene.lights[0].kind = LightKind::Spot;
    scene.lights[0].coneAngleDeg = 60.0f;
    scene.lights[0].coneFalloffStartDeg = 60.0f;
    const double spot = renderSppm(scene, params, 1).lastPass.photons.emitted / params.photonsPerPass;
    EXPECT_NEAR(spot, 2.0 * kPiD * 0.5, 0.01);

    // From outside: all photons of the bounding disc arrive on the shell or miss it.
    scene.lights[0].kind = LightKind::Directional;
    const SppmPassStats directional = renderSppm(scene, params, 1).lastPass;
    EXPECT_GE(directional.photons.emitted / params.photonsPerPass, kPiD * 9.0 * 0.99)
        << "the disc covers the shell";
    scene.lights.clear();
    scene.environment.color = Vec3(0.5f);
    const SppmPassStats environment = renderSppm(scene, params, 1).lastPass;
    EXPECT_NEAR(environment.photons.emitted / directional.photons.emitted, 0.5 * 4.0 * kPiD, 0.02)
        << "L * 4 pi over the same disc as one unit of irradiance";
}

constexpr float kAlbedo = 0.6f;

/// A floor and a ball, grey all over, under the sky.
SceneDescription openScene() {
    SceneDescription scene;
    scene.resolution = {8, 8};
    scene.options.maxDepth = 48;
    Material grey;
    grey.name = "grey";
    grey.color.value = Vec3(kAlbedo);
    scene.materials = {grey, grey};
    scene.materials[1].name = "lamp";
    Object floor;
    floor.shape = ShapeKind::Rectangle;
    floor.objectToWorld = scale(Vec3(2.0f));
    scene.objects.push_back(floor);
    Object sphere;
    sphere.shape = ShapeKind::Sphere;
    sphere.objectToWorld = translate(Vec3(0.8f, 0.0f, 0.5f)) * scale(Vec3(0.5f));
    scene.objects.push_back(sphere);
    scene.camera.position = Vec3(0.0f, -4.0f, 2.0f);
    scene.camera.target = Vec3(0.0f);
    return scene;
}

SceneDescription openSceneWithEmitter(ShapeKind shape, const Affine& transform, bool bothSides) {
    SceneDescription scene = openScene();
    scene.materials[1].emission.value = Vec3(2.0f);
    scene.materials[1].emitsBothSides = bothSides;
    Object emitter;
    emitter.shape = shape;
    emitter.material = 1;
    emitter.objectToWorld = transform;
    scene.objects.push_back(emitter);
    return scene;
}

SceneDescription openSceneWithLight(LightKind kind) {
    SceneDescription scene = openScene();
    scene.lights = {Light{}};
    scene.lights[0].kind = kind;
    scene.lights[0].position = Vec3(-0.5f, 0.0f, 1.5f);
    scene.lights[0].direction = Vec3(0.2f, 0.1f, -1.0f);
    return scene;
}

/// Two triangles that shine down.
SceneDescription openSceneWithMeshEmitter() {
    auto mesh = std::make_shared<MeshData>();
    mesh->positions = {{-0.5f, -0.5f, 1.5f}, {0.5f, -0.5f, 1.5f}, {0.5f, 0.5f, 1.8f}, {-0.5f, 0.5f, 1.5f}};
    mesh->indices = {0, 2, 1, 0, 3, 2};
    SceneDescription scene = openSceneWithEmitter(ShapeKind::Mesh, Affine{}, false);
    scene.objects.back().mesh = 0;
    Mesh named;
    named.name = "lamp";
    named.data = mesh;
    scene.meshes = {named};
    return scene;
}

SceneDescription openSceneWithSky() {
    SceneDescription scene = openScene();
    scene.environment.color = Vec3(0.5f);
    return scene;
}

struct BalanceCase {
    const char* name;
    SceneDescription scene;
};

class PhotonBalance : public testing::TestWithParam<BalanceCase> {};

TEST_P(PhotonBalance, EmittedPowerIsAbsorbedOrEscapes) {
    const SceneEdit edit{std::make_shared<const SceneDescription>(GetParam().scene), EditKind::Everything};
    BuildReport report;
    const auto built = buildScene(edit, nullptr, 0, nullptr, &report);
    ASSERT_TRUE(built) << built.error().format();
    const SceneView view = (*built)->view();
    const PowerDistribution power = buildPowerDistribution(view);
    SppmParams params;
    params.pass = passParamsOf(GetParam().scene);
    params.sampleDirectLight = false;
    RunningMean emitted, missing, escaped;
    for (uint64_t number = 0; number < 40000; ++number) {
        double reached = 0.0;
        const PhotonTally tally = tracePhoton<kAllFeatures>(
            view, power.view(), params, number,
            [&](const Photon& photon) { reached += static_cast<double>(luminance(photon.flux)); });
        ASSERT_FALSE(tally.faulty);
        const double absorbed = reached * (1.0 - static_cast<double>(kAlbedo));
        emitted.add(static_cast<double>(tally.emitted));
        escaped.add(static_cast<double>(tally.escaped));
        missing.add(static_cast<double>(tally.emitted) - static_cast<double>(tally.escaped) - absorbed);
    }
    EXPECT_LE(std::fabs(missing.mean()), kNormalQuantile * missing.standardError());
    EXPECT_LE(missing.standardError(), 0.01 * emitted.mean()) << "too noisy to tell";
    EXPECT_GT(escaped.mean(), 0.0);
    EXPECT_LT(escaped.mean(), 0.99 * emitted.mean());
}

const Affine kOverhead = translate(Vec3(0.0f, 0.0f, 1.6f)) * rotate(Vec3(1, 0, 0), 3.0f);

INSTANTIATE_TEST_SUITE_P(
    Lights, PhotonBalance,
    testing::Values(
        BalanceCase{"Rectangle",
                    openSceneWithEmitter(ShapeKind::Rectangle, kOverhead* scale(Vec3(0.4f)), false)},
        BalanceCase{"RectangleBothSides",
                    openSceneWithEmitter(ShapeKind::Rectangle, kOverhead* scale(Vec3(0.4f)), true)},
        BalanceCase{"Disc", openSceneWithEmitter(ShapeKind::Disc, kOverhead* scale(Vec3(0.4f)), false)},
        BalanceCase{"Sphere", openSceneWithEmitter(ShapeKind::Sphere, kOverhead* scale(Vec3(0.3f)), false)},
        BalanceCase{"Ellipsoid",
                    openSceneWithEmitter(ShapeKind::Sphere, kOverhead* scale(Vec3(0.2f, 0.3f, 0.5f)), false)},
        BalanceCase{"Mesh", openSceneWithMeshEmitter()},
        BalanceCase{"Point", openSceneWithLight(LightKind::Point)},
        BalanceCase{"Spot", openSceneWithLight(LightKind::Spot)},
        BalanceCase{"Directional", openSceneWithLight(LightKind::Directional)},
        BalanceCase{"Environment", openSceneWithSky()}),
    [](const auto& balanceCase) { return balanceCase.param.name; });

}  // namespace
}  // namespace glint::test
