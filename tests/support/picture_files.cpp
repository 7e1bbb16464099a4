#include "tests/support/picture_files.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>

#include <squish.h>

#include "tests/support/library_pictures.h"

namespace glint::test {
namespace {

using Pixel = std::array<int, 4>;
using Stored = std::function<std::string(const Pixel& pixel)>;

Pixel pixelOf(const Image8& image, int x, int y) {
    const size_t i = static_cast<size_t>(y * image.width + x);
    return {image.rgb[3 * i], image.rgb[3 * i + 1], image.rgb[3 * i + 2],
            image.alpha.empty() ? 255 : image.alpha[i]};
}

std::string bytesOf(std::initializer_list<int> values) {
    std::string bytes;
    for (const int value : values) {
        bytes += static_cast<char>(value);
    }
    return bytes;
}

std::string bgr(const Pixel& p) { return bytesOf({p[2], p[1], p[0]}); }
std::string bgra(const Pixel& p) { return bytesOf({p[2], p[1], p[0], p[3]}); }
std::string rgb(const Pixel& p) { return bytesOf({p[0], p[1], p[2]}); }

std::string rowsOf(const Image8& image, bool bottomUp, const Stored& stored) {
    std::string out;
    for (int row = 0; row < image.height; ++row) {
        const int y = bottomUp ? image.height - 1 - row : row;
        for (int x = 0; x < image.width; ++x) {
            out += stored(pixelOf(image, x, y));
        }
    }
    return out;
}

/// A picture of two colours, whose palette index is x % 2.
Image8 stripes() {
    Image8 image{6, 5, {}};
    for (int i = 0; i < 30; ++i) {
        const std::array<uint8_t, 3> color =
            i % 6 % 2 == 0 ? std::array<uint8_t, 3>{200, 100, 50} : std::array<uint8_t, 3>{10, 20, 30};
        image.rgb.insert(image.rgb.end(), color.begin(), color.end());
    }
    return image;
}

std::string bmp(uint32_t headerSize, int height, int bits, uint32_t packing, const std::string& palette,
                const std::string& pixels, const std::string& masks = "") {
    std::string header = little(headerSize, 4);
    if (headerSize == 12) {
        header += little(6, 2) + little(static_cast<uint64_t>(height), 2) + little(1, 2) +
                  little(static_cast<uint64_t>(bits), 2);
    } else {
        header += little(6, 4) + little(static_cast<uint32_t>(height), 4) + little(1, 2) +
                  little(static_cast<uint64_t>(bits), 2);
        header += little(packing, 4) + std::string(20, '\0') + masks;
        header.resize(headerSize + (headerSize == 40 ? masks.size() : 0), '\0');
    }
    const uint64_t offset = 14 + header.size() + palette.size();
    return "BM" + little(offset + pixels.size(), 4) + little(0, 4) + little(offset, 4) + header + palette +
           pixels;
}

void addBmp(std::vector<PictureFile>* files) {
    const Image8 colors = patternImage(), clear = transparentImage(), two = stripes();
    const std::string palette3 = bytesOf({50, 100, 200, 30, 20, 10});
    const std::string palette4 = bytesOf({50, 100, 200, 0, 30, 20, 10, 0}) + std::string(4 * 254, '\0');
    std::string padded;
    for (int y = 4; y >= 0; --y) {
        for (int x = 0; x < 6; ++x) {
            padded += bgr(pixelOf(colors, x, y));
        }
        padded += std::string(2, '\0');
    }
    files->push_back({"bottom-up.bmp", bmp(40, 5, 24, 0, "", padded), colors});
    files->push_back({"top-down.bmp", bmp(40, -5, 32, 0, "", rowsOf(clear, false, bgra)), clear});
    const std::string masks = little(0xff, 4) + little(0xff00, 4) + little(0xff0000, 4);
    const auto rgbx = [](const Pixel& p) { return rgb(p) + std::string(1, '\0'); };
    files->push_back({"masks.bmp", bmp(40, 5, 32, 3, "", rowsOf(colors, true, rgbx), masks), colors});
    const std::string indices = bytesOf({0, 1, 0, 1, 0, 1, 0, 0});
    std::string rows8, rows1, rows4;
    for (int row = 0; row < 5; ++row) {
        rows8 += indices;
        rows1 += bytesOf({0b01010100, 0, 0, 0});
        rows4 += bytesOf({0x01, 0x01, 0x01, 0});
    }
    files->push_back({"os2.bmp", bmp(12, 5, 1, 0, palette3, rows1), two});
    files->push_back({"os2-8.bmp", bmp(12, 5, 8, 0, palette3, rows8), two});
    files->push_back({"palette.bmp", bmp(40, 5, 8, 0, palette4, rows8), two});
    files->push_back({"palette4.bmp", bmp(124, 5, 4, 0, palette4.substr(0, 64), rows4), two});
    std::string runs8, runs4;
    for (int row = 0; row < 5; ++row) {
        runs8 += bytesOf({0, 6, 0, 1, 0, 1, 0, 1, 0, 0});
        runs4 += bytesOf({6, 0x01, 0, 0});
    }
    files->push_back({"runs.bmp", bmp(40, 5, 8, 1, palette4, runs8 + bytesOf({0, 1})), two});
    files->push_back({"runs4.bmp", bmp(40, 5, 4, 2, palette4.substr(0, 64), runs4 + bytesOf({0, 1})), two});
}

std::string tga(int kind, int bits, int descriptor, const std::string& pixels, int firstColor = 0,
                const std::string& palette = "") {
    const auto count = static_cast<int>(palette.size() / 3);
    return bytesOf({2, palette.empty() ? 0 : 1, kind, firstColor, 0, count, 0, palette.empty() ? 0 : 24, 0, 0,
                    0, 0, 6, 0, 5, 0, bits, descriptor}) +
           "id" + palette + pixels;
}

void addTga(std::vector<PictureFile>* files) {
    const Image8 colors = patternImage(), clear = transparentImage(), two = stripes();
    files->push_back({"bottom-up.tga", tga(2, 24, 0, rowsOf(colors, true, bgr)), colors});
    files->push_back({"top-down.tga", tga(2, 32, 0x28, rowsOf(clear, false, bgra)), clear});
    const auto packets = [](const Pixel& p) { return std::string(1, '\0') + bgr(p); };
    files->push_back({"packets.tga", tga(10, 24, 0, rowsOf(colors, true, packets)), colors});
    const std::string palette = bytesOf({50, 100, 200, 30, 20, 10});
    const auto index = [](const Pixel& p) { return std::string(1, static_cast<char>(p[0] == 200 ? 7 : 8)); };
    files->push_back({"offset.tga", tga(1, 8, 0x20, rowsOf(two, false, index), 7, palette), two});
}

void addPnm(std::vector<PictureFile>* files) {
    const Image8 colors = patternImage();
    const auto text = [](const Pixel& p) {
        return std::to_string(p[0]) + " " + std::to_string(p[1]) + "\n" + std::to_string(p[2]) + " ";
    };
    const auto wide = [](const Pixel& p) {
        return big(static_cast<uint64_t>(p[0]) * 257, 2) + big(static_cast<uint64_t>(p[1]) * 257, 2) +
               big(static_cast<uint64_t>(p[2]) * 257, 2);
    };
    files->push_back({"binary.ppm", "P6 # c\n6 5\n255\n" + rowsOf(colors, false, rgb), colors});
    files->push_back({"wide.ppm", "P6\n6 5 65535\n" + rowsOf(colors, false, wide), colors});
    files->push_back({"text.ppm", "P3\n6 5\n255\n" + rowsOf(colors, false, text), colors});
    Image8 grey = colors;
    for (size_t i = 0; i < grey.rgb.size(); ++i) {
        grey.rgb[i] = colors.rgb[i - i % 3];
    }
    files->push_back({"grey.pgm",
                      "P5\n6 5\n255\n" + rowsOf(grey, false, [](const Pixel& p) { return bytesOf({p[0]}); }),
                      grey});
    const Image8 clear = transparentImage();
    const std::string pam = "P7\n# c\nWIDTH 6\nHEIGHT 5\nDEPTH 4\nMAXVAL 255\nTUPLTYPE RGB_ALPHA\nENDHDR\n";
    files->push_back({"alpha.pam",
                      pam + rowsOf(clear, false,
                                   [](const Pixel& p) {
                                       return bytesOf({p[0], p[1], p[2], p[3]});
                                   }),
                      clear});
}

void addPsd(std::vector<PictureFile>* files) {
    const Image8 colors = patternImage();
    const std::string header = "8BPS" + big(1, 2) + std::string(6, '\0') + big(3, 2) + big(5, 4) + big(6, 4) +
                               big(8, 2) + big(3, 2) + std::string(12, '\0');
    std::string planes, runs;
    for (size_t channel = 0; channel < 3; ++channel) {
        for (int y = 0; y < 5; ++y) {
            runs += bytesOf({5});
            for (int x = 0; x < 6; ++x) {
                planes += bytesOf({pixelOf(colors, x, y)[channel]});
                runs += bytesOf({pixelOf(colors, x, y)[channel]});
            }
        }
    }
    files->push_back({"plain.psd", header + big(0, 2) + planes, colors});
    files->push_back({"runs.psd", header + big(1, 2) + std::string(30, '\7') + runs, colors});
}

std::string dds(uint32_t flags, uint32_t fourCc, uint32_t bits, const std::string& pixels) {
    return "DDS " + little(124, 4) + little(0x1007, 4) + little(5, 4) + little(6, 4) + std::string(56, '\0') +
           little(32, 4) + little(flags, 4) + little(fourCc, 4) + little(bits, 4) + little(0xff0000, 4) +
           little(0xff00, 4) + little(0xff, 4) + little(0xff000000, 4) + little(0x1000, 4) +
           std::string(16, '\0') + pixels;
}

void addDds(std::vector<PictureFile>* files) {
    const Image8 clear = transparentImage(), two = stripes();
    files->push_back({"plain.dds", dds(0x41, 0, 32, rowsOf(clear, false, bgra)), clear});
    std::string rgba = rowsOf(two, false, [](const Pixel& p) { return rgb(p) + '\xff'; });
    for (const auto& [name, kind] : {std::pair{"DXT1", squish::kDxt1}, std::pair{"DXT5", squish::kDxt5}}) {
        std::string blocks(static_cast<size_t>(squish::GetStorageRequirements(6, 5, kind)), '\0');
        squish::CompressImage(reinterpret_cast<squish::u8*>(rgba.data()), 6, 5, blocks.data(), kind);
        uint32_t fourCc = 0;
        std::memcpy(&fourCc, name, 4);
        files->push_back({std::string(name) + ".dds", dds(4, fourCc, 0, blocks), two, 8});
    }
    // Blocks of one channel, whose even columns have the first end and whose odd ones the second.
    const auto channel = [](int even, int odd) {
        return bytesOf({even, odd, 0x08, 0x82, 0x20, 0x08, 0x82, 0x20});
    };
    Image8 grey{6, 5, {}}, normals{6, 5, {}};
    std::string one, both;
    for (int i = 0; i < 30; ++i) {
        const uint8_t x = i % 2 == 0 ? 200 : 10, y = i % 2 == 0 ? 100 : 127, z = i % 2 == 0 ? 229 : 177;
        grey.rgb.insert(grey.rgb.end(), {x, x, x});
        normals.rgb.insert(normals.rgb.end(), {x, y, z});
    }
    for (int block = 0; block < 4; ++block) {
        one += channel(200, 10);
        both += channel(200, 10) + channel(100, 127);
    }
    files->push_back({"ATI1.dds", dds(4, 0x31495441, 0, one), grey});
    files->push_back({"BC5U.dds", dds(4, 0x55354342, 0, both), normals});
}

}  // namespace

Image8 halfWhiteImage() {
    Image8 image{16, 8, std::vector<uint8_t>(3 * 128, 0)};
    for (size_t i = 0; i < 128; ++i) {
        if (i % 16 < 8) { std::fill_n(&image.rgb[3 * i], 3, uint8_t{255}); }
    }
    return image;
}

std::string exifOf(int orientation) {
    const std::string entry =
        little(0x112, 2) + little(3, 2) + little(1, 4) + little(static_cast<uint64_t>(orientation), 4);
    return "II" + little(42, 2) + little(8, 4) + little(1, 2) + entry + little(0, 4);
}

std::string little(uint64_t value, int bytes) {
    std::string out;
    for (int i = 0; i < bytes; ++i) {
        out += static_cast<char>(value >> 8 * i);
    }
    return out;
}

std::string big(uint64_t value, int bytes) {
    std::string out = little(value, bytes);
    std::ranges::reverse(out);
    return out;
}

Image8 patternImage() {
    Image8 image{6, 5, {}};
    for (int y = 0; y < 5; ++y) {
        for (int x = 0; x < 6; ++x) {
            for (const int value : {40 * x + 10, 50 * y + 5, 31 * x * y % 256}) {
                image.rgb.push_back(static_cast<uint8_t>(value));
            }
        }
    }
    return image;
}

Image8 transparentImage() {
    Image8 image = patternImage();
    image.alpha.assign(30, 255);
    image.alpha[7] = 0;
    image.alpha[12] = 128;
    return image;
}

std::vector<PictureFile> pictureFiles() {
    std::vector<PictureFile> files;
    addPng(&files);
    addJpeg(&files);
    addTiff(&files);
    addGif(&files);
    addBmp(&files);
    addTga(&files);
    addPnm(&files);
    addPsd(&files);
    addDds(&files);
    addWebp(&files);
    return files;
}

}  // namespace glint::test
