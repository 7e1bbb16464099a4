// White balance against tabulated lights, and what dithering does to bytes.
#include <gtest/gtest.h>

#include "engine/render/tonemap.h"

namespace glint {
namespace {

/// Of a chromaticity, with luminance 1, in linear Rec.709.
Vec3 colorOf(double x, double y) {
    const double bigX = x / y, bigZ = (1.0 - x - y) / y;
    return {static_cast<float>(3.2409699 * bigX - 1.5373832 - 0.4986108 * bigZ),
            static_cast<float>(-0.9692436 * bigX + 1.8759675 + 0.0415551 * bigZ),
            static_cast<float>(0.0556301 * bigX - 0.2039770 + 1.0569715 * bigZ)};
}

TEST(WhiteBalance, TabulatedLightsBecomeWhite) {
    struct Light {
        double x, y;
        WhiteBalance white;
    };
    // CIE 15: D50, D55 and D75, beside the Planckian locus like D65, and A, on it.
    for (const auto& [x, y, white] :
         {Light{0.34567, 0.35850, {5003.0f}}, Light{0.33242, 0.34743, {5503.0f}},
          Light{0.29902, 0.31485, {7504.0f}}, Light{0.44757, 0.40745, {2856.0f, -16.0f}}}) {
        const Vec3 seen = whiteBalanceMatrix(white) * colorOf(x, y);
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(seen[c], 1.0f, 0.015f) << white.kelvin << " K, channel " << c;
        }
    }
    const Vec3 tinted = whiteBalanceMatrix({6504.0f, 40.0f}) * Vec3(1.0f);
    EXPECT_LT(tinted.y, 0.98f);
    EXPECT_GT(std::min(tinted.x, tinted.z), 1.02f);
}

TEST(WhiteBalance, NeutralLeavesEveryBitAndItsNeighboursAlmost) {
    EXPECT_EQ(whiteBalanceMatrix({}), Mat3(1.0f));
    const Mat3 beside = whiteBalanceMatrix({6505.0f, 0.0f});
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            EXPECT_NEAR(beside[i][j], i == j ? 1.0f : 0.0f, 1e-3f);
        }
    }
    const Vec3 broken(kInfinity, std::nanf(""), 0.1f);
    const Vec3 toned = ToneMapper({.toneMap = ToneMap::Filmic})(broken);
    EXPECT_EQ(toned, toneMapped(broken, 0.0f, ToneMap::Filmic));
}

TEST(Dithering, KeepsMeansAndEndsAndIsOffUnlessAsked) {
    constexpr int kSide = 128;
    for (const float level : {0.0f, 0.3f, 100.3f, 254.9f, 255.0f, 300.0f}) {
        const std::vector<float> radiance(size_t{3} * kSide * kSide, level / 255.0f);
        DisplayLook look{.toneMap = ToneMap::Clamp};
        const Image8 plain = toneMapImage(radiance.data(), kSide, kSide, look, 1);
        look.dithers = true;
        const Image8 dithered = toneMapImage(radiance.data(), kSide, kSide, look, 1);
        EXPECT_EQ(toneMapImage(radiance.data(), kSide, kSide, look, 3).rgb, dithered.rgb);
        const float shown = std::min(level, 255.0f);
        double sum = 0.0;
        for (size_t i = 0; i < dithered.rgb.size(); ++i) {
            const auto byte = static_cast<float>(dithered.rgb[i]);
            EXPECT_LT(std::fabs(byte - shown), 1.0f);
            EXPECT_EQ(static_cast<float>(plain.rgb[i]), std::floor(shown + 0.5f));
            sum += static_cast<double>(byte);
        }
        EXPECT_NEAR(sum / static_cast<double>(dithered.rgb.size()), static_cast<double>(shown), 0.01);
    }
}

}  // namespace
}  // namespace glint
