// The shader that the window shows pictures with agrees with the code that writes PNGs, to 1/255: every tone
// map, dark, bright, saturated and broken values, over a wide range of exposures. Drawn by OSMesa; no display
// is needed.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/render/tonemap.h"
#include "viewer/window/image_display.h"
#include "viewer/window/surface.h"

namespace glint {
namespace {

constexpr int kWidth = 64;
constexpr int kHeight = 33;

std::vector<float> testImage() {
    std::vector<float> rgb;
    uint32_t state = 1;
    for (int i = 0; i < kWidth * kHeight * 3; ++i) {
        state = state * 1664525u + 1013904223u;
        const float unit = static_cast<float>(state >> 8) * 0x1p-24f;
        rgb.push_back(std::exp2(unit * 24.0f - 16.0f));  // 1.5e-5 … 256
    }
    const float corners[] = {0.0f,   -1.0f, kInfinity, -kInfinity, std::nanf(""),
                             1e-38f, 1e30f, 1.0f,      0.5f,       0.0031308f};
    std::copy(std::begin(corners), std::end(corners), rgb.begin());
    return rgb;
}

TEST(ToneMapShader, AgreesWithTheProcessorsToOneStep) {
    const auto surface = makeHeadlessSurface({.width = 64, .height = 64});
    ASSERT_TRUE(surface) << surface.error().format();
    const auto display = ImageDisplay::create((*surface)->gl());
    ASSERT_TRUE(display) << display.error().format();
    const std::vector<float> image = testImage();
    (*display)->upload(image.data(), kWidth, kHeight, false);
    for (int map = 0; map < kToneMapCount; ++map) {
        for (const float stops : {-10.0f, -1.5f, 0.0f, 0.3333f, 3.0f, 10.0f}) {
            const auto toneMap = static_cast<ToneMap>(map);
            (*display)->update({.exposureStops = stops, .toneMap = toneMap});
            const std::vector<uint8_t> shown = (*display)->readBack();
            const Image8 saved = toneMapImage(image.data(), kWidth, kHeight, {stops, toneMap}, 1);
            ASSERT_EQ(shown.size(), saved.rgb.size());
            int largest = 0;
            for (size_t i = 0; i < shown.size(); ++i) {
                largest = std::max(largest, std::abs(shown[i] - saved.rgb[i]));
            }
            EXPECT_LE(largest, 1) << toneMapName(toneMap) << " at " << stops << " stops";
            EXPECT_NE(*std::max_element(shown.begin(), shown.end()), 0);
        }
    }
}

TEST(ToneMapShader, BalancesAndDithersAsTheProcessorDoes) {
    const auto surface = makeHeadlessSurface({.width = 64, .height = 64});
    ASSERT_TRUE(surface) << surface.error().format();
    const auto display = ImageDisplay::create((*surface)->gl());
    ASSERT_TRUE(display) << display.error().format();
    const std::vector<float> image = testImage();
    (*display)->upload(image.data(), kWidth, kHeight, false);
    for (const DisplayLook& look :
         {DisplayLook{.white = {3000.0f, 20.0f}}, DisplayLook{.white = {12000.0f, -60.0f}},
          DisplayLook{.exposureStops = 1.0f, .dithers = true}}) {
        (*display)->update(look);
        const std::vector<uint8_t> shown = (*display)->readBack();
        const Image8 saved = toneMapImage(image.data(), kWidth, kHeight, look, 1);
        const Image8 plain = toneMapImage(image.data(), kWidth, kHeight, {look.exposureStops}, 1);
        int largest = 0;
        size_t like = 0, likePlain = 0;
        for (size_t i = 0; i < shown.size(); ++i) {
            largest = std::max(largest, std::abs(shown[i] - saved.rgb[i]));
            like += shown[i] == saved.rgb[i] ? 1 : 0;
            likePlain += shown[i] == plain.rgb[i] ? 1 : 0;
        }
        EXPECT_LE(largest, 1);
        EXPECT_GT(like, likePlain);
        EXPECT_GT(like, shown.size() * 9 / 10);
    }
}

TEST(ToneMapShader, ColorsPassUnchangedAndRadianceComesBack) {
    const auto surface = makeHeadlessSurface({.width = 64, .height = 64});
    ASSERT_TRUE(surface) << surface.error().format();
    const auto display = ImageDisplay::create((*surface)->gl());
    ASSERT_TRUE(display) << display.error().format();
    EXPECT_TRUE((*display)->isSoftware());
    const std::vector<uint8_t> rgba{0, 64, 255, 255, 128, 191, 26, 255};
    const std::vector<float> radiance{1.0f, 1.0f, 1.0f, 0.0f, 0.0f, 0.0f};
    for (int turn = 0; turn < 2; ++turn) {
        (*display)->uploadColors(rgba.data(), 2, 1, false);
        (*display)->update({.exposureStops = 5.0f, .toneMap = ToneMap::Filmic});
        EXPECT_THAT((*display)->readBack(), testing::ElementsAre(0, 64, 255, 128, 191, 26));
        (*display)->upload(radiance.data(), 2, 1, false);
        (*display)->update({.toneMap = ToneMap::Clamp});
        EXPECT_THAT((*display)->readBack(), testing::ElementsAre(255, 255, 255, 0, 0, 0));
    }
}

}  // namespace
}  // namespace glint
