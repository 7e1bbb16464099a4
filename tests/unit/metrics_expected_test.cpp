// The metrics against numbers that metrics_expected.py computed by another route, in another language, on
// pictures that both programs make from the same integer formulas. 23 x 17 and 7 x 5 have no room for
// trimming, and the last none for a whole SSIM window.
#include <cmath>

#include <gtest/gtest.h>

#include "engine/report/hdr_flip.h"
#include "engine/report/metrics.h"
#include "tests/support/formula_images.h"

namespace glint {
namespace {

constexpr double kTolerance = 1e-5;

struct Expected {
    int width, height;
    double mse, rmse, relMse, relMseTrimmed, mape, bias, relativeBias, maxError, ssim, flip, hdrFlip,
        pictureError;
};

constexpr Expected kExpected[] = {
    {64, 48, 0.162663035923, 0.403315057892, 3.39471687312, 2.3597938072, 0.468741492728, 0.0478032430013,
     0.107203555772, 4.05078125, 0.904551061894, 0.101916329624, 0.113552544114, 0.107073448122},
    {23, 17, 0.164743655986, 0.405886259913, 3.0615476778, 3.0615476778, 0.33163665855, 0.0486566229753,
     0.107696730253, 4.046875, 0.834672476118, 0.105943712574, 0.120594829956, 0.109367021229},
    {7, 5, 0.000706263950893, 0.0265756270085, 0.0293694430911, 0.0293694430911, 0.52671742755,
     0.00513392857143, 0.0221012171685, 0.05078125, 0.953796098979, 0.11357288767, 0.156359795635,
     0.0470719169298},
};

TEST(MetricsExpected, AgreeWithAnIndependentProgram) {
    for (const Expected& e : kExpected) {
        SCOPED_TRACE(testing::Message() << e.width << " x " << e.height);
        const auto metrics = compareImages(test::formulaTest(e.width, e.height),
                                           test::formulaReference(e.width, e.height), {.hdrFlip = true});
        ASSERT_TRUE(metrics) << metrics.error().format();
        EXPECT_NEAR(metrics->mse, e.mse, kTolerance);
        EXPECT_NEAR(metrics->rmse, e.rmse, kTolerance);
        EXPECT_NEAR(metrics->relMse, e.relMse, kTolerance);
        EXPECT_NEAR(metrics->relMseTrimmed, e.relMseTrimmed, kTolerance);
        EXPECT_NEAR(metrics->mape, e.mape, kTolerance);
        EXPECT_NEAR(metrics->bias, e.bias, kTolerance);
        EXPECT_NEAR(metrics->relativeBias, e.relativeBias, kTolerance);
        EXPECT_NEAR(metrics->maxError, e.maxError, kTolerance);
        EXPECT_NEAR(metrics->ssim, e.ssim, kTolerance);
        EXPECT_NEAR(metrics->flip, e.flip, kTolerance);
        EXPECT_NEAR(metrics->hdrFlip, e.hdrFlip, kTolerance);
        EXPECT_NEAR(metrics->pictureError, e.pictureError, kTolerance);
    }
}

TEST(MetricsExpected, AtAnotherExposureAndViewingDistance) {
    const MetricOptions options{.exposureStops = 1.0, .pixelsPerDegree = 20.0};
    const auto metrics = compareImages(test::formulaTest(64, 48), test::formulaReference(64, 48), options);
    ASSERT_TRUE(metrics) << metrics.error().format();
    EXPECT_NEAR(metrics->flip, 0.191855525786, kTolerance);
    EXPECT_NEAR(metrics->ssim, 0.962474647109, kTolerance);
}

/// Flat fields pass the filters unchanged and have no features: what is left is Hunt's L*a*b*, the distance
/// HyAB and its redistribution. With c = 203.3017^0.7, the distance of green and blue, 0.95 + 0.05 (100^0.7 -
/// 0.4 c) / (0.6 c) for black and white.
TEST(MetricsExpected, FlipOfFlatFieldsByHand) {
    const auto metrics = compareImages(test::flatImage(9, 9, 1.0f), test::flatImage(9, 9, 0.0f));
    ASSERT_TRUE(metrics);
    const double c = std::pow(203.30165461, 0.7);
    EXPECT_NEAR(metrics->flip, 0.95 + 0.05 * (std::pow(100.0, 0.7) - 0.4 * c) / (0.6 * c), kTolerance);
}

/// The authors' program says of its own example that it spans -12.5423 to 0.9427 stops in 14 exposures.
/// A picture whose largest and median luminance (the mean of the two in the middle) are as far apart has
/// as many.
TEST(MetricsExpected, HdrFlipExposuresAsPublished) {
    ImageF image = test::flatImage(2, 2, 0.0f);
    const double ratio = std::exp2(12.5423 + 0.9427);
    const float values[] = {1.0f, 3.0f, 0.5f, static_cast<float>(2.0 * ratio)};
    for (size_t i = 0; i < image.rgb.size(); ++i) {
        image.rgb[i] = values[i / 3];
    }
    const ExposureRange range = hdrFlipExposures(image);
    EXPECT_EQ(range.count, 14);
    EXPECT_NEAR(range.stop - range.start, std::log2(ratio), 1e-6);
    // The curve of Narkowicz, before its scale of 0.6, takes 1.2713234 to 0.85.
    EXPECT_NEAR(0.6 * 2.0 * std::exp2(range.stop), 1.2713234, 1e-6);
}

/// 1024 times the sixth power: values that span more than three stops between the median and the largest.
ImageF stretched(ImageF image) {
    for (float& value : image.rgb) {
        value = static_cast<float>(1024.0 * std::pow(static_cast<double>(value), 6.0));
    }
    return image;
}

TEST(MetricsExpected, HdrFlipOverManyExposures) {
    const ImageF reference = stretched(test::formulaReference(64, 48));
    EXPECT_EQ(hdrFlipExposures(reference).count, 4);
    const auto metrics = compareImages(stretched(test::formulaTest(64, 48)), reference, {.hdrFlip = true});
    ASSERT_TRUE(metrics) << metrics.error().format();
    EXPECT_NEAR(metrics->hdrFlip, 0.194319222336, kTolerance);
}

}  // namespace
}  // namespace glint
