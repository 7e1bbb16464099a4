#include "engine/io/dds_pixels.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <squish.h>

#include "engine/io/image_builder.h"

namespace glint {
namespace {

/// What libsquish calls the blocks; 0: it does not know them.
int blockKind(uint32_t fourCc) {
    switch (fourCc) {
        case 0x31545844:  // "DXT1"
            return squish::kDxt1;
        case 0x32545844:
        case 0x33545844:
            return squish::kDxt3;
        case 0x34545844:
        case 0x35545844:
            return squish::kDxt5;
        default:
            return 0;
    }
}

/// How many channels blocks of BC4 and BC5 hold; 0: it is another kind.
int channelCount(uint32_t fourCc) {
    switch (fourCc) {
        case 0x31495441:  // "ATI1"
        case 0x55344342:  // "BC4U"
            return 1;
        case 0x32495441:
        case 0x55354342:
            return 2;
        default:
            return 0;
    }
}

/// Bytes of one channel of four floats; 0: it is another kind.
size_t floatBytes(uint32_t fourCc) {
    constexpr uint32_t kHalves = 113, kFloats = 116;  // Direct3D 9's own numbers
    return fourCc == kHalves ? 2 : fourCc == kFloats ? 4 : 0;
}

bool isPlain(const DdsHeader& header) {
    return header.fourCc == 0 && header.bits >= 8 && header.bits <= 32 && header.bits % 8 == 0 &&
           (header.masks[0] | header.masks[1] | header.masks[2]) != 0;
}

/// The 16 values of a block of one channel (BC4): two ends, then 3 bits each that say how far between them.
std::array<uint8_t, 16> unpackChannel(std::string_view block) {
    const auto byte = [block](size_t i) { return static_cast<uint8_t>(block[i]); };
    std::array<uint8_t, 8> palette = {byte(0), byte(1), 0, 0, 0, 0, 0, 255};
    const int steps = palette[0] > palette[1] ? 7 : 5;
    for (int i = 1; i < steps; ++i) {
        palette[static_cast<size_t>(i) + 1] =
            static_cast<uint8_t>(((steps - i) * palette[0] + i * palette[1] + steps / 2) / steps);
    }
    uint64_t choices = 0;
    for (size_t i = 8; i-- > 2;) {
        choices = choices << 8 | byte(i);
    }
    std::array<uint8_t, 16> values{};
    for (uint8_t& value : values) {
        value = palette[choices & 7];
        choices >>= 3;
    }
    return values;
}

/// One channel is grey, two are x and y of a normal of unit length.
void setPixel(int channels, uint8_t first, uint8_t second, uint8_t* rgba) {
    const float x = static_cast<float>(first) / 127.5f - 1.0f, y = static_cast<float>(second) / 127.5f - 1.0f;
    const float z = std::sqrt(std::max(0.0f, 1.0f - x * x - y * y));
    rgba[0] = first;
    rgba[1] = channels == 1 ? first : second;
    rgba[2] = channels == 1 ? first : static_cast<uint8_t>(std::lround(127.5f * (z + 1.0f)));
    rgba[3] = 255;
}

void readChannels(const DdsHeader& header, int channels, ByteReader* bytes, Image8Builder* builder) {
    const size_t blocksAcross = (size_t{header.width} + 3) / 4, rowSize = 16 * blocksAcross;
    std::vector<uint8_t> band(4 * rowSize);
    for (uint32_t top = 0; top < header.height; top += 4) {
        for (size_t block = 0; block < blocksAcross; ++block) {
            std::array<std::array<uint8_t, 16>, 2> values{};
            for (size_t channel = 0; channel < static_cast<size_t>(channels); ++channel) {
                const std::string_view stored = bytes->readRaw(8);
                if (bytes->failed()) { return; }
                values[channel] = unpackChannel(stored);
            }
            for (size_t i = 0; i < 16; ++i) {
                setPixel(channels, values[0][i], values[1][i],
                         &band[i / 4 * rowSize + 16 * block + 4 * (i % 4)]);
            }
        }
        for (uint32_t row = top; row < std::min(top + 4, header.height); ++row) {
            builder->setRow(static_cast<int>(row),
                            std::span(band).subspan((row - top) * rowSize, size_t{4} * header.width));
        }
    }
}

void readBlocks(const DdsHeader& header, int kind, ByteReader* bytes, Image8Builder* builder) {
    const int width = static_cast<int>(header.width), height = static_cast<int>(header.height);
    const auto bandBytes = static_cast<uint64_t>(squish::GetStorageRequirements(width, 4, kind));
    const size_t rowSize = size_t{4} * header.width;
    std::vector<uint8_t> band(4 * rowSize);
    for (int top = 0; top < height; top += 4) {
        const std::string_view blocks = bytes->readRaw(bandBytes);
        if (bytes->failed()) { return; }
        squish::DecompressImage(band.data(), width, 4, blocks.data(), kind);
        for (int row = top; row < std::min(top + 4, height); ++row) {
            builder->setRow(row, std::span(band).subspan(static_cast<size_t>(row - top) * rowSize, rowSize));
        }
    }
}

void readPixels(const DdsHeader& header, ByteReader* bytes, Image8Builder* builder) {
    std::vector<uint8_t> rgba(size_t{4} * header.width);
    for (uint32_t row = 0; row < header.height; ++row) {
        for (size_t x = 0; x < header.width; ++x) {
            const std::string_view stored = bytes->readRaw(header.bits / 8);
            uint32_t pixel = 0;
            for (size_t i = stored.size(); i-- > 0;) {
                pixel = pixel << 8 | static_cast<uint8_t>(stored[i]);
            }
            for (size_t c = 0; c < 4; ++c) {
                rgba[4 * x + c] = maskedByte(pixel, header.masks[c], c == 3 ? 255 : 0);
            }
        }
        builder->setRow(static_cast<int>(row), rgba);
    }
}

SceneImage readFloats(const DdsHeader& header, ByteReader* bytes) {
    const size_t size = floatBytes(header.fourCc);
    ImageFBuilder builder({static_cast<int>(header.width), static_cast<int>(header.height)});
    for (uint32_t row = 0; row < header.height; ++row) {
        const std::string_view stored = bytes->readRaw(4 * size * header.width);
        if (bytes->failed()) { break; }
        for (size_t x = 0; x < header.width; ++x) {
            for (size_t c = 0; c < 3; ++c) {
                builder.pixel(static_cast<int>(x), static_cast<int>(row))[c] =
                    storedFloat(reinterpret_cast<const uint8_t*>(&stored[(4 * x + c) * size]), size);
            }
        }
    }
    return builder.take();
}

/// Of a picture of that size.
uint64_t storedBytes(const DdsHeader& header, uint64_t width, uint64_t height) {
    const int kind = blockKind(header.fourCc), channels = channelCount(header.fourCc);
    if (kind == 0 && channels == 0) {
        const size_t size = floatBytes(header.fourCc);
        return width * height * (size > 0 ? 4 * size : header.bits / 8);
    }
    const uint64_t blockBytes = kind == squish::kDxt1 || channels == 1 ? 8 : 16;
    return (width + 3) / 4 * ((height + 3) / 4) * blockBytes;
}

}  // namespace

bool isReadable(const DdsHeader& header) {
    return blockKind(header.fourCc) != 0 || channelCount(header.fourCc) != 0 ||
           floatBytes(header.fourCc) != 0 || isPlain(header);
}

SceneImage readDdsFace(const DdsHeader& header, ByteReader* bytes) {
    const int kind = blockKind(header.fourCc), channels = channelCount(header.fourCc);
    SceneImage image;
    if (floatBytes(header.fourCc) != 0) {
        image = readFloats(header, bytes);
    } else {
        Image8Builder builder({static_cast<int>(header.width), static_cast<int>(header.height)});
        if (kind != 0) {
            readBlocks(header, kind, bytes, &builder);
        } else if (channels != 0) {
            readChannels(header, channels, bytes, &builder);
        } else {
            readPixels(header, bytes, &builder);
        }
        image = builder.take(true);
    }
    return image;
}

void skipDdsCopies(const DdsHeader& header, ByteReader* bytes) {
    for (uint32_t level = 1; level < header.mipLevels && level < 32; ++level) {
        bytes->readRaw(
            storedBytes(header, std::max(header.width >> level, 1u), std::max(header.height >> level, 1u)));
    }
}

}  // namespace glint
