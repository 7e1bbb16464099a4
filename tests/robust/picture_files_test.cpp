// Pictures of every kind that is read: what they show, what a cut-off or damaged one does, and that nothing
// but the file decides.
#include "tests/support/picture_files.h"

#include <cmath>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <malloc.h>

#include "engine/io/environment_image.h"
#include "engine/io/image_formats.h"
#include "engine/io/image_io.h"
#include "tests/support/temp_folder.h"

namespace glint {
namespace {

using test::PictureFile;
using test::TempFolder;
using testing::HasSubstr;

std::vector<PictureFile> allFiles() {
    std::vector<PictureFile> files = test::pictureFiles();
    std::ranges::move(test::floatPictureFiles(), std::back_inserter(files));
    return files;
}

/// What is read, floats in steps of 1 / 255.
std::vector<int> valuesOf(const SceneImage& image) {
    if (image.bytes) { return {image.bytes->rgb.begin(), image.bytes->rgb.end()}; }
    std::vector<int> values;
    for (const float value : image.floats->rgb) {
        values.push_back(static_cast<int>(std::lround(value * 255.0f)));
    }
    return values;
}

TEST(PictureFiles, ShowTheirPixels) {
    for (const PictureFile& file : allFiles()) {
        SCOPED_TRACE(file.name);
        const Result<SceneImage> image = decodeImage(file.bytes, file.name);
        ASSERT_TRUE(image) << image.error().format();
        EXPECT_EQ(imageFormatOf("", file.bytes), imageFormatOf(file.name, ""))
            << "told by name and content alike";
        const std::vector<int> values = valuesOf(*image);
        ASSERT_EQ(values.size(), file.pixels.rgb.size());
        for (size_t i = 0; i < values.size(); ++i) {
            EXPECT_NEAR(values[i], file.pixels.rgb[i], file.tolerance) << "value " << i;
        }
        if (image->bytes) {
            EXPECT_EQ(image->bytes->width, 6);
            EXPECT_EQ(image->bytes->alpha, file.pixels.alpha);
        }
    }
}

/// The bits of a picture, or "" where it is refused.
std::string decoded(const std::string& bytes, const std::string& name) {
    const Result<SceneImage> image = decodeImage(bytes, name);
    if (!image) {
        EXPECT_FALSE(image.error().message.empty());
        return "";
    }
    if (image->bytes) {
        std::string out(image->bytes->rgb.begin(), image->bytes->rgb.end());
        return out + std::string(image->bytes->alpha.begin(), image->bytes->alpha.end());
    }
    return {reinterpret_cast<const char*>(image->floats->rgb.data()),
            image->floats->rgb.size() * sizeof(float)};
}

TEST(PictureFiles, CutOffOnesAreRefusedUnlessNoPixelIsMissing) {
    for (const PictureFile& file : allFiles()) {
        const std::string whole = decoded(file.bytes, file.name);
        // Digits that are missing at the end of a text nobody can miss.
        const size_t end =
            file.name == "text.ppm" ? file.bytes.rfind(' ', file.bytes.size() - 2) : file.bytes.size();
        for (size_t size = 0; size < end; ++size) {
            const std::string cut = decoded(file.bytes.substr(0, size), file.name);
            EXPECT_TRUE(cut.empty() || cut == whole) << file.name << ", its first " << size << " bytes";
        }
    }
}

std::string damaged(std::string bytes, std::mt19937& random) {
    for (size_t changes = 1 + random() % 3; changes > 0; --changes) {
        bytes[random() % bytes.size()] = static_cast<char>(random());
    }
    return random() % 4 == 0 ? bytes.substr(0, random() % bytes.size()) : bytes;
}

/// What memory held before must not show: malloc fills what it hands out with one pattern, then with another.
TEST(PictureFiles, DamagedOnesShowNothingOfTheMemory) {
    std::mt19937 random(11);
    for (const PictureFile& file : allFiles()) {
        for (int round = 0; round < 100; ++round) {
            const std::string bytes = damaged(file.bytes, random);
            mallopt(M_PERTURB, 0x5a);
            const std::string first = decoded(bytes, file.name);
            mallopt(M_PERTURB, 0xc3);
            const std::string second = decoded(bytes, file.name);
            mallopt(M_PERTURB, 0);
            ASSERT_TRUE(first == second) << file.name << ", round " << round;
        }
    }
}

TEST(PictureFiles, PngWithAWrongChecksumIsRefused) {
    for (const PictureFile& file : test::pictureFiles()) {
        if (!file.name.ends_with(".png")) { continue; }
        for (const char* chunk : {"IHDR", "PLTE", "IDAT", "IEND"}) {
            const size_t at = file.bytes.find(chunk);
            if (at == std::string::npos) { continue; }
            std::string bytes = file.bytes;
            const auto length = static_cast<size_t>(static_cast<uint8_t>(bytes[at - 1])) +
                                256 * static_cast<size_t>(static_cast<uint8_t>(bytes[at - 2]));
            bytes[at + 4 + length] ^= 1;
            const Result<SceneImage> image = decodeImage(bytes, file.name);
            ASSERT_FALSE(image) << file.name << " " << chunk;
            EXPECT_THAT(image.error().format(), HasSubstr("CRC")) << file.name << " " << chunk;
        }
    }
}

TEST(PictureFiles, PngWithAPixelOutsideOfItsPaletteIsRefused) {
    for (const int bits : {2, 8}) {
        EXPECT_TRUE(decodeImage(test::palettePng(4, bits), "a.png")) << bits;
        const auto image = decodeImage(test::palettePng(3, bits), "a.png");
        ASSERT_FALSE(image) << bits;
        EXPECT_THAT(image.error().format(),
                    HasSubstr("the pixel in column 3, row 0 has colour 3 of a palette of 3"));
    }
}

void expectOrientations(std::string (*file)(int orientation)) {
    // Where the white half of the stored picture, its left one, is shown.
    const char* const kWhite[] = {"left", "right", "right", "left", "top", "top", "bottom", "bottom"};
    for (int orientation = 1; orientation <= 8; ++orientation) {
        const auto image = decodeImage(file(orientation), "a");
        ASSERT_TRUE(image) << image.error().format();
        const Image8& pixels = *image->bytes;
        EXPECT_EQ(pixels.width, orientation < 5 ? 16 : 8);
        const auto isWhite = [&](int x, int y) {
            return pixels.rgb[static_cast<size_t>(3 * (y * pixels.width + x))] > 128;
        };
        const int right = pixels.width - 1, bottom = pixels.height - 1;
        const std::string white = isWhite(0, 0) && isWhite(0, bottom)           ? "left"
                                  : isWhite(right, 0) && isWhite(right, bottom) ? "right"
                                  : isWhite(0, 0) && isWhite(right, 0)          ? "top"
                                                                                : "bottom";
        EXPECT_EQ(white, kWhite[orientation - 1]) << "orientation " << orientation;
    }
}

TEST(PictureFiles, JpegAndWebpFollowTheOrientationOfTheirExif) {
    expectOrientations(test::jpegWithOrientation);
    expectOrientations(test::webpWithOrientation);
}

TEST(PictureFiles, DdsBlocksOfOneChannelHoldEightValues) {
    // 4 x 4 pixels, whose choices count 0 to 7, twice.
    const auto valuesBetween = [](int first, int second) {
        std::string bytes = "DDS " + test::little(124, 4) + test::little(0x1007, 4) + test::little(4, 4) +
                            test::little(4, 4) + std::string(56, '\0') + test::little(32, 4) +
                            test::little(4, 4) + "BC4U" + std::string(40, '\0');
        bytes +=
            test::little(static_cast<uint64_t>(first), 1) + test::little(static_cast<uint64_t>(second), 1);
        bytes += test::little(0xfac688, 3) + test::little(0xfac688, 3);
        const auto image = decodeImage(bytes, "a.dds");
        EXPECT_TRUE(image) << image.error().format();
        std::vector<int> values;
        for (size_t i = 0; image && i < 8; ++i) {
            values.push_back(image->bytes->rgb[3 * i]);
        }
        return values;
    };
    EXPECT_THAT(valuesBetween(210, 0), testing::ElementsAre(210, 0, 180, 150, 120, 90, 60, 30));
    EXPECT_THAT(valuesBetween(50, 100), testing::ElementsAre(50, 100, 60, 70, 80, 90, 0, 255));
}

TEST(PictureFiles, DdsPixelsThatAreNotReadAreNamed) {
    const std::string bytes = "DDS " + test::little(124, 4) + test::little(0x1007, 4) + test::little(4, 4) +
                              test::little(4, 4) + std::string(56, '\0') + test::little(32, 4) +
                              test::little(4, 4) + "DX10" + std::string(40, '\0') + test::little(98, 4) +
                              std::string(32, '\0');
    const auto image = decodeImage(bytes, "a.dds");
    ASSERT_FALSE(image);
    EXPECT_THAT(image.error().format(), HasSubstr("has DDS pixels of kind BC7; expected DXT1"));
}

/// Six faces of 16 x 16 pixels with smaller copies, which show where they lie in Direct3D's space: x, y and z
/// from 0 to 1.
std::string ddsCube(bool isFloat, uint32_t caps) {
    constexpr int kSize = 16;
    std::string bytes = "DDS " + test::little(124, 4) + test::little(0x21007, 4) + test::little(kSize, 4) +
                        test::little(kSize, 4) + std::string(8, '\0') + test::little(5, 4) +
                        std::string(44, '\0') + test::little(32, 4) + test::little(isFloat ? 4 : 0x40, 4) +
                        test::little(isFloat ? 116 : 0, 4) + test::little(24, 4) + test::little(0xff, 4) +
                        test::little(0xff00, 4) + test::little(0xff0000, 4) + test::little(0, 4) +
                        test::little(0x1000, 4) + test::little(caps, 4) + std::string(12, '\0');
    // The middle of each face, and the directions to its right and to its bottom.
    const Vec3 kFaces[][3] = {{{1, 0, 0}, {0, 0, -1}, {0, -1, 0}}, {{-1, 0, 0}, {0, 0, 1}, {0, -1, 0}},
                              {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}},   {{0, -1, 0}, {1, 0, 0}, {0, 0, -1}},
                              {{0, 0, 1}, {1, 0, 0}, {0, -1, 0}},  {{0, 0, -1}, {-1, 0, 0}, {0, -1, 0}}};
    for (const auto& [middle, right, down] : kFaces) {
        for (int i = 0; i < kSize * kSize; ++i) {
            const float s = 2.0f * static_cast<float>(i % kSize) / (kSize - 1) - 1.0f;
            const float t = 2.0f * static_cast<float>(i / kSize) / (kSize - 1) - 1.0f;
            const Vec3 shown = 0.5f * glm::normalize(middle + s * right + t * down) + Vec3(0.5f);
            for (int c = 0; c < 3; ++c) {
                if (isFloat) {
                    bytes.append(reinterpret_cast<const char*>(&shown[c]), 4);
                } else {
                    bytes += static_cast<char>(std::lround(255.0f * shown[c]));
                }
            }
            if (isFloat) { bytes += std::string(4, '\0'); }
        }
        bytes += std::string((isFloat ? 16 : 3) * (64 + 16 + 4 + 1), '\x3f');  // smaller copies
    }
    return bytes;
}

TEST(PictureFiles, DdsCubeMapsAreEnvironments) {
    for (const bool isFloat : {false, true}) {
        auto cube = decodeImage(ddsCube(isFloat, 0xfe00), "a.dds");
        ASSERT_TRUE(cube) << cube.error().format();
        if (cube->bytes) {  // the numbers as they are
            auto numbers = std::make_shared<ImageF>(ImageF{cube->bytes->width, cube->bytes->height, {}});
            for (const uint8_t byte : cube->bytes->rgb) {
                numbers->rgb.push_back(static_cast<float>(byte) / 255.0f);
            }
            *cube = {.source = {}, .bytes = nullptr, .floats = numbers};
        }
        std::vector<std::string> warnings;
        const auto map = environmentImage(*cube, "a.dds", &warnings).floats;
        ASSERT_EQ(map->width, 64);
        for (int i = 0; i < 64 * 32; ++i) {
            const float latitude = kPi * (0.5f - (static_cast<float>(i / 64) + 0.5f) / 32.0f);
            const float longitude = kPi * (1.0f - 2.0f * (static_cast<float>(i % 64) + 0.5f) / 64.0f);
            const Vec3 d(std::sin(longitude) * std::cos(latitude), std::sin(latitude),
                         std::cos(longitude) * std::cos(latitude));
            const Vec3 shown = 0.5f * Vec3(d.x, d.y, -d.z) + Vec3(0.5f);
            for (int c = 0; c < 3; ++c) {
                ASSERT_NEAR(map->rgb[3 * static_cast<size_t>(i) + static_cast<size_t>(c)], shown[c], 0.02f)
                    << i;
            }
        }
    }
    const auto part = decodeImage(ddsCube(false, 0x600), "a.dds");
    ASSERT_FALSE(part);
    EXPECT_THAT(part.error().format(), HasSubstr("is part of a cube map"));
    const std::string whole = ddsCube(true, 0xfe00);
    EXPECT_FALSE(decodeImage(whole.substr(0, whole.size() - 16 * 100), "a.dds"));
}

TEST(PictureFiles, XyzeHasItsColours) {
    // Y = 0.5 of D65's white: X = 0.9505 Y, Z = 1.089 Y.
    std::string bytes = "#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n";
    for (const int value : {122, 128, 139, 128}) {
        bytes += static_cast<char>(value);
    }
    const auto image = decodeImage(bytes, "a.hdr");
    ASSERT_TRUE(image) << image.error().format();
    for (const float value : image->floats->rgb) {
        EXPECT_NEAR(value, 0.5f, 0.01f);
    }
    const auto other = decodeImage("#?RADIANCE\nFORMAT=32-bit_yuv\n\n-Y 1 +X 1\nabcd", "a.hdr");
    ASSERT_FALSE(other);
    EXPECT_THAT(other.error().format(), HasSubstr("32-bit_yuv"));
}

/// 15 GB of zeros that take no room on the disk: their first bytes decide.
TEST(PictureFiles, WhatIsNoPictureIsNotReadWhole) {
    const TempFolder folder;
    const std::string path = folder.write("sparse.png", "no picture");
    std::error_code error;
    std::filesystem::resize_file(path, uintmax_t{15} << 30, error);
    if (error) { GTEST_SKIP() << "the disk has no sparse files: " << error.message(); }
    const Result<std::string> bytes = readImageFile(path);
    ASSERT_TRUE(bytes) << bytes.error().format();
    EXPECT_LE(bytes->size(), 4096u);
    const auto image = loadImage(path);
    ASSERT_FALSE(image);
    EXPECT_THAT(image.error().format(), HasSubstr("is not an image that can be read"));
}

}  // namespace
}  // namespace glint
