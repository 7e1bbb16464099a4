// Pictures of turned, moved, mirrored and clamped textures beside those of images that were changed by hand.
#include <functional>

#include <gtest/gtest.h>

#include "engine/io/scene_json.h"
#include "engine/render/pass_params.h"
#include "tests/support/render_scene.h"
#include "tests/support/sppm_render.h"

namespace glint {
namespace {

/// 4 x 3 texels, no two alike.
Image8 smallImage() {
    Image8 image{4, 3, {}};
    for (int i = 0; i < 12; ++i) {
        for (const int value : {20 * i + 5, 250 - 20 * i, 40 * (i % 5) + 10}) {
            image.rgb.push_back(static_cast<uint8_t>(value));
        }
    }
    return image;
}

/// Texel (x, y) of the result is source(x, y) of `image`.
Image8 rearranged(const Image8& image, int width, int height,
                  const std::function<std::pair<int, int>(int, int)>& source) {
    Image8 out{width, height, {}};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const auto [column, row] = source(x, y);
            const auto first = image.rgb.begin() + 3 * (row * image.width + column);
            out.rgb.insert(out.rgb.end(), first, first + 3);
        }
    }
    return out;
}

/// A square under an even sky, seen from above, with the texture.
SceneDescription sceneOf(const Image8& image, const std::string& placement) {
    auto scene = readSceneJson({"scene.json", R"({"glint": 1, "resolution": [32, 32],
      "camera": {"position": [0, 0, 4], "target": [0, 0, 0], "verticalFovDeg": 24},
      "render": {"filter": "box"}, "environment": {"color": 1},
      "textures": {"t": {"file": "none.png")" + placement +
                                                  R"(}},
      "materials": {"m": {"type": "diffuse"}},
      "objects": [{"type": "rectangle", "material": "m"}]})"},
                               {});
    EXPECT_TRUE(scene) << scene.error().format();
    scene->textures[0].image = {.bytes = std::make_shared<const Image8>(image)};
    scene->materials[0].color.texture = 0;
    return std::move(*scene);
}

void expectSamePicture(const SceneDescription& placed, const SceneDescription& plain) {
    const Film a = test::renderFilm(placed, 4), b = test::renderFilm(plain, 4);
    double brightest = 0.0, darkest = 1e9;
    for (int y = 0; y < 32; ++y) {
        for (int x = 0; x < 32; ++x) {
            const double mean = test::meanLuminance(a, x, y, x + 1, y + 1).mean;
            ASSERT_NEAR(mean, test::meanLuminance(b, x, y, x + 1, y + 1).mean, 1e-4) << x << " " << y;
            brightest = std::max(brightest, mean);
            darkest = std::min(darkest, mean);
        }
    }
    EXPECT_GT(brightest, darkest + 0.2) << "there is something to see";
}

TEST(PlacedTextures, MirrorIsTheImageBesideItsReflection) {
    const Image8 image = smallImage();
    const Image8 both = rearranged(image, 8, 6, [](int x, int y) {
        return std::pair(x < 4 ? x : 7 - x, y < 3 ? 2 - y : y - 3);  // row 0 is the top one, where v is 1
    });
    expectSamePicture(sceneOf(image, R"(, "scale": [3, 3], "wrapU": "mirror", "wrapV": "mirror")"),
                      sceneOf(both, R"(, "scale": [1.5, 1.5])"));
}

TEST(PlacedTextures, ClampIsTheImageWithAWideEdge) {
    const Image8 image = smallImage();
    const Image8 wide = rearranged(image, 12, 9, [](int x, int y) {
        return std::pair(std::clamp(x - 4, 0, 3), std::clamp(y - 3, 0, 2));
    });
    expectSamePicture(
        sceneOf(image, R"(, "scale": [3, 3], "offset": [-1, -1], "wrapU": "clamp", "wrapV": "clamp")"),
        sceneOf(wide, ""));
}

TEST(PlacedTextures, AQuarterTurnIsTheTurnedImage) {
    const Image8 image = smallImage();
    // (u, v) becomes (-v, u).
    const Image8 turned = rearranged(image, 3, 4, [](int x, int y) { return std::pair(y, 2 - x); });
    expectSamePicture(sceneOf(image, R"(, "rotationDeg": 90)"), sceneOf(turned, ""));
}

TEST(PlacedTextures, PhotonMappingSeesTheSame) {
    const SceneDescription scene = sceneOf(
        smallImage(), R"(, "scale": [2, 2], "offset": [0.2, 0], "wrapU": "clamp", "filter": "nearest")");
    const std::vector<Vec3> paths = test::renderPaths(scene, 1, 16);
    const std::vector<Vec3> photons = test::renderSppm(scene, sppmParamsOf(scene), 16).image;
    for (int block = 0; block < 16; ++block) {
        const int x = block % 4 * 8, y = block / 4 * 8;
        EXPECT_NEAR(test::blockMean(paths, 32, x, y, 8), test::blockMean(photons, 32, x, y, 8), 0.01)
            << block;
    }
}

}  // namespace
}  // namespace glint
