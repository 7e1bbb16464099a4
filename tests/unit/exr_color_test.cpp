// Which channels of an OpenEXR file are its colour, in which primaries, and where on the display they lie.
#include <cmath>
#include <random>
#include <sstream>

#include <ImfChannelList.h>
#include <ImfChromaticitiesAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfRgbaFile.h>
#include <ImfStandardAttributes.h>
#include <ImfTiledOutputFile.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <malloc.h>

#include "engine/io/exr_io.h"
#include "engine/io/image_io.h"
#include "tests/support/temp_folder.h"

namespace glint {
namespace {

using test::TempFolder;
using testing::HasSubstr;

constexpr int kWidth = 20, kHeight = 10;

struct Channel {
    std::string name;
    float value = 0.0f;  ///< of the first pixel; each pixel has 1 / 64 more than the one before
};

float valueAt(const Channel& channel, size_t pixel) {
    return channel.value + static_cast<float>(pixel) / 64.0f;
}

Imf::FrameBuffer frameOf(const std::vector<Channel>& channels, const Imath::Box2i& window,
                         std::vector<std::vector<float>>* values) {
    const auto width = static_cast<size_t>(window.max.x - window.min.x + 1);
    const auto height = static_cast<size_t>(window.max.y - window.min.y + 1);
    Imf::FrameBuffer frame;
    values->reserve(channels.size());
    for (const Channel& channel : channels) {
        std::vector<float>& own = values->emplace_back();
        for (size_t i = 0; i < width * height; ++i) {
            own.push_back(valueAt(channel, i));
        }
        frame.insert(channel.name,
                     Imf::Slice::Make(Imf::FLOAT, own.data(), window, sizeof(float), sizeof(float) * width));
    }
    return frame;
}

Imf::Header headerOf(const std::vector<Channel>& channels) {
    Imf::Header header(kWidth, kHeight);
    for (const Channel& channel : channels) {
        header.channels().insert(channel.name, Imf::Channel(Imf::FLOAT));
    }
    return header;
}

class ExrColor : public testing::Test {
  protected:
    std::string written(const std::vector<Channel>& channels, Imf::Header header) const {
        std::vector<std::vector<float>> values;
        const Imf::FrameBuffer frame = frameOf(channels, header.dataWindow(), &values);
        const std::string path = folder_.path("a.exr");
        if (header.hasTileDescription()) {
            Imf::TiledOutputFile file(path.c_str(), header);
            file.setFrameBuffer(frame);
            file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
        } else {
            Imf::OutputFile file(path.c_str(), header);
            file.setFrameBuffer(frame);
            file.writePixels(header.dataWindow().max.y - header.dataWindow().min.y + 1);
        }
        return TempFolder::read(path);
    }
    std::string written(const std::vector<Channel>& channels) const {
        return written(channels, headerOf(channels));
    }

    TempFolder folder_;
};

void expectFirstPixel(const Result<ExrColorImage>& image, const Vec3& color, float tolerance = 1e-6f) {
    ASSERT_TRUE(image) << image.error().format();
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(image->color.rgb[static_cast<size_t>(c)], color[c], tolerance) << "channel " << c;
    }
}

TEST_F(ExrColor, IsFoundInLayers) {
    const std::vector<Channel> layered{
        {"View.Combined.R", 1}, {"View.Combined.G", 2}, {"View.Combined.B", 3}, {"View.Depth.Z", 9}};
    expectFirstPixel(decodeExrColor(written(layered), "a"), {1, 2, 3});
    std::vector<Channel> several = layered;
    for (const char* name : {"View.Albedo.R", "View.Albedo.G", "View.Albedo.B"}) {
        several.push_back({name, 7});
    }
    expectFirstPixel(decodeExrColor(written(several), "a"), {1, 2, 3});
    several.insert(several.end(), {{"R", 4}, {"G", 5}, {"B", 6}});
    expectFirstPixel(decodeExrColor(written(several), "a"), {4, 5, 6});
    expectFirstPixel(
        decodeExrColor(written({{"rgba.r", 1}, {"rgba.g", 2}, {"rgba.b", 3}, {"rgba.a", 1}}), "a"),
        {1, 2, 3});
    const auto unclear = decodeExrColor(
        written({{"x.R", 1}, {"x.G", 1}, {"x.B", 1}, {"y.R", 1}, {"y.G", 1}, {"y.B", 1}}), "a");
    ASSERT_FALSE(unclear);
    EXPECT_THAT(unclear.error().format(), HasSubstr("in one layer, but found x.B, x.G, x.R, y.B, y.G, y.R"));
}

TEST_F(ExrColor, IsFoundInALaterPart) {
    Imf::Header depth = headerOf({{"Z", 9}}), color = headerOf({{"R", 1}, {"G", 2}, {"B", 3}});
    depth.setName("depth");
    color.setName("color");
    depth.setType(Imf::SCANLINEIMAGE);
    color.setType(Imf::SCANLINEIMAGE);
    const Imf::Header headers[] = {depth, color};
    const std::string path = folder_.path("a.exr");
    {
        Imf::MultiPartOutputFile file(path.c_str(), headers, 2);
        std::vector<std::vector<float>> first, second;
        Imf::OutputPart depthPart(file, 0), colorPart(file, 1);
        depthPart.setFrameBuffer(frameOf({{"Z", 9}}, depth.dataWindow(), &first));
        depthPart.writePixels(kHeight);
        colorPart.setFrameBuffer(frameOf({{"R", 1}, {"G", 2}, {"B", 3}}, color.dataWindow(), &second));
        colorPart.writePixels(kHeight);
    }
    expectFirstPixel(loadExrColor(path), {1, 2, 3});
}

TEST_F(ExrColor, OfLuminanceAndChroma) {
    const std::string path = folder_.path("a.exr");
    {
        Imf::RgbaOutputFile file(path.c_str(), 64, 32, Imf::WRITE_YC);
        const std::vector<Imf::Rgba> pixels(64 * 32, Imf::Rgba(0.2f, 0.4f, 0.8f));
        file.setFrameBuffer(pixels.data(), 1, 64);
        file.writePixels(32);
    }
    const auto image = loadExrColor(path);
    ASSERT_TRUE(image) << image.error().format();
    constexpr float expected[] = {0.2f, 0.4f, 0.8f};
    for (size_t i = 0; i < image->color.rgb.size(); ++i) {
        EXPECT_NEAR(image->color.rgb[i], expected[i % 3], 0.004f) << "value " << i;
    }
}

TEST_F(ExrColor, FollowsChromaticities) {
    const std::vector<Channel> white{{"R", 1}, {"G", 1}, {"B", 1}};
    Imf::Header header = headerOf(white);
    Imf::addChromaticities(header, Imf::Chromaticities({0.708f, 0.292f}, {0.170f, 0.797f}, {0.131f, 0.046f},
                                                       {0.3127f, 0.3290f}));
    expectFirstPixel(decodeExrColor(written(white, header), "a"), {1, 1, 1}, 1e-5f);
    // ITU-R BT.2087: Rec.2020's red in Rec.709.
    header = headerOf({{"R", 1}, {"G", 0}, {"B", 0}});
    Imf::addChromaticities(header, Imf::Chromaticities({0.708f, 0.292f}, {0.170f, 0.797f}, {0.131f, 0.046f},
                                                       {0.3127f, 0.3290f}));
    expectFirstPixel(decodeExrColor(written({{"R", 1}, {"G", 0}, {"B", 0}}, header), "a"),
                     {1.6605f, -0.1246f, -0.0182f}, 1e-4f);
    const std::vector<Channel> xyz{{"R", 0.95046f}, {"G", 1}, {"B", 1.08906f}};
    header = headerOf(xyz);
    Imf::addChromaticities(header, Imf::Chromaticities({1, 0}, {0, 1}, {0, 0}, {1 / 3.0f, 1 / 3.0f}));
    expectFirstPixel(decodeExrColor(written(xyz, header), "a"), {1, 1, 1}, 1e-3f);
}

TEST_F(ExrColor, LiesInTheDisplayWindow) {
    const std::vector<Channel> channels{{"R", 1}, {"G", 2}, {"B", 3}};
    Imf::Header header = headerOf(channels);
    header.dataWindow() = Imath::Box2i({-2, 3}, {1, 4});
    const auto image = decodeExrColor(written(channels, header), "a");
    ASSERT_TRUE(image) << image.error().format();
    EXPECT_EQ(image->color.width, kWidth);
    EXPECT_EQ(image->color.height, kHeight);
    const auto red = [&](int x, int y) {
        return image->color.rgb[static_cast<size_t>(3 * (y * kWidth + x))];
    };
    EXPECT_EQ(red(0, 3), valueAt(channels[0], 2)) << "the two columns before it are outside";
    EXPECT_EQ(red(1, 4), valueAt(channels[0], 7));
    EXPECT_EQ(red(2, 3), 0.0f);
    EXPECT_EQ(red(0, 2), 0.0f);
    header.displayWindow() = Imath::Box2i({0, 0}, {9'999, 9'999});
    const auto empty = decodeExrColor(written(channels, header), "a");
    ASSERT_FALSE(empty);
    EXPECT_THAT(empty.error().format(),
                HasSubstr("data of 4 x 2 pixels in a display window of 10000 x 10000"));
}

TEST_F(ExrColor, BesideTheDisplayWindowIsAllThereIs) {
    const std::vector<Channel> channels{{"R", 1}, {"G", 2}, {"B", 3}};
    for (const Imath::Box2i& data :
         {Imath::Box2i({kWidth, 0}, {kWidth + 3, 1}), Imath::Box2i({-9, -9}, {-6, -8}),
          Imath::Box2i({0, kHeight}, {3, kHeight + 1}), Imath::Box2i({2, -700}, {5, -699})}) {
        Imf::Header header = headerOf(channels);
        header.dataWindow() = data;
        const auto image = decodeExrColor(written(channels, header), "a");
        ASSERT_TRUE(image) << image.error().format();
        EXPECT_EQ(image->color.width, 4);
        EXPECT_EQ(image->color.height, 2);
        EXPECT_EQ(image->color.rgb.at(3 * 7), valueAt(channels[0], 7));
    }
}

/// All ways to store floats.
std::vector<Imf::Header> packings(const std::vector<Channel>& channels) {
    std::vector<Imf::Header> headers;
    for (const bool tiled : {false, true}) {
        for (const Imf::Compression packing :
             {Imf::NO_COMPRESSION, Imf::RLE_COMPRESSION, Imf::ZIPS_COMPRESSION, Imf::ZIP_COMPRESSION,
              Imf::PIZ_COMPRESSION, Imf::PXR24_COMPRESSION, Imf::B44_COMPRESSION, Imf::DWAA_COMPRESSION}) {
            Imf::Header header = headerOf(channels);
            header.compression() = packing;
            if (tiled) { header.setTileDescription(Imf::TileDescription(8, 8)); }
            headers.push_back(header);
        }
    }
    return headers;
}

TEST_F(ExrColor, OfEveryPackingAndInTiles) {
    const std::vector<Channel> channels{{"A", 1}, {"B", 3}, {"G", 2}, {"R", 1}, {"Z", 9}};
    for (const Imf::Header& header : packings(channels)) {
        SCOPED_TRACE(testing::Message()
                     << "compression " << header.compression() << ", tiles " << header.hasTileDescription());
        const auto image = decodeExrColor(written(channels, header), "a");
        ASSERT_TRUE(image) << image.error().format();
        ASSERT_EQ(image->color.rgb.size(), size_t{3} * kWidth * kHeight);
        const float tolerance = header.compression() == Imf::DWAA_COMPRESSION ? 0.1f : 1e-3f;
        for (size_t i = 0; i < image->color.rgb.size(); ++i) {
            ASSERT_NEAR(image->color.rgb[i], valueAt({"", static_cast<float>(i % 3 + 1)}, i / 3), tolerance)
                << "value " << i;
        }
    }
}

TEST_F(ExrColor, OfDamagedFilesShowsNothingOfTheMemory) {
    if (GLINT_THREAD_SANITIZER) {
        GTEST_SKIP() << "its allocator hands out what was freed, whatever mallopt() says";
    }
    const std::vector<Channel> channels{{"B", 3}, {"G", 2}, {"R", 1}};
    std::mt19937 random(3);
    const auto decoded = [](const std::string& bytes) {
        const auto image = decodeExrColor(bytes, "a");
        return image ? std::string(reinterpret_cast<const char*>(image->color.rgb.data()),
                                   4 * image->color.rgb.size())
                     : "";
    };
    for (const Imf::Header& header : packings(channels)) {
        const std::string whole = written(channels, header);
        const size_t pixels = whole.find("screenWindowWidth") + 32;
        for (int round = 0; round < 100; ++round) {
            std::string bytes = whole;
            for (int change = 0; change < 2; ++change) {
                bytes[pixels + random() % (bytes.size() - pixels)] = static_cast<char>(random());
            }
            mallopt(M_PERTURB, 0x5a);
            const std::string first = decoded(bytes);
            mallopt(M_PERTURB, 0xc3);
            const std::string second = decoded(bytes);
            mallopt(M_PERTURB, 0);
            ASSERT_TRUE(first == second) << "compression " << header.compression() << ", round " << round;
        }
    }
}

/// What a header promises is compared with what the file can hold before it is allocated.
TEST_F(ExrColor, ThatCannotBeInTheFileIsRefused) {
    std::vector<Channel> channels;
    for (int i = 0; i < 100; ++i) {
        channels.push_back({"c" + std::to_string(i), 0});
    }
    std::string bytes = written(channels);
    const size_t window = bytes.find("dataWindow") + 11 + 6 + 4;
    const std::string large("\0\0\0\0\0\0\0\0\xff\x1f\0\0\xff\x1f\0\0", 16);
    bytes.replace(window, large.size(), large);
    const auto all = decodeExr(bytes, "a");
    ASSERT_FALSE(all);
    EXPECT_THAT(all.error().format(), HasSubstr("8192 x 8192 pixels cannot be in"));
    const auto one = decodeExr(written({{"B", 3}, {"G", 2}, {"R", 1}, {"Z", 9}}), "a",
                               [](std::string_view name) { return name == "G"; });
    ASSERT_TRUE(one) << one.error().format();
    ASSERT_EQ(one->channels.size(), 1u) << "channels that nobody wants are not read";
    EXPECT_EQ(one->channels[0].floats[1], valueAt({"", 2}, 1));
}

}  // namespace
}  // namespace glint
