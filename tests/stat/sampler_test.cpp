// The samplers: range, stratification, independence of dimensions and pixels, and what stratification gains.
// Random tests: family-wise level 1e-3 (chi_square.h), fixed seeds.
#include "engine/kernels/sampler.h"

#include <algorithm>
#include <array>
#include <functional>

#include <gtest/gtest.h>

#include "tests/support/chi_square.h"

namespace glint::test {
namespace {

constexpr Dimension kDirection = dimension(BounceDimension::Direction, 0);
constexpr Dimension kLight = dimension(BounceDimension::LightPoint, 0);

Sampler samplerAt(uint32_t pass, int x = 3, int y = 5, uint32_t seed = 0,
                  SamplerKind tag = SamplerKind::Sobol) {
    PassParams params;
    params.pass = pass;
    params.seed = seed;
    params.sampler = tag;
    return makeSampler(params, x, y);
}

Vec2 draw2(const Sampler& sampler, Dimension d) { return get2D<kAllFeatures>(sampler, d); }
float draw1(const Sampler& sampler, Dimension d) { return get1D<kAllFeatures>(sampler, d); }

TEST(Dimensions, NoTwoAreTheSame) {
    std::vector<uint32_t> indices;
    for (uint32_t i = 0; i < static_cast<uint32_t>(CameraDimension::Count); ++i) {
        indices.push_back(dimension(static_cast<CameraDimension>(i)).index);
    }
    for (int bounce = 0; bounce < 100; ++bounce) {
        for (uint32_t i = 0; i < static_cast<uint32_t>(BounceDimension::Count); ++i) {
            indices.push_back(dimension(static_cast<BounceDimension>(i), bounce).index);
        }
    }
    std::sort(indices.begin(), indices.end());
    EXPECT_EQ(std::adjacent_find(indices.begin(), indices.end()), indices.end());
}

TEST(Sampler, StaysBelowOne) {
    EXPECT_EQ(uniformFloat(0xffffffffu), kOneMinusEpsilon);
    EXPECT_EQ(uniformFloat(0u), 0.0f);
    for (const SamplerKind tag : {SamplerKind::Sobol, SamplerKind::Independent}) {
        for (uint32_t pass = 0; pass < 100000; ++pass) {
            const Sampler sampler = samplerAt(pass, 1, 2, 3, tag);
            const Vec2 u = draw2(sampler, kDirection);
            ASSERT_TRUE(u.x >= 0.0f && u.x < 1.0f && u.y >= 0.0f && u.y < 1.0f);
            const float v = draw1(sampler, kLight);
            ASSERT_TRUE(v >= 0.0f && v < 1.0f);
        }
    }
    const Vec2 last = draw2(samplerAt(0xffffffffu), kDirection);
    EXPECT_LT(std::fmax(last.x, last.y), 1.0f);
}

/// Every elementary interval of area 2^-k holds exactly one of any aligned 2^k passes: a (0, k, 2)-net in
/// base 2.
TEST(Sampler, SobolPointsAreNets) {
    for (const uint32_t firstBlock : {0u, 1u, 5u}) {
        for (uint32_t k = 1; k <= 10; ++k) {
            const uint32_t count = 1u << k;
            for (uint32_t a = 0; a <= k; ++a) {
                std::vector<int> hits(count, 0);
                for (uint32_t i = 0; i < count; ++i) {
                    const Vec2 u = draw2(samplerAt(firstBlock * count + i), kDirection);
                    const auto column = static_cast<uint32_t>(u.x * static_cast<float>(1u << a));
                    const auto row = static_cast<uint32_t>(u.y * static_cast<float>(1u << (k - a)));
                    ++hits[(row << a) | column];
                }
                EXPECT_EQ(std::count(hits.begin(), hits.end(), 1), count)
                    << "block " << firstBlock << " k " << k << a;
            }
        }
    }
}

TEST(Sampler, SobolNumbersInOneDimensionAreStratified) {
    for (uint32_t k = 1; k <= 12; ++k) {
        const uint32_t count = 1u << k;
        std::vector<int> hits(count, 0);
        for (uint32_t i = 0; i < count; ++i) {
            ++hits[static_cast<uint32_t>(draw1(samplerAt(i), kDirection) * static_cast<float>(count))];
        }
        EXPECT_EQ(std::count(hits.begin(), hits.end(), 1), count) << k;
    }
}

/// Chi-square of a pair of numbers over a grid of 16 x 16.
double pairPValue(int samples, const std::function<Vec2(uint32_t)>& pair) {
    std::vector<double> observed(256, 0.0);
    for (int i = 0; i < samples; ++i) {
        const Vec2 u = pair(static_cast<uint32_t>(i));
        observed[static_cast<size_t>(u.y * 16.0f) * 16 + static_cast<size_t>(u.x * 16.0f)] += 1.0;
    }
    return chiSquare(observed, std::vector<double>(256, samples / 256.0)).pValue;
}

TEST(Sampler, PixelsSeedsAndDimensionsAreIndependent) {
    constexpr int kSamples = 1 << 16;
    const double level = sidakLevel(kFamilyLevel, 11);
    for (const SamplerKind tag : {SamplerKind::Sobol, SamplerKind::Independent}) {
        const auto at = [tag](uint32_t pass, int x, int y, uint32_t seed) {
            return samplerAt(pass, x, y, seed, tag);
        };
        // One pass over many pixels: neighbours, both axes, two seeds, two dimensions, two numbers of
        // one dimension.
        const auto xOf = [](uint32_t i) { return static_cast<int>(i % 256); };
        const auto yOf = [](uint32_t i) { return static_cast<int>(i / 256); };
        EXPECT_GE(pairPValue(kSamples,
                             [&](uint32_t i) {
                                 return Vec2(draw1(at(0, xOf(i), yOf(i), 0), kLight),
                                             draw1(at(0, xOf(i) + 1, yOf(i), 0), kLight));
                             }),
                  level);
        EXPECT_GE(pairPValue(kSamples,
                             [&](uint32_t i) {
                                 return Vec2(draw1(at(0, xOf(i), yOf(i), 0), kLight),
                                             draw1(at(0, xOf(i), yOf(i) + 1, 0), kLight));
                             }),
                  level);
        EXPECT_GE(pairPValue(kSamples,
                             [&](uint32_t i) {
                                 return Vec2(draw1(at(0, xOf(i), yOf(i), 0), kLight),
                                             draw1(at(0, xOf(i), yOf(i), 1), kLight));
                             }),
                  level);
        EXPECT_GE(pairPValue(kSamples,
                             [&](uint32_t i) {
                                 const Sampler s = at(7, xOf(i), yOf(i), 0);
                                 return Vec2(draw2(s, kDirection).x, draw2(s, kLight).x);
                             }),
                  level);
        EXPECT_GE(
            pairPValue(kSamples, [&](uint32_t i) { return draw2(at(9, xOf(i), yOf(i), 0), kDirection); }),
            level);
        if (tag == SamplerKind::Independent) {  // Sobol's passes of one pixel avoid each other on purpose
            EXPECT_GE(pairPValue(kSamples,
                                 [&](uint32_t i) {
                                     return Vec2(draw1(at(0, xOf(i), yOf(i), 0), kLight),
                                                 draw1(at(17, xOf(i), yOf(i), 0), kLight));
                                 }),
                      level);
        }
    }
}

/// Over the passes of one pixel, two dimensions must not move together: their joint cells fill evenly. They
/// are shuffled by a hash of few operations, which leaves a trace: chi-square calls 2 % of 20,000 pixels
/// uneven at 1e-4 (measured). Of 200 pixels more than 13 are so with probability 5e-5; without a shuffle all
/// would be.
TEST(Sampler, DimensionsOfOnePixelAreShuffled) {
    int uneven = 0;
    for (int pixel = 0; pixel < 200; ++pixel) {
        const double pValue = pairPValue(4096, [&](uint32_t i) {
            const Sampler s = samplerAt(i, pixel, 0);
            return Vec2(draw2(s, kDirection).x, draw2(s, kLight).x);
        });
        uneven += pValue < 1e-4 ? 1 : 0;
    }
    EXPECT_LE(uneven, 13);
}

double squaredError(SamplerKind tag, const std::function<double(Vec2)>& f, double truth, int passes) {
    Mean error;
    for (int pixel = 0; pixel < 500; ++pixel) {
        double sum = 0.0;
        for (int pass = 0; pass < passes; ++pass) {
            sum += f(draw2(samplerAt(static_cast<uint32_t>(pass), pixel, 1, 0, tag), kDirection));
        }
        error.add((sum / passes - truth) * (sum / passes - truth));
    }
    return error.mean();
}

TEST(Sampler, SobolConvergesFaster) {
    const auto smooth = [](Vec2 u) { return static_cast<double>(u.x * u.x * u.y); };  // 1/6
    const auto edge = [](Vec2 u) { return u.x + 0.7f * u.y < 0.9f ? 1.0 : 0.0; };     // a shadow's edge
    double edgeTruth = 0.0;
    for (int i = 0; i < 100000; ++i) {
        edgeTruth += std::fmin(std::fmax(0.9 - 0.7 * (i + 0.5) / 100000, 0.0), 1.0) / 100000;
    }
    EXPECT_LT(squaredError(SamplerKind::Sobol, smooth, 1.0 / 6.0, 256),
              squaredError(SamplerKind::Independent, smooth, 1.0 / 6.0, 256) / 500.0);
    EXPECT_LT(squaredError(SamplerKind::Sobol, edge, edgeTruth, 256),
              squaredError(SamplerKind::Independent, edge, edgeTruth, 256) / 8.0);
    EXPECT_LT(squaredError(SamplerKind::Sobol, smooth, 1.0 / 6.0, 100),
              squaredError(SamplerKind::Independent, smooth, 1.0 / 6.0, 100) / 10.0)
        << "not a power of two";
}

}  // namespace
}  // namespace glint::test
