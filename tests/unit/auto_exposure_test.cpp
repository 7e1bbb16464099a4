// The exposure that a picture gets whose file states none.
#include "engine/render/auto_exposure.h"

#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace glint {
namespace {

constexpr int kWidth = 300, kHeight = 200;

float exposureOf(const std::function<float(int x, int y)>& grey) {
    std::vector<float> rgb;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            rgb.insert(rgb.end(), 3, grey(x, y));
        }
    }
    return autoExposure(rgb, kWidth, kHeight);
}

TEST(AutoExposure, PicturesThatShowStayAsTheyAre) {
    const float gradient = exposureOf([](int x, int) { return static_cast<float>(x) / kWidth; });
    EXPECT_EQ(gradient, 0.0f);
    EXPECT_EQ(exposureOf([](int, int) { return 1.0f; }), 0.0f) << "a white background";
    EXPECT_EQ(exposureOf([](int, int) { return 0.0f; }), 0.0f) << "nothing to see";
    // A small object before black, lit to a half; a dim room with lamps in sight.
    EXPECT_EQ(
        exposureOf([](int x, int y) { return x < 40 && y < 40 ? 0.02f * static_cast<float>(x) : 0.0f; }),
        0.0f);
    EXPECT_EQ(exposureOf([](int x, int y) {
                  return x < 60 && y < 40 ? 5.0f : 0.03f + 1e-4f * static_cast<float>(x);
              }),
              0.0f);
}

TEST(AutoExposure, WhiteAndBlackOnesAreBroughtIntoRange) {
    for (const float brightness : {2.5f, 30.0f, 1000.0f, 0.1f, 0.01f, 1e-5f, 1e-20f}) {
        const float stops = exposureOf(
            [&](int x, int) { return brightness * (0.5f + static_cast<float>(x) / (2 * kWidth)); });
        EXPECT_NEAR(brightness * std::exp2(stops), 0.8f, 0.15f) << brightness;
        EXPECT_EQ(3.0f * stops, std::round(3.0f * stops)) << "in thirds";
    }
    // Only the lamps are seen.
    const float lamps = exposureOf([](int x, int y) { return x < 60 && y < 40 ? 5.0f : 0.003f; });
    EXPECT_NEAR(0.003f * std::exp2(lamps), 0.8f, 0.15f);
}

TEST(AutoExposure, NoiseAndWhatIsNoNumberChangeLittle) {
    std::mt19937 random(3);
    std::exponential_distribution<float> noise(1.0f);
    const float clean = exposureOf([](int, int) { return 12.0f; });
    EXPECT_NEAR(exposureOf([&](int, int) { return 12.0f * noise(random); }), clean, 0.4f);
    EXPECT_EQ(exposureOf([](int x, int y) {
                  return x == 7 && y == 9 ? std::numeric_limits<float>::quiet_NaN() : 12.0f;
              }),
              clean);
}

}  // namespace
}  // namespace glint
