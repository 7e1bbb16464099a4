// Distributions of facets: GGX and Beckmann, with one alpha and with two. Integrals are deterministic, to the
// errors of their quadrature. Normals that are drawn at random: chi-square over their slopes in units of
// alpha, family-wise level 1e-3 (chi_square.h), fixed seeds; whole materials are in bsdf_sampling_test.
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "engine/builders/coat_albedo.h"
#include "engine/scene/kind_names.h"
#include "tests/support/bsdf_cases.h"
#include "tests/support/chi_square.h"
#include "tests/support/uniform_numbers.h"

namespace glint::test {
namespace {

constexpr double kPiDouble = 3.14159265358979323846;

std::vector<GeneralFacets> manyFacets() {
    std::vector<GeneralFacets> all;
    for (const FacetDistribution kind : {FacetDistribution::Ggx, FacetDistribution::Beckmann}) {
        for (const Vec2 alpha : {Vec2(1e-4f), Vec2(1e-3f), Vec2(0.1f), Vec2(1.0f), Vec2(1e-3f, 1.0f),
                                 Vec2(0.5f, 0.05f), Vec2(0.2f, 0.8f)}) {
            all.push_back({alpha.x, alpha.y, kind});
        }
    }
    return all;
}

std::string nameFor(const GeneralFacets& facets) {
    return fmt::format("{} {} by {}", nameOf(facets.kind), facets.alphaX, facets.alphaY);
}

/// The integral over all facet normals h of D(h) of(h), by their slopes in units of alpha: midpoints in
/// the angle about the normal and in s for r^2 = 1 / (1 - s)^2 - 1, in which GGX's tail is even.
template <class Of>
double overFacets(const GeneralFacets& facets, const Of& of) {
    constexpr int kTurns = 128, kRings = 1024;
    double sum = 0.0;
    for (int i = 0; i < kRings; ++i) {
        const double rest = 1.0 - (i + 0.5) / kRings;
        const double r = std::sqrt(1.0 / (rest * rest) - 1.0);
        for (int j = 0; j < kTurns; ++j) {
            const double phi = 2.0 * kPiDouble * (j + 0.5) / kTurns;
            const double x = static_cast<double>(facets.alphaX) * r * std::cos(phi);
            const double y = static_cast<double>(facets.alphaY) * r * std::sin(phi);
            const double z = 1.0 / std::sqrt(1.0 + x * x + y * y);
            const Vec3 h(static_cast<float>(x * z), static_cast<float>(y * z), static_cast<float>(z));
            // Solid angle by slopes: z^3; r dr = ds / (1 - s)^3.
            const double area = static_cast<double>(facets.alphaX) * static_cast<double>(facets.alphaY) * z *
                                z * z / (rest * rest * rest);
            sum += static_cast<double>(facets.distribution(h)) * of(h) * area;
        }
    }
    return sum * 2.0 * kPiDouble / kTurns / kRings;
}

TEST(Facets, CoverTheSurfaceOnce) {
    for (const GeneralFacets& facets : manyFacets()) {
        const double area = overFacets(facets, [](const Vec3& h) { return static_cast<double>(h.z); });
        EXPECT_NEAR(area, 1.0, 1e-3) << nameFor(facets);
    }
}

/// Smith's masking: what facets turn to a direction, less what others hide, is what the surface shows to it;
/// without hiding it is w.z (1 + Lambda) (Heitz 2014, eq. 71 and after).
TEST(Facets, ShowTheAreaThatFacesTheDirection) {
    for (const GeneralFacets& facets : manyFacets()) {
        for (const float cosine : {1.0f, 0.7f, 0.2f, 0.01f, 0.0f}) {
            for (const float phi : {0.0f, 0.7f, 1.5708f}) {
                const Vec3 w = directionAt(cosine, phi);
                const double area = overFacets(facets, [&](const Vec3& h) {
                    return std::fmax(static_cast<double>(glm::dot(w, h)), 0.0);
                });
                EXPECT_NEAR(static_cast<double>(facets.shownArea(w)), area, 2e-3 * area + 1e-7)
                    << nameFor(facets) << ", cosine " << cosine << ", phi " << phi;
            }
        }
    }
}

/// The distribution function of slopes, in double: Heitz and d'Eon 2014, the supplement's equations.
double shareBelow(double cosine, double sine, double slopeAway) {
    const auto area = [&](double x) {
        return 0.5 * cosine * std::erfc(-x) + sine * std::exp(-x * x) / (2.0 * std::sqrt(kPiDouble));
    };
    return area(slopeAway) / (sine > 0.0 ? area(cosine / sine) : cosine);
}

TEST(Facets, BeckmannSlopesInvertTheirDistributionFunction) {
    for (const double cosine : {1.0, 0.999, 0.9, 0.5, 0.1, 1e-2, 1e-4, 1e-8, 0.0}) {
        const double sine = std::sqrt((1.0 - cosine) * (1.0 + cosine));
        for (int i = 0; i <= 4096; ++i) {
            const float u = std::fmin(static_cast<float>(i) / 4096.0f, kOneMinusEpsilon);
            const float slope =
                detail::sampleBeckmannSlope(static_cast<float>(cosine), static_cast<float>(sine), u);
            ASSERT_TRUE(std::isfinite(slope));
            EXPECT_NEAR(shareBelow(cosine, sine, -static_cast<double>(slope)), static_cast<double>(u), 3e-6)
                << "cosine " << cosine;
        }
    }
}

/// Rings and sectors of slopes in units of alpha; the first coordinate is s of overFacets().
struct SlopeBins {
    static constexpr int kRings = 12, kSectors = 12, kSteps = 24;

    static size_t of(const GeneralFacets& facets, const Vec3& h) {
        const double z = static_cast<double>(h.z);
        const double x = static_cast<double>(h.x / facets.alphaX) / z;
        const double y = static_cast<double>(h.y / facets.alphaY) / z;
        const double s = 1.0 - 1.0 / std::sqrt(1.0 + x * x + y * y);
        const double turn = 0.5 + std::atan2(y, x) / (2.0 * kPiDouble);
        return static_cast<size_t>(std::min(static_cast<int>(s * kRings), kRings - 1) * kSectors +
                                   std::min(static_cast<int>(turn * kSectors), kSectors - 1));
    }

    static std::vector<double> expected(const GeneralFacets& facets, const Vec3& wo, double samples) {
        std::vector<double> sums(kRings * kSectors);
        for (int i = 0; i < kRings * kSteps; ++i) {
            const double rest = 1.0 - (i + 0.5) / (kRings * kSteps);
            const double r = std::sqrt(1.0 / (rest * rest) - 1.0);
            for (int j = 0; j < kSectors * kSteps; ++j) {
                const double phi = 2.0 * kPiDouble * ((j + 0.5) / (kSectors * kSteps) - 0.5);
                const double x = static_cast<double>(facets.alphaX) * r * std::cos(phi);
                const double y = static_cast<double>(facets.alphaY) * r * std::sin(phi);
                const double z = 1.0 / std::sqrt(1.0 + x * x + y * y);
                const Vec3 h(static_cast<float>(x * z), static_cast<float>(y * z), static_cast<float>(z));
                const double area =
                    static_cast<double>(facets.alphaX * facets.alphaY) * z * z * z / (rest * rest * rest);
                sums[static_cast<size_t>(i / kSteps * kSectors + j / kSteps)] +=
                    static_cast<double>(facets.normalPdf(wo, h)) * area;
            }
        }
        for (double& sum : sums) {
            sum *= samples * 2.0 * kPiDouble / (kRings * kSteps * kSectors * kSteps);
        }
        return sums;
    }
};

TEST(Facets, NormalsFollowTheirDensity) {
    constexpr int kSamples = 200000;
    const std::vector<float> cosines{1.0f, 0.6f, 0.1f, 1e-3f, 0.0f};
    const double level = sidakLevel(kFamilyLevel, static_cast<int>(manyFacets().size() * cosines.size()));
    uint64_t seed = 1;
    for (const GeneralFacets& facets : manyFacets()) {
        for (const float cosine : cosines) {
            const Vec3 wo = directionAt(cosine, 0.3f);
            const std::vector<double> expected = SlopeBins::expected(facets, wo, kSamples);
            std::vector<double> observed(expected.size(), 0.0);
            Random random(seed++);
            for (int i = 0; i < kSamples; ++i) {
                observed[SlopeBins::of(facets, facets.sampleNormal(wo, random.uniform2()))] += 1.0;
            }
            const ChiSquare test = chiSquare(observed, expected);
            EXPECT_GE(test.pValue, level) << nameFor(facets) << ", cosine " << cosine << ": chi-square "
                                          << test.statistic << ", " << test.degrees << " degrees";
        }
    }
}

TEST(Facets, OfTwoEqualAlphasAreThoseOfOne) {
    UniformNumbers random(3);
    for (const float alpha : {kSmoothAlpha, 1e-3f, 0.03f, 0.4f, 1.0f}) {
        const GgxFacets one{alpha};
        const GeneralFacets two{alpha, alpha, FacetDistribution::Ggx};
        for (int i = 0; i < 2000; ++i) {
            const Vec3 wo = directionAt(std::fmax(random.next(), 1e-4f), 6.0f * random.next());
            const Vec2 u = random.next2();
            const Vec3 h = one.sampleNormal(wo, u);
            EXPECT_EQ(h, two.sampleNormal(wo, u));
            const Vec3 wi = reflect(wo, h);
            const auto expectAlike = [&](float a, float b) {
                EXPECT_NEAR(a, b, 3e-6f * std::fabs(a)) << alpha;
            };
            expectAlike(one.normalPdf(wo, h), two.normalPdf(wo, h));
            if (!(wi.z > 1e-4f)) { continue; }
            expectAlike(one.reflection(wo, wi, h), two.reflection(wo, wi, h));
            expectAlike(one.reflectionPdf(wo, h), two.reflectionPdf(wo, h));
            expectAlike(one.reflectionWeight(wo, wi), two.reflectionWeight(wo, wi));
            expectAlike(one.visible(wi), two.visible(wi));
        }
    }
}

/// Heitz 2014, section 5.3: facets of a stretched surface are the stretched surface's facets.
TEST(Facets, SwappedAlphasTurnThePicture) {
    UniformNumbers random(4);
    for (const FacetDistribution kind : {FacetDistribution::Ggx, FacetDistribution::Beckmann}) {
        const GeneralFacets facets{0.05f, 0.5f, kind}, turned{0.5f, 0.05f, kind};
        const auto turn = [](const Vec3& w) { return Vec3(-w.y, w.x, w.z); };
        for (int i = 0; i < 1000; ++i) {
            const Vec3 wo = directionAt(random.next(), 6.0f * random.next());
            const Vec3 wi = directionAt(random.next(), 6.0f * random.next());
            const Vec3 h = glm::normalize(wo + wi);
            const float value = facets.reflection(wo, wi, h);
            EXPECT_NEAR(value, turned.reflection(turn(wo), turn(wi), turn(h)), 1e-5f * value + 1e-30f);
        }
    }
}

}  // namespace
}  // namespace glint::test
