// Photons scatter as the adjoint of camera paths, whatever the shading normal: for any function h of the two
// directions, the sum over camera paths of |cos wo| h(wo, wi) f |cos wi| is that over photons of
// |cos wi| h(wo, wi) times what they go on with (bsdf/importance.h).
//
// Lobes with a density, but for the diffuse one, are sampled about the photon's own bent normal, which leaves
// out directions that only lean more than the test's 12 degrees make count: bsdf/importance.h.
//
// Every comparison at a significance of 1e-6, 1044 of them: 1e-3 for the whole file. Fixed seeds.
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "engine/kernels/bsdf/importance.h"
#include "engine/math/warp.h"
#include "tests/support/bsdf_cases.h"
#include "tests/support/statistics.h"
#include "tests/support/uniform_numbers.h"

namespace glint::test {
namespace {

constexpr int kSamples = 400000;
constexpr size_t kShapes = 3;

/// Sums for both sides wo can be on, reflection and transmission, and three shapes of h.
using Sums = std::array<RunningMean, 4 * kShapes>;

/// The geometric normal is +z, the shading normal leans towards +x.
SurfacePoint leaningSurface(float leanDeg) {
    SurfacePoint surface{};
    surface.vertexColor = Vec3(1.0f);
    surface.ng = Vec3(0.0f, 0.0f, 1.0f);
    surface.dpdu = Vec3(0.8f, 0.6f, 0.0f);
    surface.dpdv = Vec3(-0.6f, 0.8f, 0.0f);
    surface.ns = Vec3(std::sin(leanDeg * kPi / 180.0f), 0.0f, std::cos(leanDeg * kPi / 180.0f));
    return surface;
}

/// h vanishes at grazing directions, where the power per photon is unbounded.
void addTo(Sums* sums, const Vec3& wo, const Vec3& wi, double weight) {
    const size_t kind = (wo.z > 0.0f ? 0u : 1u) + (wo.z * wi.z > 0.0f ? 0u : 2u);
    const double base = weight * static_cast<double>(std::fabs(wo.z * wi.z));
    const double values[kShapes] = {base, base * (1.0 + static_cast<double>(wi.x)),
                                    base * (1.0 + static_cast<double>(wo.x))};
    for (size_t i = 0; i < sums->size(); ++i) {
        (*sums)[i].add(i / kShapes == kind ? values[i % kShapes] : 0.0);
    }
}

Vec3 cosineDirection(UniformNumbers* random) {
    const bool front = random->next() < 0.5f;
    const Vec3 w = sampleCosineHemisphere(random->next2());
    return {w.x, w.y, front ? w.z : -w.z};
}

Sums cameraPaths(const SceneView& view, const SurfacePoint& surface, uint32_t seed) {
    Sums sums;
    UniformNumbers random(seed);
    for (int i = 0; i < kSamples; ++i) {
        const Vec3 wo = cosineDirection(&random);
        const float uLobe = random.next();
        const BsdfSample s = sample(makeBsdf<kAllFeatures>(view, surface, wo), uLobe, random.next2());
        addTo(&sums, wo, s.wi, s.valid ? static_cast<double>(s.weight.y) : 0.0);
    }
    return sums;
}

Sums photons(const SceneView& view, const SurfacePoint& surface, uint32_t seed) {
    Sums sums;
    UniformNumbers random(seed);
    for (int i = 0; i < kSamples; ++i) {
        const Vec3 wi = cosineDirection(&random);
        const float uLobe = random.next();
        const Bsdf<kAllFeatures> bsdf = makeBsdf<kAllFeatures>(view, surface, wi, TransportMode::Importance);
        const BsdfSample s = sampleImportance<kAllFeatures>(view, surface, bsdf, wi, uLobe, random.next2());
        addTo(&sums, s.wi, wi, s.valid ? static_cast<double>(s.weight.y) : 0.0);
    }
    return sums;
}

struct ImportanceCase {
    const char* name;
    MaterialData material;
    float mostLeanDeg = 40.0f;
};

class BsdfImportance : public testing::TestWithParam<ImportanceCase> {};

TEST_P(BsdfImportance, IsTheAdjointOfRadiance) {
    const MaterialData material = GetParam().material;
    SceneView view{};
    view.materials = {&material, 1};
    for (const float leanDeg : {0.0f, 12.0f, GetParam().mostLeanDeg}) {
        const SurfacePoint surface = leaningSurface(leanDeg);
        const Sums camera = cameraPaths(view, surface, 1);
        const Sums power = photons(view, surface, 2);
        for (size_t i = 0; i < camera.size(); ++i) {
            const double error = std::hypot(camera[i].standardError(), power[i].standardError());
            EXPECT_LE(std::fabs(camera[i].mean() - power[i].mean()), kNormalQuantile * error + 1e-6)
                << "leaning by " << leanDeg << " degrees, " << (i / kShapes % 2 == 0 ? "front" : "back")
                << (i / kShapes < 2 ? ", reflected" : ", transmitted") << ", shape " << i % kShapes << ": "
                << camera[i].mean() << " and " << power[i].mean();
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    Materials, BsdfImportance,
    testing::Values(
        ImportanceCase{"Diffuse", diffuseMaterial(Vec3(0.8f))},
        ImportanceCase{"Translucent", translucentMaterial(Vec3(0.3f), Vec3(0.6f))},
        ImportanceCase{"Mirror", mirrorMaterial(Vec3(0.9f))},
        ImportanceCase{"Glass", dielectricMaterial(1.5f, 0.0f)},
        ImportanceCase{"Diamond", dielectricMaterial(2.4f, 0.0f)},
        ImportanceCase{"Sheet", dielectricMaterial(1.5f, 0.0f, true)},
        ImportanceCase{"SmoothMetal", conductorMaterial("gold", 0.0f)},
        ImportanceCase{"RoughGlass", dielectricMaterial(1.5f, 0.3f), 6.0f},
        ImportanceCase{"GlossyGlass", dielectricMaterial(1.5f, 0.05f), 6.0f},
        ImportanceCase{"RoughMetal", conductorMaterial("gold", 0.3f), 6.0f},
        ImportanceCase{"Plastic", plasticMaterial(Vec3(0.5f), 1.5f, 0.0f), 6.0f},
        ImportanceCase{"RoughPlastic", plasticMaterial(Vec3(0.5f), 1.5f, 0.3f), 6.0f},
        ImportanceCase{"Paint", principledMaterial(Vec3(0.5f), 0.4f, 0.6f, 1.0f), 6.0f},
        ImportanceCase{"Cloth", principledMaterial(Vec3(0.5f), 0.6f, 0.0f, 0.5f, 0.3f, Vec3(0.7f)), 6.0f},
        ImportanceCase{"CoatedMirror", principledMaterial(Vec3(0.5f), 0.0f, 1.0f, 1.0f), 6.0f},
        ImportanceCase{"BrushedMetal",
                       withFacets(conductorMaterial("gold", 0.4f), 0.1f, FacetDistribution::Ggx), 6.0f},
        ImportanceCase{"BrushedGlass",
                       withFacets(dielectricMaterial(1.5f, 0.1f), 0.4f, FacetDistribution::Beckmann), 6.0f},
        ImportanceCase{"BrushedPlastic",
                       withFacets(plasticMaterial(Vec3(0.5f), 1.5f, 0.1f), 0.3f, FacetDistribution::Beckmann),
                       6.0f},
        ImportanceCase{
            "BrushedPaint",
            withFacets(principledMaterial(Vec3(0.5f), 0.1f, 0.6f, 1.0f), 0.4f, FacetDistribution::Ggx), 6.0f},
        ImportanceCase{"PassingBody",
                       withPassing(principledMaterial(Vec3(0.5f), 0.0f, 0.2f, 0.7f), 0.6f, false), 6.0f},
        ImportanceCase{"RoughPassingBody",
                       withPassing(principledMaterial(Vec3(0.5f), 0.3f, 0.0f), 0.7f, false, true), 6.0f},
        ImportanceCase{"PassingSheet", withPassing(principledMaterial(Vec3(0.5f), 0.0f, 0.0f), 0.6f, true),
                       6.0f},
        ImportanceCase{
            "RoughPassingSheet",
            withPassing(principledMaterial(Vec3(0.5f), 0.3f, 0.0f, 0.5f, 0.2f, Vec3(0.5f)), 0.7f, true),
            6.0f},
        ImportanceCase{"CoatedMetal", coatedMaterial("gold", 0.3f, 1.5f, 0.0f, Vec3(0.2f)), 6.0f},
        ImportanceCase{"RoughlyCoatedMetal", coatedMaterial("gold", 0.3f, 1.5f, 0.2f), 6.0f},
        ImportanceCase{"Phong", phongMaterial(Vec3(0.4f), Vec3(0.5f), 20.0f), 6.0f},
        ImportanceCase{"Ward", wardMaterial(Vec3(0.4f), Vec3(0.5f), Vec2(0.3f, 0.15f), WardForm::Ward), 6.0f},
        ImportanceCase{"BalancedWard", wardMaterial(Vec3(0.4f), Vec3(0.5f), Vec2(0.2f), WardForm::Balanced),
                       6.0f},
        ImportanceCase{"Mixture", mixtureMaterial(Vec3(0.8f), Vec3(0.3f, 0.3f, 0.4f), 1.5f), 6.0f}),
    [](const auto& importanceCase) { return std::string(importanceCase.param.name); });

}  // namespace
}  // namespace glint::test
