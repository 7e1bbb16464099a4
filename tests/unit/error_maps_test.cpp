// Error maps against the metrics whose means they are, their ranges, and colours whose order the eye
// can read.
#include "engine/report/error_maps.h"

#include <cmath>
#include <limits>
#include <numeric>

#include <gtest/gtest.h>

#include "engine/math/color.h"
#include "engine/report/heat_map.h"
#include "tests/support/formula_images.h"

namespace glint {
namespace {

using test::flatImage;
using test::formulaReference;
using test::formulaTest;

constexpr ErrorMapKind kAll[] = {ErrorMapKind::RelativeSquared, ErrorMapKind::Absolute, ErrorMapKind::Signed,
                                 ErrorMapKind::Flip};

ErrorMap mapOf(ErrorMapKind kind, const ImageF& test, const ImageF& reference) {
    const auto map = errorMap(kind, test, reference);
    EXPECT_TRUE(map) << map.error().format();
    return map ? *map : ErrorMap{};
}

/// CIE L* of display values.
double lightness(const Vec3& display) {
    const float y = luminance({srgbToLinear(display.x), srgbToLinear(display.y), srgbToLinear(display.z)});
    return y > 0.008856f ? 116.0 * std::cbrt(static_cast<double>(y)) - 16.0 : 903.3 * static_cast<double>(y);
}

TEST(ErrorMaps, MeansAreTheMetrics) {
    const ImageF test = formulaTest(64, 48);
    const ImageF reference = formulaReference(64, 48);
    const auto metrics = compareImages(test, reference);
    ASSERT_TRUE(metrics);
    const auto mean = [&](ErrorMapKind kind) {
        const ErrorMap map = mapOf(kind, test, reference);
        return std::accumulate(map.values.begin(), map.values.end(), 0.0) / (64.0 * 48.0);
    };
    EXPECT_NEAR(mean(ErrorMapKind::RelativeSquared), metrics->relMse, 1e-6 * metrics->relMse);
    EXPECT_NEAR(mean(ErrorMapKind::Signed), metrics->bias, 1e-8);
    EXPECT_NEAR(mean(ErrorMapKind::Flip), metrics->flip, 1e-8);
    EXPECT_GT(mean(ErrorMapKind::Absolute), metrics->bias);
}

TEST(ErrorMaps, ReadableRanges) {
    const ImageF reference = flatImage(20, 20, 1.0f);
    const ImageF test = flatImage(20, 20, 1.3f);
    const MapRange absolute = readableRange(mapOf(ErrorMapKind::Absolute, test, reference));
    EXPECT_DOUBLE_EQ(absolute.high, 1.0);
    EXPECT_DOUBLE_EQ(absolute.low, 1e-4);
    EXPECT_TRUE(absolute.logarithmic);
    const MapRange both = readableRange(mapOf(ErrorMapKind::Signed, reference, test));
    EXPECT_DOUBLE_EQ(both.high, 0.5);
    EXPECT_DOUBLE_EQ(both.low, -0.5);
    EXPECT_EQ(readableRange(mapOf(ErrorMapKind::Flip, test, reference)).high, 1.0);
}

TEST(ErrorMaps, OneOutlierDoesNotRuleTheRange) {
    ImageF test = flatImage(50, 40, 1.3f);
    test.rgb[0] = 1e9f;
    const MapRange range = readableRange(mapOf(ErrorMapKind::Absolute, test, flatImage(50, 40, 1.0f)));
    EXPECT_DOUBLE_EQ(range.high, 1.0);
}

TEST(ErrorMaps, NoErrorIsBlackAndStillHasARange) {
    const ImageF image = formulaReference(9, 7);
    for (const ErrorMapKind kind : kAll) {
        const ErrorMap map = mapOf(kind, image, image);
        const MapRange range = readableRange(map);
        EXPECT_LT(range.low, range.high) << errorMapName(kind);
        EXPECT_EQ(falseColors(map, range).rgb, std::vector<uint8_t>(3 * 63, 0)) << errorMapName(kind);
    }
}

TEST(ErrorMaps, NonFinitePixelsAreMagenta) {
    ImageF test = formulaTest(9, 7);
    test.rgb[3 * 10 + 2] = std::numeric_limits<float>::quiet_NaN();
    for (const ErrorMapKind kind : kAll) {
        const ErrorMap map = mapOf(kind, test, formulaReference(9, 7));
        const Image8 image = falseColors(map, readableRange(map));
        EXPECT_TRUE(std::isnan(map.values[10])) << errorMapName(kind);
        EXPECT_EQ(std::vector<uint8_t>(image.rgb.begin() + 30, image.rgb.begin() + 33),
                  (std::vector<uint8_t>{255, 0, 255}));
        EXPECT_TRUE(std::isfinite(map.values[11])) << errorMapName(kind);
    }
}

TEST(ErrorMaps, SignedMapsTellBrighterFromDarker) {
    const ImageF reference = flatImage(4, 4, 1.0f);
    const auto color = [&](float value) {
        const ErrorMap map = mapOf(ErrorMapKind::Signed, flatImage(4, 4, value), reference);
        return falseColors(map, {.low = -0.5, .high = 0.5}).rgb;
    };
    const auto above = color(1.2f);
    const auto below = color(0.8f);
    EXPECT_GT(above[0], above[2]);
    EXPECT_LT(below[0], below[2]);
}

TEST(ErrorMaps, SizesMustMatch) {
    EXPECT_FALSE(errorMap(ErrorMapKind::Flip, flatImage(3, 4, 0.0f), flatImage(4, 3, 0.0f)));
}

TEST(HeatMap, LightnessRisesEvenly) {
    double last = lightness(heatColor(0.0f));
    for (int i = 1; i <= 100; ++i) {
        const double now = lightness(heatColor(static_cast<float>(i) / 100.0f));
        EXPECT_GT(now, last + 0.2) << i;
        EXPECT_LT(now, last + 2.5) << i;
        last = now;
    }
}

TEST(HeatMap, SignedColorsBrightenWithDistanceFromZero) {
    for (const float sign : {-1.0f, 1.0f}) {
        double last = -1.0;
        for (int i = 0; i <= 100; ++i) {
            const double now = lightness(signedColor(sign * static_cast<float>(i) / 100.0f));
            EXPECT_GT(now, last) << sign << " " << i;
            last = now;
        }
    }
}

}  // namespace
}  // namespace glint
