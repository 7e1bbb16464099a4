// Netpbm's pictures beyond grey and colour: black and white, alpha, floats.
#include <cmath>
#include <cstring>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/image_io.h"

namespace glint {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// The first channel of each pixel.
std::vector<int> greyOf(const std::string& bytes) {
    const auto image = decodeImage(bytes, "a");
    EXPECT_TRUE(image) << image.error().format();
    std::vector<int> grey;
    for (size_t i = 0; image && i < image->bytes->rgb.size(); i += 3) {
        grey.push_back(image->bytes->rgb[i]);
        EXPECT_EQ(image->bytes->rgb[i + 2], grey.back());
    }
    return grey;
}

TEST(Netpbm, BlackAndWhite) {
    for (const char* text : {"P1\n3 2\n1 0 1\n0 0 1\n", "P1 # c\n3 2\n101001", "P1 3 2\n1 0\n1 0 #c\n0 1"}) {
        EXPECT_THAT(greyOf(text), ElementsAre(0, 255, 0, 255, 255, 0)) << text;
    }
    EXPECT_THAT(greyOf("P4\n3 2\n\xa0\x20"), ElementsAre(0, 255, 0, 255, 255, 0)) << "rows begin with a byte";
    EXPECT_THAT(greyOf("P4 9 1\n\x7f\xff"), ElementsAre(255, 0, 0, 0, 0, 0, 0, 0, 0));
    for (const std::string bytes :
         {"P1\n3 2\n1 0 1\n0 0\n", "P1\n3 2\n1 0 2 0 0 1\n", "P4\n9 2\n\x7f\xff\x7f", "P4\n900 900\n\x7f"}) {
        EXPECT_FALSE(decodeImage(bytes, "a")) << bytes;
    }
}

TEST(Netpbm, WithAlpha) {
    const std::string size = "WIDTH 2\nHEIGHT 1\n", end = "ENDHDR\n";
    EXPECT_THAT(
        greyOf("P7\n" + size + "DEPTH 1\nMAXVAL 1\nTUPLTYPE BLACKANDWHITE\n" + end + std::string("\1\0", 2)),
        ElementsAre(255, 0));
    const auto grey = decodeImage("P7\nDEPTH 2\nMAXVAL 255\n# c\n" + size + end + "\x10\x20\x30\xff", "a");
    ASSERT_TRUE(grey) << grey.error().format();
    EXPECT_THAT(grey->bytes->alpha, ElementsAre(0x20, 0xff));
    EXPECT_EQ(grey->bytes->rgb[3], 0x30);
    const auto wide = decodeImage(
        "P7\n" + size + "DEPTH 3\nMAXVAL 65535\n" + end + std::string("\xff\xff\0\0\x80\x80\0\0\0\0\0\0", 12),
        "a");
    ASSERT_TRUE(wide) << wide.error().format();
    EXPECT_THAT(wide->bytes->rgb, ElementsAre(255, 0, 128, 0, 0, 0));
    for (const std::string& bytes :
         {"P7\n" + size + "DEPTH 5\nMAXVAL 255\n" + end + "1234567890", "P7\n" + size + end.substr(0, 3),
          "P7\n" + size + "DEPTH 1\nMAXVAL 0\n" + end + "12", "P7\n" + size + "SIZE 3\n" + end + "12"}) {
        EXPECT_FALSE(decodeImage(bytes, "a")) << bytes;
    }
}

TEST(Netpbm, OfFloats) {
    const auto stored = [](std::initializer_list<float> values, bool isBig) {
        std::string bytes;
        for (const float value : values) {
            char raw[4];
            std::memcpy(raw, &value, 4);
            if (isBig) { std::swap(raw[0], raw[3]), std::swap(raw[1], raw[2]); }
            bytes.append(raw, 4);
        }
        return bytes;
    };
    for (const auto& [bytes, name] :
         {std::pair{"PF\n1 2\n-1.0\n" + stored({4, 5, 1e5f, 0.5f, 0.25f, 3}, false), "little"},
          std::pair{"PF 1 2 1\n" + stored({4, 5, 1e5f, 0.5f, 0.25f, 3}, true), "big"}}) {
        const auto image = decodeImage(bytes, "a.pfm");
        ASSERT_TRUE(image) << image.error().format();
        EXPECT_THAT(image->floats->rgb, ElementsAre(0.5f, 0.25f, 3, 4, 5, 1e5f))
            << name << ": the lowest row is the first";
    }
    const auto grey = decodeImage("Pf\n2 1\n-1\n" + stored({4, 5}, false), "a");
    ASSERT_TRUE(grey) << grey.error().format();
    EXPECT_THAT(grey->floats->rgb, ElementsAre(4, 4, 4, 5, 5, 5));
    for (const std::string& bytes : {"PF\n1 2\n-1.0\n" + stored({4, 5}, false), std::string("PF\n1 2\n0\n"),
                                     std::string("Pf\n1000000 1000000\n1\nabcd"), std::string("PF\nx")}) {
        EXPECT_FALSE(decodeImage(bytes, "a")) << bytes;
    }
}

TEST(Netpbm, ImagesThatAreNotReadAreNamed) {
    const std::string box("\0\0\0\x1c", 4);
    const std::pair<std::string, const char*> files[] = {
        {box + "ftypheic", "is a HEIC file, which"},
        {box + "ftypmif1", "is a HEIC file, which"},
        {box + "ftypavif", "is a AVIF file, which"},
        {"\xabKTX 20\xbb", "is a KTX2 file, which"},
        {"\xabKTX 11\xbb", "is a KTX file, which"},
        {"\n<!doctype HTML>", "is a HTML file, which"},
        {"<?xml?><svg>", "is a SVG file, which"},
        {"version https://git-lfs.github.com/spec/v1\noid", "is a Git LFS pointer"}};
    for (const auto& [bytes, message] : files) {
        for (const char* name : {"a.png", "a.dat"}) {
            const auto image = decodeImage(bytes, name);
            ASSERT_FALSE(image) << message;
            EXPECT_THAT(image.error().format(), HasSubstr(message));
        }
    }
    EXPECT_THAT(decodeImage("?", "a.heic").error().format(), HasSubstr("is called a HEIC file"));
}

}  // namespace
}  // namespace glint
