// Light that glass takes apart: Snell's law at every wavelength, white that stays white, and photon mapping
// against path tracing.
#include <array>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "engine/builders/power_distribution.h"
#include "engine/kernels/bsdf/bsdf.h"
#include "engine/kernels/sppm_photon_kernel.h"
#include "engine/scene/glasses.h"
#include "tests/support/render_scene.h"
#include "tests/support/sppm_render.h"
#include "tests/support/statistics.h"
#include "tests/support/test_scenes.h"

namespace glint::test {
namespace {

Material glassOf(const char* name) {
    Material glass;
    glass.kind = MaterialKind::Dielectric;
    glass.color.value = Vec3(1.0f);
    glass.glass = name;
    return glass;
}

/// Snell's law for a unit direction that meets a surface whose normal is on its side; `ratio`: the index
/// before over the index behind it.
glm::dvec3 refracted(const glm::dvec3& direction, const glm::dvec3& normal, double ratio) {
    const double cosine = -glm::dot(direction, normal);
    const double cosineBehind = std::sqrt(1.0 - ratio * ratio * (1.0 - cosine * cosine));
    return ratio * direction + (ratio * cosine - cosineBehind) * normal;
}

/// An equilateral prism of flint glass within a diffuse ball, and a thin beam that meets one of its faces
/// about at least deviation.
SceneDescription prismInABall() {
    SceneDescription scene = emptyScene({0, 3, 0}, {0, 0, 0}, 40.0f, 8);
    scene.camera.up = {0, 0, 1};
    MeshData prism;
    const Vec3 a(-0.5f, -1, -0.2886751f), b(0.5f, -1, -0.2886751f), c(0, -1, 0.5773503f), up(0, 2, 0);
    addQuad(&prism, a, a + up, b + up, b);
    addQuad(&prism, b, b + up, c + up, c);
    addQuad(&prism, c, c + up, a + up, a);
    addMeshObject(&scene, prism, {}, glassOf("SF11"));
    addObject(&scene, ShapeKind::Sphere, scale(Vec3(200.0f)), diffuseMaterial(0.5f));
    const Vec3 middleOfFace(-0.25f, 0.0f, 0.1443376f);
    Light beam;
    beam.kind = LightKind::Spot;
    beam.position = middleOfFace - 20.0f * Vec3(0.837f, 0.0f, 0.547f);
    beam.direction = middleOfFace - beam.position;
    beam.coneAngleDeg = 0.4f;
    beam.coneFalloffStartDeg = 0.3f;
    beam.strength = 1e6f;
    scene.lights.push_back(beam);
    return scene;
}

TEST(DispersionRender, PhotonsBehindAPrismGoWhereSnellsLawSendsThem) {
    const auto built = buildAll(prismInABall());
    const SceneView view = built->view();
    SppmParams params = settledParams(view, {});
    params.pass.maxDepth = 3;
    ASSERT_TRUE(params.photonsKnowBand);
    const PhotonLayout layout = photonLayout(params);
    const GlassConstants glass = *findGlass("SF11");
    const PowerDistribution power = buildPowerDistribution(view);
    const glm::dvec3 left = glm::normalize(glm::dvec3(-0.8660254, 0.0, 0.5)), right(-left.x, 0.0, left.z);
    int counted = 0;
    for (uint64_t number = 0; number < 4000; ++number) {
        const Sampler sampler = makePhotonSampler(params.pass, number);
        const Wavelength drawn = wavelengthOf<kAllFeatures>(view, sampler);
        const EmittedPhoton emitted = emitPhoton<kAllFeatures>(
            view, power.view(), get1D<kAllFeatures>(sampler, dimension(EmissionDimension::Light)),
            get2D<kAllFeatures>(sampler, dimension(EmissionDimension::Point)),
            get2D<kAllFeatures>(sampler, dimension(EmissionDimension::Direction)));
        const double n = static_cast<double>(glass.ior + indexShift(glass.dispersion, drawn.nm));
        const glm::dvec3 inside = refracted(glm::normalize(glm::dvec3(emitted.ray.direction)), left, 1.0 / n);
        const glm::dvec3 expected = refracted(inside, -right, n);
        bool meetsBall = false;
        tracePhoton<kAllFeatures>(view, power.view(), params, number, [&](const Photon& photon) {
            // Two refractions; those that were reflected within leave through another face.
            const glm::dvec3 found(-layout.wi(photon));
            const bool isThird = std::exchange(meetsBall, true);
            if (isThird || layout.depth(photon) != 2 || glm::dot(found, expected) < 0.95) { return; }
            EXPECT_EQ(layout.band(photon), drawn.band);
            // Photons' directions have 16 bits for each of two numbers.
            EXPECT_LT(glm::length(found - expected), 1.5e-4) << drawn.nm;
            ++counted;
        });
    }
    EXPECT_GT(counted, 2000);
}

/// Mean of each channel over a ball that absorbs nothing, in an even white environment.
std::array<RunningMean, 3> furnace(const Material& glass) {
    SceneDescription scene = emptyScene({0, 0, 4}, {0, 0, 0}, 30.0f, 16);
    addObject(&scene, ShapeKind::Sphere, {}, glass);
    scene.environment.color = Vec3(1.0f);
    scene.options.maxDepth = 200;
    std::array<RunningMean, 3> channels;
    for (uint32_t seed = 1; seed <= 16; ++seed) {
        const std::vector<Vec3> image = renderPaths(scene, seed, 64);
        glm::dvec3 sum(0.0);
        for (const Vec3& pixel : image) {
            sum += glm::dvec3(pixel);
        }
        for (int c = 0; c < 3; ++c) {
            channels[static_cast<size_t>(c)].add(sum[c] / static_cast<double>(image.size()));
        }
    }
    return channels;
}

/// t(15), two-sided at 1e-3 / 6.
constexpr double kStudentQuantile = 4.9;

TEST(DispersionRender, WhiteStaysWhite) {
    for (const RunningMean& channel : furnace(glassOf("SF11"))) {
        EXPECT_NEAR(channel.mean(), 1.0, kStudentQuantile * channel.standardError() + 1e-6);
    }
    // Rough glass loses what bounces between facets, the more the higher its index: with dispersion
    // as without.
    Material rough = glassOf("SF11");
    rough.roughness.value = 0.3f;
    const auto dispersed = furnace(rough);
    rough.ior.value = findGlass("SF11")->ior;
    rough.glass.clear();
    const auto alike = furnace(rough);
    for (size_t c = 0; c < 3; ++c) {
        const double noise = std::hypot(dispersed[c].standardError(), alike[c].standardError());
        EXPECT_NEAR(dispersed[c].mean(), alike[c].mean(), kStudentQuantile * noise + 6e-3);
    }
}

}  // namespace
}  // namespace glint::test
