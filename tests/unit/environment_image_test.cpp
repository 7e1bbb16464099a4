// Environments from pictures as they come: with values that no light has, and as cube maps.
#include "engine/io/environment_image.h"

#include <cmath>
#include <limits>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/exr_io.h"
#include "engine/io/image_io.h"
#include "engine/io/scene_loader.h"
#include "engine/render/memory_use.h"
#include "engine/scene/scene_hash.h"
#include "tests/support/film_bits.h"
#include "tests/support/render_scene.h"
#include "tests/support/temp_folder.h"
#include "tests/support/test_scenes.h"

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
        pictureOf(4, 2, {1, -0.01f, 2, 3, kInfinite, 70'000, -0.02f, std::nanf(""), 0, 5, 6, 7, 0, 0, 0, 0, 0,
                         0, 0,      0, 0, 0,         0,      0});
    std::vector<std::string> warnings;
    const auto image = environmentImage(picture, "sky.exr", &warnings).floats;
    EXPECT_THAT(image->rgb, ElementsAre(1, 0, 2, 3, 70'000, 70'000, 0, 0, 0, 5, 6, 7, 0, 0, 0, 0, 0, 0, 0, 0,
                                        0, 0, 0, 0));
    EXPECT_THAT(warnings,
                ElementsAre(HasSubstr(
                    "sky.exr: 4 of its 24 values cannot be light (2 below 0, taken for 0, 1 not a "
                    "number, taken for 0, 1 infinite, taken for 70000), the first in column 0, row 0")));
}

TEST(EnvironmentImage, OfSoundValuesIsThePictureItself) {
    const SceneImage picture = pictureOf(2, 1, {1, 0, 2, 3, 4, 1e12f});
    std::vector<std::string> warnings;
    EXPECT_EQ(environmentImage(picture, "sky.exr", &warnings).floats, picture.floats);
    EXPECT_THAT(warnings, IsEmpty());
}

TEST(EnvironmentImage, StaysInBytesWithoutAlpha) {
    const SceneImage bytes = test::checkerImage(16, 8, false);
    std::vector<std::string> warnings;
    EXPECT_EQ(environmentImage(bytes, "sky.png", &warnings).bytes, bytes.bytes);
    Image8 clear = *bytes.bytes;
    clear.alpha.assign(16 * 8, 3);
    const SceneImage image =
        environmentImage({.bytes = std::make_shared<Image8>(clear)}, "sky.png", &warnings);
    EXPECT_EQ(image.bytes->rgb, bytes.bytes->rgb);
    EXPECT_TRUE(image.bytes->alpha.empty());
    EXPECT_THAT(warnings, IsEmpty());
    const SceneImage square = test::checkerImage(9, 9, false);
    EXPECT_EQ(environmentImage(square, "sky.png", &warnings).bytes, square.bytes);
    EXPECT_THAT(warnings, ElementsAre(HasSubstr("a picture of 9 x 9 pixels")));
}

/// The same light from bytes as from what they stand for in linear floats, at 7 instead of 16 bytes a pixel.
TEST(EnvironmentImage, BytesShineAsTheirFloatsDo) {
    SceneDescription scene = test::meshInstances();
    scene.resolution = {24, 16};
    scene.environmentImages[0] = test::checkerImage(64, 32, false);
    SceneDescription linear = scene;
    linear.environmentImages[0] = {
        .source = {}, .bytes = {}, .floats = linearColors(scene.environmentImages[0])};
    test::expectSameBits(test::renderPasses(scene, 2, 2), test::renderPasses(linear, 2, 2));
    EXPECT_EQ(hashSceneParts(scene), hashSceneParts(linear));

    const auto bytesOf = [](const SceneDescription& description) {
        return memoryOf(*test::buildAll(description))[MemoryPart::Environment];
    };
    constexpr uint64_t kPixels = 64 * 32, kRows = 32 + 33;  // ends of rows, and the rows' own distribution
    EXPECT_EQ(bytesOf(linear), 16 * kPixels + 4 * kRows);
    EXPECT_EQ(bytesOf(scene), 7 * kPixels + 4 * kRows + 4 * 256);
}

TEST(EnvironmentImage, TakesAbsurdlyBrightValuesForTheLargestOther) {
    for (const float value : {3e38f, 1e30f, 2e12f, std::numeric_limits<float>::infinity()}) {
        std::vector<std::string> warnings;
        EXPECT_THAT(
            environmentImage(pictureOf(2, 1, {1, 2, value, 3, 4, 5}), "sky.exr", &warnings).floats->rgb,
            ElementsAre(1, 2, 65504, 3, 4, 5));
        EXPECT_THAT(warnings, ElementsAre(HasSubstr("1 of its 6 values cannot be light")));
        EXPECT_THAT(warnings, ElementsAre(HasSubstr("taken for 65504")));
    }
}

/// Squares of one value each, `side` pixels wide, in rows.
SceneImage squares(const std::vector<std::vector<float>>& rows, int side) {
    std::vector<float> rgb;
    for (size_t y = 0; y < rows.size() * static_cast<size_t>(side); ++y) {
        for (const float value : rows[y / static_cast<size_t>(side)]) {
            rgb.insert(rgb.end(), 3 * static_cast<size_t>(side), value);
        }
    }
    const int columns = static_cast<int>(rows[0].size()), lines = static_cast<int>(rows.size());
    return pictureOf(columns * side, lines * side, std::move(rgb));
}

/// Direct3D's +x, -x, +y, -y, +z, -z are 1 to 6; what is in front, +z, is the scene's -z, at the map's sides.
TEST(EnvironmentImage, StripsAndCrossesAreCubeMaps) {
    for (const auto& rows : {std::vector<std::vector<float>>{{1, 2, 3, 4, 5, 6}},
                             {{0, 3, 0, 0}, {2, 5, 1, 6}, {0, 4, 0, 0}},
                             {{9, 3, 9}, {2, 5, 1}, {0, 4, 7}, {9, 6, 9}}}) {
        for (const int side : {8, 17}) {
            std::vector<std::string> warnings;
            const auto map = environmentImage(squares(rows, side), "cube.exr", &warnings).floats;
            EXPECT_THAT(warnings, IsEmpty());
            ASSERT_EQ(map->width, 4 * side);
            ASSERT_EQ(map->height, 2 * side);
            const auto face = [&](int x, int y) {
                return map->rgb[static_cast<size_t>(3 * (y * map->width + x))];
            };
            EXPECT_EQ(face(0, side), 5.0f);
            EXPECT_EQ(face(side, side), 1.0f) << "right of the front";
            EXPECT_EQ(face(2 * side, side), 6.0f);
            EXPECT_EQ(face(3 * side, side), 2.0f);
            EXPECT_EQ(face(2 * side, 0), 3.0f);
            EXPECT_EQ(face(2 * side, 2 * side - 1), 4.0f);
        }
    }
}

/// What adjoins in a cross adjoins in the map: brightness that only grows with the height has no seams.
TEST(EnvironmentImage, FacesOfCrossesLieTheRightWayUp) {
    constexpr int kSide = 32;
    const Vec3 front(0, 0, -1), right(1, 0, 0), up(0, 1, 0);
    const auto cross = [&](int columns, int rows) {
        std::vector<float> rgb;
        for (int y = 0; y < rows * kSide; ++y) {
            for (int x = 0; x < columns * kSide; ++x) {
                const int column = x / kSide, row = y / kSide;
                const float s = 2.0f * (static_cast<float>(x % kSide) + 0.5f) / kSide - 1.0f;
                const float t = 1.0f - 2.0f * (static_cast<float>(y % kSide) + 0.5f) / kSide;
                Vec3 d(0.0f);
                if (row == 1) {  // left, front, right, back
                    const Vec3 axes[] = {-right, front, right, -front},
                               sides[] = {front, right, -front, -right};
                    d = axes[column] + s * sides[column] + t * up;
                } else if (column == 1) {  // above, below, and the back below that
                    d = row == 0   ? up + s * right - t * front
                        : row == 2 ? -up + s * right + t * front
                                   : -front + s * right - t * up;
                }
                const Vec3 color = glm::length(d) > 0.0f ? Vec3(2.0f) + glm::normalize(d) : Vec3(0.0f);
                rgb.insert(rgb.end(), {color.x, color.y, color.z});
            }
        }
        return pictureOf(columns * kSide, rows * kSide, std::move(rgb));
    };
    for (const SceneImage& picture : {cross(4, 3), cross(3, 4)}) {
        std::vector<std::string> warnings;
        const auto map = environmentImage(picture, "cube.exr", &warnings).floats;
        EXPECT_THAT(warnings, IsEmpty());
        for (int y = 0; y < map->height; ++y) {
            for (int x = 0; x < map->width; ++x) {
                const float longitude =
                    2.0f * kPi * ((static_cast<float>(x) + 0.5f) / static_cast<float>(map->width));
                const float latitude =
                    kPi * (0.5f - (static_cast<float>(y) + 0.5f) / static_cast<float>(map->height));
                // The map begins and ends with the front, and goes on to its right.
                const Vec3 d =
                    std::cos(latitude) * (std::cos(longitude) * front + std::sin(longitude) * right) +
                    std::sin(latitude) * up;
                const float* rgb = &map->rgb[static_cast<size_t>(3 * (y * map->width + x))];
                ASSERT_NEAR(glm::length(Vec3(rgb[0], rgb[1], rgb[2]) - Vec3(2.0f) - d), 0.0f, 0.08f)
                    << x << " " << y;
            }
        }
    }
}

TEST(EnvironmentImage, OfOtherSidesIsReadWithAWarning) {
    std::vector<float> noise;
    for (int i = 0; i < 3 * 24 * 24; ++i) {
        noise.push_back(static_cast<float>(i % 7));
    }
    for (const auto& [width, height] :
         {std::pair{8, 8}, std::pair{12, 9}, std::pair{9, 12}, std::pair{16, 4}}) {
        std::vector<std::string> warnings;
        const std::vector<float> rgb(noise.begin(), noise.begin() + 3 * width * height);
        const SceneImage picture = pictureOf(width, height, rgb);
        EXPECT_EQ(environmentImage(picture, "sky.exr", &warnings).floats, picture.floats);
        EXPECT_THAT(warnings, ElementsAre(HasSubstr("expected one twice as wide as high"))) << width;
    }
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
    const auto map =
        environmentImage(pictureOf(kSide, 6 * kSide, std::move(rgb)), "cube.exr", &warnings).floats;
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
