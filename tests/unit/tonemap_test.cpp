// Tone curves at known points, on odd input, and the false colours.
#include "engine/render/tonemap.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace glint {
namespace {

constexpr ToneMap kAll[] = {ToneMap::Clamp, ToneMap::Srgb, ToneMap::Filmic, ToneMap::Reinhard, ToneMap::Soft};

TEST(ToneMap, NamesRoundTrip) {
    for (const ToneMap map : kAll) {
        EXPECT_EQ(toneMapFromName(toneMapName(map)), map);
    }
    EXPECT_FALSE(toneMapFromName("gamma").has_value());
}

TEST(ToneMap, KnownValues) {
    EXPECT_EQ(toneMapped(Vec3(0.25f), 1.0f, ToneMap::Clamp), Vec3(0.5f));
    EXPECT_EQ(toneMapped(Vec3(4.0f), -2.0f, ToneMap::Clamp), Vec3(1.0f));
    EXPECT_NEAR(toneMapped(Vec3(0.21404114f), 0.0f, ToneMap::Srgb).x, 0.5f, 1e-6f);
    // Reinhard 2002: L = white gives exactly 1; L = 1 gives (1 + 1/16) / 2.
    EXPECT_NEAR(toneMapped(Vec3(kReinhardWhite), 0.0f, ToneMap::Reinhard).x, 1.0f, 1e-5f);
    EXPECT_NEAR(reinhard(Vec3(1.0f)).y, 0.53125f, 1e-6f);
    // Narkowicz 2015 with x = 0.6: 0.6 (2.51 * 0.6 + 0.03) / (0.6 (2.43 * 0.6 + 0.59) + 0.14) = 0.9216
    // / 1.3688.
    EXPECT_NEAR(filmicCurve(1.0f), 0.9216f / 1.3688f, 1e-6f);
}

/// Of a linear colour, degrees.
float hueOf(const Vec3& c) {
    return std::atan2(std::sqrt(3.0f) * (c.y - c.z), 2.0f * c.x - c.y - c.z) * 180.0f / kPi;
}

TEST(ToneMap, SoftHighlightsKeepTheirHueOnTheWayToWhite) {
    for (const Vec3 color : {Vec3(1, 0.3f, 0.02f), Vec3(0.02f, 0.08f, 1), Vec3(0.05f, 1, 0.1f)}) {
        float largestOfFilmic = 0.0f;
        for (float stops = -4.0f; stops < 7.0f; stops += 0.5f) {
            const Vec3 bright = color * std::exp2(stops);
            const Vec3 soft = glm::clamp(softHighlights(bright), Vec3(0.0f), Vec3(1.0f));
            EXPECT_NEAR(hueOf(soft), hueOf(color), 1.0f) << stops << " stops";
            const Vec3 filmic(filmicCurve(bright.x), filmicCurve(bright.y), filmicCurve(bright.z));
            largestOfFilmic = std::max(largestOfFilmic, std::fabs(hueOf(filmic) - hueOf(color)));
        }
        EXPECT_GT(largestOfFilmic, 20.0f) << "a curve for each channel does not";
        const Vec3 white = softHighlights(color * 4096.0f);
        EXPECT_GT(std::min({white.x, white.y, white.z}), 0.95f);
    }
    EXPECT_NEAR(softHighlights(Vec3(0.18f)).x, 0.18f, 1e-4f);
}

TEST(ToneMap, IsMonotonicAndStaysInRange) {
    for (const ToneMap map : kAll) {
        float last = -1.0f;
        for (float x = 0.0f; x < 100.0f; x = x * 1.01f + 1e-4f) {
            const float y = toneMapped(Vec3(x), 0.0f, map).x;
            EXPECT_GE(y, last) << toneMapName(map) << " at " << x;
            EXPECT_LE(y, 1.0f + 1e-6f);
            last = y;
        }
        EXPECT_EQ(toneMapped(Vec3(0.0f), 0.0f, map), Vec3(0.0f));
    }
}

TEST(ToneMap, OddInputGivesDisplayableValues) {
    const float inf = std::numeric_limits<float>::infinity();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const ToneMap map : kAll) {
        for (const float exposure : {-200.0f, -10.0f, 0.0f, 10.0f, 200.0f}) {
            for (const Vec3& radiance :
                 {Vec3(inf, 0, 1), Vec3(nan, -inf, 1e38f), Vec3(-1, -0.0f, 1e-38f), Vec3(inf)}) {
                const Vec3 y = toneMapped(radiance, exposure, map);
                for (int c = 0; c < 3; ++c) {
                    EXPECT_TRUE(y[c] >= 0.0f && y[c] <= 1.000001f) << toneMapName(map) << " " << y[c];
                }
            }
        }
    }
}

TEST(ToneMap, ImageEqualsPixelsOnAnyNumberOfThreads) {
    constexpr int kWidth = 13;
    constexpr int kHeight = 57;
    std::vector<float> radiance;
    for (int i = 0; i < 3 * kWidth * kHeight; ++i) {
        radiance.push_back(0.001f * static_cast<float>((i * 7919) % 3001));
    }
    for (const ToneMap map : kAll) {
        const Image8 one = toneMapImage(radiance.data(), kWidth, kHeight, {0.5f, map}, 1);
        EXPECT_EQ(toneMapImage(radiance.data(), kWidth, kHeight, {0.5f, map}, 3).rgb, one.rgb);
        for (size_t i = 0; i < one.rgb.size(); i += 3) {
            const Vec3 expected = toneMapped({radiance[i], radiance[i + 1], radiance[i + 2]}, 0.5f, map);
            for (int c = 0; c < 3; ++c) {
                EXPECT_NEAR(static_cast<float>(one.rgb[i + static_cast<size_t>(c)]), 255.0f * expected[c],
                            0.501f);
            }
        }
    }
}

TEST(FalseColors, NormalsIdsAndDepths) {
    EXPECT_EQ(normalColor(Vec3(0.0f)), Vec3(0.0f));
    EXPECT_EQ(normalColor(Vec3(0, 0, 1)), Vec3(0.5f, 0.5f, 1.0f));
    EXPECT_EQ(idColor(0), Vec3(0.0f));
    for (uint32_t id = 1; id < 1000; ++id) {
        EXPECT_GT(glm::length(idColor(id) - idColor(id + 1)), 0.3f) << id;
        EXPECT_GT(maxComponent(idColor(id)), 0.9f);
        EXPECT_LE(maxComponent(idColor(id)), 1.0f);
    }
    const DepthRange range = depthRange({0.0f, 4.0f, 2.0f, kInfinity, 10.0f});
    EXPECT_EQ(range.nearest, 2.0f);
    EXPECT_EQ(range.farthest, 10.0f);
    EXPECT_EQ(depthColor(0.0f, 2.0f, 10.0f), Vec3(0.0f));
    EXPECT_EQ(depthColor(2.0f, 2.0f, 10.0f), Vec3(1.0f));
    EXPECT_NEAR(depthColor(10.0f, 2.0f, 10.0f).x, 0.1f, 1e-6f);
    EXPECT_EQ(depthColor(3.0f, 3.0f, 3.0f), Vec3(1.0f));
    EXPECT_EQ(depthRange({0.0f}).farthest, 0.0f);
}

}  // namespace
}  // namespace glint
