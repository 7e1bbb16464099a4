// Environments from pictures as they come: with values that no light has, and as cube maps.
#include "engine/io/environment_image.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/exr_io.h"
#include "engine/io/scene_loader.h"
#include "tests/support/temp_folder.h"

namespace glint {
namespace {

using test::TempFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

SceneImage pictureOf(int width, int height, std::vector<float> rgb) {
    return {.floats = std::make_shared<const ImageF>(ImageF{width, height, std::move(rgb)})};
}

TEST(EnvironmentImage, TakesValuesThatLightCannotHaveForTheNearest) {
    constexpr float kInfinite = std::numeric_limits<float>::infinity();
    const SceneImage picture =
        pictureOf(2, 2, {1, -0.01f, 2, 3, kInfinite, 70'000, -0.02f, std::nanf(""), 0, 5, 6, 7});
    std::vector<std::string> warnings;
    const auto image = environmentImage(picture, "sky.exr", &warnings);
    EXPECT_THAT(image->rgb, ElementsAre(1, 0, 2, 3, 70'000, 70'000, 0, 0, 0, 5, 6, 7));
    EXPECT_THAT(warnings,
                ElementsAre(HasSubstr(
                    "sky.exr: 4 of its 12 values cannot be light (2 below 0, taken for 0, 1 not a "
                    "number, taken for 0, 1 infinite, taken for 70000), the first in column 0, row 0")));
}

TEST(EnvironmentImage, OfSoundValuesIsThePictureItself) {
    const SceneImage picture = pictureOf(2, 1, {1, 0, 2, 3, 4, 1e30f});
    std::vector<std::string> warnings;
    EXPECT_EQ(environmentImage(picture, "sky.exr", &warnings), picture.floats);
    EXPECT_THAT(warnings, IsEmpty());
}

/// Faces of one colour each, in OpenEXR's order: +x, -x, +y, -y, +z, -z.
TEST(EnvironmentImage, CubeMapsBecomeMapsOfAllDirections) {
    constexpr int kSide = 16;
    std::vector<float> rgb;
    for (int face = 0; face < 6; ++face) {
        for (int i = 0; i < kSide * kSide; ++i) {
            rgb.insert(rgb.end(), {static_cast<float>(face), static_cast<float>(face), 1.0f});
        }
    }
    std::vector<std::string> warnings;
    const auto map = environmentImage(pictureOf(kSide, 6 * kSide, std::move(rgb)), "cube.exr", &warnings);
    ASSERT_EQ(map->width, 64);
    ASSERT_EQ(map->height, 32);
    const auto face = [&](int x, int y) { return map->rgb[static_cast<size_t>(3 * (y * map->width + x))]; };
    // Longitude runs from pi on the left to -pi on the right; +z is in the middle and +x left of it.
    EXPECT_EQ(face(32, 16), 4.0f);
    EXPECT_EQ(face(16, 16), 0.0f);
    EXPECT_EQ(face(48, 16), 1.0f);
    EXPECT_EQ(face(0, 16), 5.0f);
    EXPECT_EQ(face(20, 0), 2.0f);
    EXPECT_EQ(face(20, 31), 3.0f);
}

TEST(EnvironmentImage, OfASceneIsRepairedWithOneWarning) {
    const TempFolder folder;
    ExrImage exr{.width = 8, .height = 4, .channels = {}, .attributes = {}};
    for (const auto& [name, value] : {std::pair{"R", -0.01f}, std::pair{"G", 0.4f}, std::pair{"B", 0.8f}}) {
        exr.channels.push_back({name, ExrPixelType::Float, std::vector<float>(32, value), {}});
    }
    ASSERT_TRUE(saveExr(folder.path("e.exr"), exr));
    const auto scene =
        loadScene(folder.write("a.json", R"({"glint": 1, "environment": {"image": {"file": "e.exr"}}})"));
    ASSERT_TRUE(scene) << scene.error().format();
    EXPECT_THAT(scene->warnings,
                ElementsAre(HasSubstr("e.exr: 32 of its 96 values cannot be light (32 below 0")));
    EXPECT_THAT(std::vector(scene->environmentImages[0].floats->rgb.begin(),
                            scene->environmentImages[0].floats->rgb.begin() + 3),
                ElementsAre(0.0f, 0.4f, 0.8f));
}

}  // namespace
}  // namespace glint
