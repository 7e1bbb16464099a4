// Textures against values worked out by hand: centres, bilinear weights, repetition, orientation, encodings.
#include "engine/kernels/texture.h"

#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "engine/math/color.h"

namespace glint {
namespace {

/// 2 x 2: top row 0.1 0.2, bottom row 0.3 0.4 (red), with green = 1 - red and blue 0.
const std::vector<float> kPixels{0.1f, 0.9f, 0.0f, 0.2f, 0.8f, 0.0f, 0.3f, 0.7f, 0.0f, 0.4f, 0.6f, 0.0f};

TextureView floatTexture() {
    TextureView view;
    view.floats = kPixels.data();
    view.width = 2;
    view.height = 2;
    return view;
}

float red(const TextureView& view, float u, float v) { return sampleTexture(view, Vec2(u, v)).x; }

TEST(Texture, TexelCentresAreExactAndVRunsUpwards) {
    const TextureView view = floatTexture();
    EXPECT_FLOAT_EQ(red(view, 0.25f, 0.75f), 0.1f) << "top left";
    EXPECT_FLOAT_EQ(red(view, 0.75f, 0.75f), 0.2f);
    EXPECT_FLOAT_EQ(red(view, 0.25f, 0.25f), 0.3f) << "bottom left";
    EXPECT_FLOAT_EQ(red(view, 0.75f, 0.25f), 0.4f);
    EXPECT_FLOAT_EQ(sampleTexture(view, Vec2(0.75f, 0.25f)).y, 0.6f);
}

TEST(Texture, IsBilinear) {
    const TextureView view = floatTexture();
    EXPECT_NEAR(red(view, 0.5f, 0.5f), 0.25f, 1e-6f);
    EXPECT_NEAR(red(view, 0.5f, 0.75f), 0.15f, 1e-6f);
    EXPECT_NEAR(red(view, 0.35f, 0.65f), 0.1f + 0.2f * 0.1f + 0.2f * 0.2f, 1e-6f);
}

TEST(Texture, Repeats) {
    const TextureView view = floatTexture();
    EXPECT_NEAR(red(view, 0.0f, 0.75f), 0.15f, 1e-6f) << "half left of the seam, half right of it";
    EXPECT_NEAR(red(view, 1.0f, 0.75f), 0.15f, 1e-6f);
    EXPECT_NEAR(red(view, 0.25f, 0.0f), 0.2f, 1e-6f);
    for (const float shift : {-7.0f, -1.0f, 1.0f, 4.0f, 1000.0f}) {
        EXPECT_NEAR(red(view, 0.3f + shift, 0.6f - shift), red(view, 0.3f, 0.6f), 1e-4f) << shift;
    }
    EXPECT_NEAR(red(view, -0.25f, -0.25f), red(view, 0.75f, 0.75f), 1e-6f);
}

TEST(Texture, AnyNumberIsSafe) {
    const TextureView view = floatTexture();
    const float infinity = std::numeric_limits<float>::infinity();
    for (const float u :
         {1e30f, -1e30f, 3e38f, infinity, -infinity, std::nanf(""), -1e-30f, -1e-9f, 1e-45f}) {
        for (const float v : {0.3f, infinity, -1e-9f, 16777215.0f}) {
            const float value = red(view, u, v);
            EXPECT_TRUE(value >= 0.1f - 1e-6f && value <= 0.4f + 1e-6f) << u << " " << v << ": " << value;
        }
    }
}

TEST(Texture, FlipAndScale) {
    TextureView view = floatTexture();
    view.flipV = true;
    EXPECT_FLOAT_EQ(red(view, 0.25f, 0.25f), 0.1f) << "v counts from the top row";
    view.flipV = false;
    view.scale = Vec2(2.0f, 4.0f);
    EXPECT_FLOAT_EQ(red(view, 0.625f, 0.4375f), red(floatTexture(), 1.25f, 1.75f));
    EXPECT_FLOAT_EQ(red(view, 0.625f, 0.4375f), 0.1f);
}

TEST(Texture, ClampShowsTheEdgeAndMirrorTurnsTheImageOver) {
    for (const bool flip : {false, true}) {
        TextureView view = floatTexture();
        view.flipV = flip;
        const float topLeft = flip ? 0.3f : 0.1f, bottomRight = flip ? 0.2f : 0.4f;
        view.wrapU = view.wrapV = WrapMode::Clamp;
        EXPECT_FLOAT_EQ(red(view, -3.0f, 7.0f), topLeft);
        EXPECT_FLOAT_EQ(red(view, 0.0f, 1.0f), topLeft) << "nothing of the other side";
        EXPECT_FLOAT_EQ(red(view, 1.01f, -0.5f), bottomRight);
        EXPECT_NEAR(red(view, 0.5f, 0.5f), 0.25f, 1e-6f) << "inside nothing changes";
        view.wrapU = view.wrapV = WrapMode::Mirror;
        for (const float u : {0.1f, 0.3f, 0.5f, 0.9f, 1.0f}) {
            EXPECT_NEAR(red(view, 2.0f - u, 0.3f), red(view, u, 0.3f), 1e-6f);
            EXPECT_NEAR(red(view, -u, 0.3f), red(view, u, 0.3f), 1e-6f);
            EXPECT_NEAR(red(view, 0.3f, 4.0f + u), red(view, 0.3f, u), 1e-6f);
        }
        for (const float u : {1e30f, -3e38f, std::numeric_limits<float>::infinity(), std::nanf("")}) {
            EXPECT_GE(red(view, u, u), 0.1f - 1e-6f);
            EXPECT_LE(red(view, u, u), 0.4f + 1e-6f);
        }
    }
}

TEST(Texture, NearestShowsOneTexel) {
    for (const WrapMode wrap : {WrapMode::Repeat, WrapMode::Clamp, WrapMode::Mirror}) {
        TextureView view = floatTexture();
        view.filter = TexelFilter::Nearest;
        view.wrapU = view.wrapV = wrap;
        for (const float x : {0.01f, 0.25f, 0.49f}) {
            EXPECT_FLOAT_EQ(red(view, x, 0.99f), 0.1f);
            EXPECT_FLOAT_EQ(red(view, x + 0.5f, 0.51f), 0.2f);
            EXPECT_FLOAT_EQ(red(view, x, 0.49f), 0.3f);
            EXPECT_FLOAT_EQ(red(view, x + 0.5f, 0.01f), 0.4f);
        }
    }
}

TEST(Texture, IsScaledThenTurnedThenMoved) {
    TextureView view = floatTexture();
    view.scale = {0.5f, 0.25f};
    view.turn = {0.0f, 1.0f};  // a quarter of a turn: (1, 0) becomes (0, 1)
    view.offset = {0.8f, 0.1f};
    EXPECT_NEAR(red(view, 0.6f, 0.4f), red(floatTexture(), 0.8f - 0.1f, 0.1f + 0.3f), 1e-6f);
    constexpr FeatureMask kPlain = kAllFeatures & ~kFeaturePlacedTextures;
    EXPECT_EQ(sampleTexture<kPlain>(view, Vec2(0.6f, 0.4f)).x, red(floatTexture(), 0.3f, 0.1f))
        << "masks without the feature look at the scale alone";
}

TEST(Texture, OneTexelIsConstant) {
    TextureView view = floatTexture();
    view.width = view.height = 1;
    for (const float u : {0.0f, 0.3f, 0.5f, 0.99f, -4.2f}) {
        EXPECT_FLOAT_EQ(red(view, u, 1.0f - u), 0.1f);
    }
}

TEST(Texture, BytesAreDecodedBeforeTheyAreMixed) {
    const std::vector<uint8_t> bytes{0, 128, 255, 255, 128, 0};
    TextureView view;
    view.bytes = bytes.data();
    view.width = 2;
    view.height = 1;
    view.encoding = ColorEncoding::Srgb;
    const Vec3 middle = sampleTexture(view, Vec2(0.5f, 0.5f));
    EXPECT_NEAR(middle.x, 0.5f, 1e-6f);
    EXPECT_NEAR(middle.y, srgbToLinear(128.0f / 255.0f), 1e-6f);
    view.encoding = ColorEncoding::Linear;
    EXPECT_NEAR(sampleTexture(view, Vec2(0.5f, 0.5f)).y, 128.0f / 255.0f, 1e-6f);
}

TEST(Texture, SrgbTableIsTheStandardsCurve) {
    for (int i = 0; i < 256; ++i) {
        EXPECT_NEAR(detail::srgbByteToLinear(static_cast<uint8_t>(i)),
                    srgbToLinear(static_cast<float>(i) / 255.0f), 2e-7f)
            << i;
    }
    EXPECT_EQ(detail::srgbByteToLinear(255), 1.0f);
    EXPECT_EQ(detail::srgbByteToLinear(0), 0.0f);
}

}  // namespace
}  // namespace glint
