// The picture metrics on cases whose values follow from the definitions: equal, tiny, unequal, broken and
// extreme pictures, symmetries, and independence of threads.
#include "engine/report/metrics.h"

#include <array>
#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/report/hdr_flip.h"
#include "tests/support/formula_images.h"

namespace glint {
namespace {

using test::flatImage;
using test::formulaReference;
using test::formulaTest;

constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

ImageMetrics compare(const ImageF& test, const ImageF& reference, const MetricOptions& options = {}) {
    const auto metrics = compareImages(test, reference, options);
    EXPECT_TRUE(metrics) << metrics.error().format();
    return metrics ? *metrics : ImageMetrics{};
}

TEST(Metrics, EqualImagesDifferByNothing) {
    const ImageF image = formulaReference(37, 23);
    const ImageMetrics m = compare(image, image);
    for (const double zero :
         {m.mse, m.rmse, m.relMse, m.relMseTrimmed, m.mape, m.bias, m.relativeBias, m.maxError, m.flip}) {
        EXPECT_EQ(zero, 0.0);
    }
    EXPECT_EQ(m.ssim, 1.0);
    EXPECT_EQ(m.comparedPixels, 37u * 23u);
}

TEST(Metrics, OnePixel) {
    const ImageMetrics m = compare(flatImage(1, 1, 0.3f), flatImage(1, 1, 0.2f));
    const double error = static_cast<double>(0.3f) - static_cast<double>(0.2f);
    EXPECT_DOUBLE_EQ(m.mse, error * error);
    EXPECT_NEAR(m.relMse, error * error / (0.04 + 0.01), 1e-8);
    EXPECT_NEAR(m.mape, error / 0.21, 1e-7);
    EXPECT_NEAR(m.relativeBias, 0.5, 1e-6);
    EXPECT_EQ(m.trimmedPixels, 0u);
    // Equation 6 of Wang et al. with no variance, at the display values of 0.3 and 0.2.
    const double a = 1.055 * std::pow(0.3, 1.0 / 2.4) - 0.055;
    const double b = 1.055 * std::pow(0.2, 1.0 / 2.4) - 0.055;
    EXPECT_NEAR(m.ssim, (2.0 * a * b + 1e-4) / (a * a + b * b + 1e-4), 1e-6);
    EXPECT_GT(m.flip, 0.0);
    EXPECT_LT(m.flip, 1.0);
}

TEST(Metrics, BiasHasTheSignOfTheTestImage) {
    EXPECT_NEAR(compare(flatImage(8, 8, 1.1f), flatImage(8, 8, 1.0f)).relativeBias, 0.1, 1e-6);
    EXPECT_NEAR(compare(flatImage(8, 8, 0.9f), flatImage(8, 8, 1.0f)).relativeBias, -0.1, 1e-6);
}

TEST(Metrics, NothingIsRelativeToABlackReference) {
    const auto relativeErrors = [](const ImageMetrics& m) {
        return std::array{m.relMse, m.relMseTrimmed, m.relativeRmse(), m.mape, m.relativeBias};
    };
    for (const double error : relativeErrors(compare(flatImage(16, 16, 0.1f), flatImage(16, 16, 0.0f)))) {
        EXPECT_EQ(error, std::numeric_limits<double>::infinity());
    }
    for (const double error : relativeErrors(compare(flatImage(16, 16, 0.0f), flatImage(16, 16, 0.0f)))) {
        EXPECT_EQ(error, 0.0);
    }
    ImageF one = flatImage(16, 16, 0.0f);
    one.rgb[5] = 0.1f;
    EXPECT_NEAR(compare(flatImage(16, 16, 0.0f), one).mape, 0.1 / 0.11 / 768.0, 1e-7);
}

TEST(Metrics, TrimmingDropsTheOutlierAndNothingElse) {
    ImageF test = flatImage(40, 50, 1.1f);
    const ImageF reference = flatImage(40, 50, 1.0f);
    test.rgb[3 * (7 * 40 + 5)] = 1e6f;
    const ImageMetrics m = compare(test, reference);
    EXPECT_EQ(m.trimmedPixels, 2u);  // 0.1 % of 2000
    EXPECT_NEAR(m.relMseTrimmed, 0.01 / 1.01, 1e-7);
    EXPECT_GT(m.relMse, 1e8);
    EXPECT_EQ(m.maxErrorX, 5);
    EXPECT_EQ(m.maxErrorY, 7);
    EXPECT_NEAR(m.maxError, 1e6, 2.0);
    EXPECT_NEAR(compare(test, reference, {.trimmedShare = 0.0}).relMseTrimmed, m.relMse, 1e-6 * m.relMse);
}

/// A spark is one wrong pixel however bright it is, a lamp counts by its own brightness, and black is
/// all wrong.
TEST(Metrics, ThePictureErrorIsOfNoLampAndNoSpark) {
    ImageF reference = flatImage(40, 50, 1.0f);
    ImageF test = flatImage(40, 50, 1.1f);
    EXPECT_NEAR(compare(test, reference).pictureError, 0.1 / std::sqrt(1.01), 1e-6);
    for (size_t i = 0; i < 120; ++i) {
        reference.rgb[i] = 1e3f;
        test.rgb[i] = 1.2e3f;
    }
    EXPECT_NEAR(compare(test, reference).pictureError, 0.11, 0.005) << "a fiftieth of the pixels are lamps";
    test.rgb[3 * 1900] = 1e6f;
    EXPECT_NEAR(compare(test, reference).pictureError, 0.11, 0.005);
    EXPECT_EQ(compare(test, reference).whollyWrongPixels, 1u);
    for (size_t i = 0; i < 20; ++i) {
        test.rgb[3 * (1900 + i)] = 1e6f;
    }
    // 2 of the 20 are left out.
    EXPECT_NEAR(compare(test, reference).pictureError, std::sqrt((18.0 + 0.01 * 1980) / 1998.0), 0.01);
    EXPECT_NEAR(compare(flatImage(9, 9, 0.0f), flatImage(9, 9, 2.0f)).pictureError, std::sqrt(1.0 / 1.01),
                1e-6);
    EXPECT_EQ(compare(flatImage(9, 9, 1.0f), flatImage(9, 9, 0.0f)).pictureError, 1.0);
    EXPECT_EQ(compare(flatImage(9, 9, 0.0f), flatImage(9, 9, 0.0f)).pictureError, 0.0);
}

TEST(Metrics, MetricsThatHaveNoReferenceAreSymmetric) {
    const ImageF a = formulaTest(33, 29);
    const ImageF b = formulaReference(33, 29);
    const ImageMetrics ab = compare(a, b);
    const ImageMetrics ba = compare(b, a);
    EXPECT_DOUBLE_EQ(ab.mse, ba.mse);
    EXPECT_DOUBLE_EQ(ab.bias, -ba.bias);
    EXPECT_DOUBLE_EQ(ab.ssim, ba.ssim);
    EXPECT_DOUBLE_EQ(ab.flip, ba.flip);
    EXPECT_NE(ab.relMse, ba.relMse);
}

TEST(Metrics, SizesMustMatch) {
    const auto result = compareImages(flatImage(4, 3, 0.0f), flatImage(3, 4, 0.0f));
    ASSERT_FALSE(result);
    EXPECT_THAT(result.error().message, testing::AllOf(testing::HasSubstr("4x3"), testing::HasSubstr("3x4")));
    EXPECT_FALSE(compareImages(ImageF{}, ImageF{}));
}

TEST(Metrics, OptionsOutOfRangeAreErrors) {
    const ImageF image = flatImage(2, 2, 0.5f);
    for (const MetricOptions& options :
         {MetricOptions{.relativeEpsilon = 0.0}, MetricOptions{.relativeEpsilon = std::nan("")},
          MetricOptions{.trimmedShare = 1.0}, MetricOptions{.trimmedShare = -0.1},
          MetricOptions{.exposureStops = std::nan("")}, MetricOptions{.pixelsPerDegree = 0.0}}) {
        EXPECT_FALSE(compareImages(image, image, options));
    }
}

TEST(Metrics, NonFinitePixelsAreCountedAndLeftOut) {
    const ImageF reference = formulaReference(24, 20);
    ImageF test = formulaTest(24, 20);
    ImageF clean = test;
    ImageF cleanReference = reference;
    for (const size_t pixel : {size_t{3}, size_t{100}}) {
        test.rgb[3 * pixel + 1] = pixel == 3 ? kNan : kInf;
    }
    ImageF broken = reference;
    broken.rgb[3 * 100] = -kInf;
    broken.rgb[3 * 101] = kNan;
    const ImageMetrics m = compare(test, broken);
    EXPECT_EQ(m.testNonFinite, 2u);
    EXPECT_EQ(m.referenceNonFinite, 2u);
    EXPECT_EQ(m.comparedPixels, 24u * 20u - 3u);
    for (const double value :
         {m.mse, m.relMse, m.relMseTrimmed, m.mape, m.bias, m.maxError, m.ssim, m.flip}) {
        EXPECT_TRUE(std::isfinite(value));
    }
    // The sums are those of pictures that agree in the broken pixels, over fewer pixels.
    for (const size_t pixel : {size_t{3}, size_t{100}, size_t{101}}) {
        for (size_t c = 3 * pixel; c < 3 * pixel + 3; ++c) {
            clean.rgb[c] = cleanReference.rgb[c] = 0.0f;
        }
    }
    const ImageMetrics expected = compare(clean, cleanReference);
    const double share = 480.0 / 477.0;
    EXPECT_NEAR(m.mse, expected.mse * share, 1e-12);
    EXPECT_NEAR(m.mape, expected.mape * share, 1e-12);
    EXPECT_NEAR(m.flip, expected.flip, 0.01 * expected.flip);
}

TEST(Metrics, NothingFiniteIsAnError) {
    const auto result = compareImages(flatImage(2, 2, kNan), flatImage(2, 2, 1.0f));
    ASSERT_FALSE(result);
    EXPECT_THAT(result.error().message, testing::HasSubstr("4 are not in the first"));
}

TEST(Metrics, WhatIsNotAskedForIsNotANumber) {
    const ImageF a = formulaTest(9, 9);
    const ImageMetrics m = compare(a, formulaReference(9, 9), {.ssim = false, .flip = false});
    EXPECT_TRUE(std::isnan(m.ssim));
    EXPECT_TRUE(std::isnan(m.flip));
    EXPECT_GT(m.mse, 0.0);
}

TEST(Metrics, HugeAndNegativeValuesStayFinite) {
    ImageF test = flatImage(16, 16, -3.0f);
    test.rgb[0] = 3e38f;
    test.rgb[1] = -3e38f;
    const ImageMetrics m = compare(test, flatImage(16, 16, 0.5f));
    for (const double value :
         {m.mse, m.relMse, m.relMseTrimmed, m.mape, m.bias, m.maxError, m.ssim, m.flip}) {
        EXPECT_TRUE(std::isfinite(value));
    }
}

TEST(Metrics, HdrFlipOfEqualBlackAndExtremeImages) {
    const MetricOptions options{.flip = false, .hdrFlip = true};
    const ImageF image = formulaReference(20, 20);
    EXPECT_EQ(compare(image, image, options).hdrFlip, 0.0);
    EXPECT_EQ(compare(flatImage(9, 9, 0.0f), flatImage(9, 9, 0.0f), options).hdrFlip, 0.0);
    ImageF emitter = flatImage(20, 20, 0.0f);
    emitter.rgb[0] = 3e38f;
    EXPECT_LE(hdrFlipExposures(emitter).count, 24) << "nearly all of it is black";
    const double seen = compare(image, emitter, options).hdrFlip;
    EXPECT_TRUE(seen >= 0.0 && seen <= 1.0) << seen;
}

TEST(Metrics, HdrFlipSeesWhatOneExposureCutsOff) {
    const MetricOptions options{.hdrFlip = true};
    const ImageMetrics m = compare(flatImage(16, 16, 40.0f), flatImage(16, 16, 80.0f), options);
    EXPECT_EQ(m.flip, 0.0) << "both are white at 0 stops";
    EXPECT_GT(m.hdrFlip, 0.1);
}

TEST(Metrics, ThreadsChangeNothing) {
    const ImageF test = formulaTest(67, 131);
    const ImageF reference = formulaReference(67, 131);
    const ImageMetrics one = compare(test, reference, {.threads = 1});
    for (const int threads : {2, 3, 8}) {
        const ImageMetrics many = compare(test, reference, {.threads = threads});
        EXPECT_EQ(one.mse, many.mse);
        EXPECT_EQ(one.relMse, many.relMse);
        EXPECT_EQ(one.relMseTrimmed, many.relMseTrimmed);
        EXPECT_EQ(one.mape, many.mape);
        EXPECT_EQ(one.bias, many.bias);
        EXPECT_EQ(one.ssim, many.ssim);
        EXPECT_EQ(one.flip, many.flip);
    }
}

}  // namespace
}  // namespace glint
