// sample() against pdfSolidAngle() for every material: chi-square over rings and sectors around each lobe.
// Family-wise level 1e-3 (chi_square.h), fixed seeds.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/bsdf_cases.h"
#include "tests/support/chi_square.h"
#include "tests/support/direction_grid.h"

namespace glint::test {
namespace {

constexpr int kSamples = 100000;

/// The direction around which a lobe lies: the mirror direction, or the refracted one (along the surface if
/// there is none).
Vec3 lobeAxis(const Bsdf<kAllFeatures>& bsdf, bool transmission) {
    const Vec3 wo = bsdf.woLocal;
    if (!transmission) { return bsdf.frame.toWorld(detail::mirrored(wo)); }
    const bool isSheet = (bsdf.material->flags & kMaterialThin) != 0;
    const float eta = isSheet ? 1.0f : bsdf.eta;
    const float sine2 = (1.0f - square(wo.z)) / square(eta);
    const Vec3 refracted(-wo.x / eta, -wo.y / eta, -safeSqrt(1.0f - sine2));
    return bsdf.frame.toWorld(glm::normalize(refracted));
}

struct Histogram {
    std::vector<double> observed, expected;
};

/// Counts of kSamples samples and their expectations. The last bin holds what has no density: absorbed
/// and specular.
Histogram histogram(const Bsdf<kAllFeatures>& bsdf, uint64_t seed) {
    const double smallest = std::fmax(0.1 * static_cast<double>(narrowestAlpha(*bsdf.material)), 1e-4);
    const DirectionGrid reflected(lobeAxis(bsdf, false), smallest, 16, 8);
    const DirectionGrid transmitted(lobeAxis(bsdf, true), smallest, 16, 8);
    const auto sideOf = [&](const Vec3& wi) { return glm::dot(bsdf.ngWorld, wi) > 0.0f; };

    Histogram result;
    for (const double mass : reflected.integrate([&](const Vec3& wi) {
             return sideOf(wi) ? static_cast<double>(pdfSolidAngle(bsdf, wi)) : 0.0;
         })) {
        result.expected.push_back(mass * kSamples);
    }
    for (const double mass : transmitted.integrate([&](const Vec3& wi) {
             return sideOf(wi) ? 0.0 : static_cast<double>(pdfSolidAngle(bsdf, wi));
         })) {
        result.expected.push_back(mass * kSamples);
    }
    double sum = 0.0;
    for (const double count : result.expected) {
        sum += count;
    }
    EXPECT_LE(sum, kSamples * 1.0005) << "the density integrates to more than 1";
    result.expected.push_back(std::fmax(kSamples - sum, 0.0));

    result.observed.assign(result.expected.size(), 0.0);
    Random random(seed);
    for (int i = 0; i < kSamples; ++i) {
        const float uLobe = random.uniform();
        const BsdfSample s = sample(bsdf, uLobe, random.uniform2());
        size_t bin = result.observed.size() - 1;
        if (s.valid && !s.isSpecular) {
            const bool front = sideOf(s.wi);
            bin = static_cast<size_t>(front ? reflected.cellOf(s.wi)
                                            : reflected.cells() + transmitted.cellOf(s.wi));
        }
        result.observed[bin] += 1.0;
    }
    return result;
}

TEST(BsdfSampling, FollowsItsDensity) {
    const std::vector<BsdfCase> cases = allBsdfCases();
    const std::vector<float> cosines{1.0f, 0.5f, 0.01f, -0.8f, -0.05f};
    const double level = sidakLevel(kFamilyLevel, static_cast<int>(cases.size() * cosines.size()));
    uint64_t seed = 1;
    for (const BsdfCase& bsdfCase : cases) {
        for (const float cosine : cosines) {
            SCOPED_TRACE(fmt::format("{}, cosine {}", bsdfCase.name, cosine));
            const Histogram h = histogram(testBsdf(bsdfCase.material, directionAt(cosine)), seed++);
            const ChiSquare test = chiSquare(h.observed, h.expected);
            EXPECT_GE(test.pValue, level)
                << "chi-square " << test.statistic << ", " << test.degrees << " degrees";
        }
    }
}

TEST(BsdfSampling, FollowsItsDensityWithBentShadingNormals) {
    TestSurface surface;
    surface.ns = glm::normalize(Vec3(0.5f, -0.2f, 0.8f));
    const std::vector<BsdfCase> cases{
        {"diffuse", diffuseMaterial(Vec3(0.5f))},
        {"translucent", translucentMaterial(Vec3(0.2f), Vec3(0.6f))},
        {"conductor", conductorMaterial("silver", 0.3f)},
        {"dielectric", dielectricMaterial(1.5f, 0.3f)},
        {"plastic", plasticMaterial(Vec3(0.5f), 1.5f, 0.2f)},
        {"coated", coatedMaterial("silver", 0.3f, 1.5f, 0.0f)},
        {"phong", phongMaterial(Vec3(0.5f), Vec3(0.4f), 30.0f)},
        {"ward", wardMaterial(Vec3(0.5f), Vec3(0.4f), Vec2(0.1f, 0.4f), WardForm::Duer)},
        {"passing body", withPassing(principledMaterial(Vec3(0.5f), 0.3f, 0.0f), 0.6f, false)},
        {"passing sheet", withPassing(principledMaterial(Vec3(0.5f), 0.3f, 0.0f), 0.6f, true)},
        {"principled", principledMaterial(Vec3(0.5f), 0.3f, 0.4f, 0.8f, 0.1f, Vec3(0.6f))}};
    const std::vector<float> cosines{0.9f, 0.1f, -0.3f};
    const double level = sidakLevel(kFamilyLevel, static_cast<int>(cases.size() * cosines.size()));
    uint64_t seed = 1000;
    for (const BsdfCase& bsdfCase : cases) {
        for (const float cosine : cosines) {
            SCOPED_TRACE(fmt::format("{}, cosine {}", bsdfCase.name, cosine));
            const Histogram h =
                histogram(testBsdf(bsdfCase.material, directionAt(cosine, 3.0f), surface), seed++);
            EXPECT_GE(chiSquare(h.observed, h.expected).pValue, level);
        }
    }
}

/// A test that cannot fail proves nothing: a density that is 5 % off must be found.
TEST(BsdfSampling, FindsAWrongDensity) {
    const MaterialData material = conductorMaterial("gold", 0.3f);
    Histogram h = histogram(testBsdf(material, directionAt(0.7f)), 7);
    for (size_t i = 0; i + 1 < h.expected.size(); ++i) {
        h.expected[i] *= i % 2 == 0 ? 1.05 : 0.95;
    }
    EXPECT_LT(chiSquare(h.observed, h.expected).pValue, 1e-6);
}

}  // namespace
}  // namespace glint::test
