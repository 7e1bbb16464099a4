// Mip maps: means, levels and pictures; and the built-in checkerboard.
#include <cmath>

#include <gtest/gtest.h>

#include "engine/builders/mip_levels.h"
#include "engine/io/scene_json.h"
#include "engine/kernels/sppm_camera_kernel.h"
#include "engine/kernels/sppm_gather_kernel.h"
#include "engine/kernels/texture.h"
#include "tests/support/relief_scenes.h"
#include "tests/support/render_scene.h"

namespace glint::test {
namespace {

TextureView viewOf(const ImageF& image) {
    TextureView view;
    view.floats = image.rgb.data();
    view.width = image.width;
    view.height = image.height;
    view.filter = TexelFilter::Mipmap;
    return view;
}

TEST(Mipmaps, KeepTheMeanAtEveryLevelAndSize) {
    for (const auto& [width, height] :
         {std::pair(8, 8), std::pair(7, 5), std::pair(1, 13), std::pair(31, 2)}) {
        const auto image = greyImage(
            width, height, [](int x, int y) { return static_cast<float>((x * 7 + y * 13) % 11) / 10.0f; });
        double mean = 0.0;
        for (const float value : image->rgb) {
            mean += static_cast<double>(value) / static_cast<double>(image->rgb.size());
        }
        const std::vector<float> values = mipLevels(viewOf(*image));
        ASSERT_EQ(values.size(), mipValues(width, height));
        size_t first = 0;
        for (int w = width, h = height; w > 1 || h > 1;) {
            w = nextMipSize(w);
            h = nextMipSize(h);
            const auto count = 3 * static_cast<size_t>(w) * static_cast<size_t>(h);
            double sum = 0.0;
            for (size_t i = first; i < first + count; ++i) {
                sum += static_cast<double>(values[i]);
            }
            EXPECT_NEAR(sum / static_cast<double>(count), mean, 1e-6) << w << " x " << h;
            first += count;
        }
        EXPECT_EQ(first, values.size());
    }
}

TEST(Mipmaps, ShowTheLevelThatAPixelCovers) {
    const auto image = greyImage(16, 16, [](int x, int) { return x % 2 == 0 ? 0.0f : 1.0f; });
    const std::vector<float> levels = mipLevels(viewOf(*image));
    TextureView view = viewOf(*image);
    view.mips = levels.data();
    const Vec2 dark(0.5f / 16.0f, 0.3f);
    EXPECT_NEAR(sampleTexture(view, dark, 0.0f).x, 0.0f, 1e-6f);
    EXPECT_NEAR(sampleTexture(view, dark, 1.0f / 16.0f).x, 0.0f, 1e-6f) << "one texel";
    EXPECT_NEAR(sampleTexture(view, dark, std::sqrt(2.0f) / 16.0f).x, 0.25f, 1e-5f) << "half a level";
    for (const float width : {2.0f / 16.0f, 0.5f, 1.0f, 1e5f}) {
        EXPECT_NEAR(sampleTexture(view, dark, width).x, 0.5f, 1e-6f) << width;
    }
    view.scale = Vec2(2.0f);
    EXPECT_NEAR(sampleTexture(view, 0.5f * dark, 1.0f / 16.0f).x, 0.5f, 1e-6f) << "two texels";
    view.bytes = nullptr;
    view.encoding = ColorEncoding::Srgb;
    EXPECT_NEAR(sampleNumbers(view, 0.5f * dark, 1.0f).x, 0.0f, 1e-6f) << "colours are no numbers";
}

/// A floor of fine checks to the horizon under an even sky.
SceneDescription checkedFloor(const char* filter) {
    auto scene = readSceneJson({"scene.json", std::string(R"({"glint": 1, "resolution": [32, 32],
      "camera": {"position": [0, 1, 0], "target": [0, 0, -8], "verticalFovDeg": 20},
      "render": {"filter": "box", "maxDepth": 1}, "environment": {"color": 1},
      "textures": {"t": {"generator": "checkerboard", "even": 0.9, "odd": 0.1, "scale": [8, 8])") +
                                                  filter + R"(}},
      "materials": {"m": {"type": "diffuse", "color": {"texture": "t"}}},
      "objects": [{"type": "plane", "material": "m", "point": [0, 0, 0], "normal": [0, 1, 0]}]})"},
                               {});
    EXPECT_TRUE(scene) << scene.error().format();
    return std::move(*scene);
}

TEST(Mipmaps, MakeFarChecksGreyAtOnce) {
    const Film nearest = renderFilm(checkedFloor(""), 64);
    const Film mipmap = renderFilm(checkedFloor(R"(, "filter": "mipmap")"), 64);
    const Estimate a = meanLuminance(nearest, 0, 16, 32, 32), b = meanLuminance(mipmap, 0, 16, 32, 32);
    EXPECT_NEAR(a.mean, 0.5, 0.01);
    EXPECT_NEAR(b.mean, 0.5, 0.01);
    EXPECT_LT(b.standardError, 0.5 * a.standardError) << "less noise at equal passes";
}

TEST(Mipmaps, FilterEmissionThatTheCameraSees) {
    Film films[2] = {Film(1, 1), Film(1, 1)};
    for (const bool isMapped : {false, true}) {
        SceneDescription scene =
            checkedFloor(isMapped ? R"(, "filter": "mipmap")" : R"(, "filter": "bilinear")");
        scene.materials[0].emission.texture = 0;
        scene.materials[0].color = {Vec3(0.0f), -1};
        films[isMapped ? 1 : 0] = renderFilm(scene, 64);
    }
    const Estimate a = meanLuminance(films[0], 0, 16, 32, 32), b = meanLuminance(films[1], 0, 16, 32, 32);
    EXPECT_NEAR(b.mean, 0.5, 0.01);
    EXPECT_LT(b.standardError, 0.5 * a.standardError);
}

TEST(Mipmaps, FlattenBumpsThatAPixelCovers) {
    SceneDescription scene = checkedFloor(R"(, "filter": "mipmap")");
    scene.materials[0].bump.texture = 0;
    scene.materials[0].bumpHeight = 0.1f;
    const auto built = buildAll(scene);
    const SceneView view = built->view();
    const Ray ray{{0.06f, 1.0f, 0.03f}, {0.0f, -1.0f, 0.0f}, 0.0f, kInfinity};
    Hit hit;
    ASSERT_TRUE(intersect<kAllFeatures>(view, ray, &hit));
    EXPECT_LT(surfaceAt<kAllFeatures>(view, ray, hit).ns.y, 0.9f) << "an edge of a square";
    EXPECT_GT(surfaceAt<kAllFeatures>(view, ray, hit, 4.0f).ns.y, 0.9999f);
}

TEST(Mipmaps, AVisiblePointKeepsWhatAPixelCovers) {
    for (const float width : {1e-5f, 0.003f, 0.7f, 20.0f}) {
        EXPECT_NEAR(uvWidthIn(withUvWidth(0.0123f, width)) / width, 1.0f, 0.07f);
        EXPECT_NEAR(withUvWidth(0.0123f, width), 0.0123f, 1e-6f);
    }
    const auto built = buildAll(checkedFloor(R"(, "filter": "mipmap")"));
    SppmParams params;
    params.pass.width = params.pass.height = 32;
    VisiblePoint near, far;
    traceVisiblePoint<kAllFeatures>(built->view(), params, 16, 31, &near);
    traceVisiblePoint<kAllFeatures>(built->view(), params, 16, 17, &far);
    const float nearWidth = detail::uvWidthOfPoint<kAllFeatures>(built->view(), near);
    EXPECT_GT(nearWidth, 0.0f);
    EXPECT_GT(detail::uvWidthOfPoint<kAllFeatures>(built->view(), far), 2.0f * nearWidth);
}

TEST(Checkerboard, HasItsSquaresWhereUvSay) {
    const SceneDescription scene = checkedFloor("");
    ASSERT_EQ(scene.textures.size(), 1u);
    const ImageF& image = *scene.textures[0].image.floats;
    TextureView view = viewOf(image);
    view.filter = scene.textures[0].filter;
    for (int i = 0; i < 6; ++i) {
        for (int j = 0; j < 6; ++j) {
            const Vec2 uv(0.5f * static_cast<float>(i) + 0.2f, 0.5f * static_cast<float>(j) + 0.2f);
            EXPECT_FLOAT_EQ(sampleTexture(view, uv).x, (i + j) % 2 == 0 ? 0.9f : 0.1f) << i << " " << j;
        }
    }
    const auto text = writeSceneJson(scene, "saved.json");
    ASSERT_TRUE(text.ok()) << text.error().format();
    const auto again = readSceneJson({"saved.json", *text}, {});
    ASSERT_TRUE(again) << again.error().format();
    EXPECT_EQ(again->textures[0].image.source, scene.textures[0].image.source);
    EXPECT_EQ(again->textures[0].filter, TexelFilter::Nearest);
    EXPECT_EQ(again->textures[0].scale, Vec2(8.0f));
}

}  // namespace
}  // namespace glint::test
