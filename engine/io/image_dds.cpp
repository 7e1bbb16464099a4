// DDS (Microsoft, "Programming guide for DDS"): the largest picture of a flat texture. Blocks are unpacked by
// libsquish, those that it does not know by ourselves. Left out: BC6H and BC7, cube maps.
#include <bit>
#include <cmath>

#include <fmt/format.h>
#include <squish.h>

#include "engine/io/byte_stream.h"
#include "engine/io/image_builder.h"
#include "engine/io/image_formats.h"

namespace glint {
namespace {

constexpr uint32_t kCubeMap = 0x200;
constexpr uint32_t kDx10 = 0x30315844;  // "DX10"

struct Header {
    uint32_t height = 0, width = 0;
    uint32_t fourCc = 0;  ///< of blocks; 0: plain pixels
    uint32_t bits = 0;    ///< of a plain pixel
    uint32_t masks[4] = {};
    bool isCubeMap = false;
    uint32_t dxgiFormat = 0;  ///< where the fields above cannot say it
};

/// DXGI's names of what the fields above can say.
void useDxgiFormat(uint32_t format, Header* header) {
    const auto plain = [header](uint32_t red, uint32_t blue, uint32_t alpha) {
        header->fourCc = 0;
        header->bits = 32;
        std::ranges::copy(std::array{red, 0xff00u, blue, alpha}, header->masks);
    };
    switch (format) {
        case 28:
        case 29:
            return plain(0xff, 0xff0000, 0xff000000);
        case 87:
        case 91:
            return plain(0xff0000, 0xff, 0xff000000);
        case 88:
        case 93:
            return plain(0xff0000, 0xff, 0);
        case 71:
        case 72:
            header->fourCc = 0x31545844;  // "DXT1"
            return;
        case 74:
        case 75:
            header->fourCc = 0x33545844;
            return;
        case 77:
        case 78:
            header->fourCc = 0x35545844;
            return;
        case 79:
        case 80:
            header->fourCc = 0x31495441;  // "ATI1"
            return;
        case 82:
        case 83:
            header->fourCc = 0x32495441;
            return;
        default:
            header->dxgiFormat = format;
            return;
    }
}

Header readHeader(ByteReader* bytes) {
    Header header;
    bytes->readRaw(12);
    header.height = bytes->read<uint32_t>();
    header.width = bytes->read<uint32_t>();
    bytes->readRaw(60);
    const uint32_t flags = bytes->read<uint32_t>();
    const uint32_t fourCc = bytes->read<uint32_t>();
    header.fourCc = (flags & 4) != 0 ? fourCc : 0;
    header.bits = bytes->read<uint32_t>();
    for (uint32_t& mask : header.masks) {
        mask = bytes->read<uint32_t>();
    }
    if ((flags & 0x20000) != 0) { header.masks[1] = header.masks[2] = header.masks[0]; }  // luminance
    if ((flags & 1) == 0) { header.masks[3] = 0; }
    bytes->readRaw(4);
    header.isCubeMap = (bytes->read<uint32_t>() & kCubeMap) != 0;
    bytes->readRaw(12);
    if (header.fourCc == kDx10) {
        const uint32_t format = bytes->read<uint32_t>();
        bytes->readRaw(16);
        useDxgiFormat(format, &header);
    }
    return header;
}

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

std::string_view nameOf(uint32_t dxgiFormat) {
    switch (dxgiFormat) {
        case 81:
            return "BC4 with signs";
        case 84:
            return "BC5 with signs";
        case 94:
        case 95:
        case 96:
            return "BC6H";
        case 97:
        case 98:
        case 99:
            return "BC7";
        default:
            return "";
    }
}

Error unknownPixels(const Header& header, const std::string& path) {
    const std::string_view name = nameOf(header.dxgiFormat);
    return imageError(
        path, fmt::format("has DDS pixels of kind {}; expected DXT1 to DXT5 (BC1 to BC3), BC4, BC5, or plain "
                          "ones of 8 to 32 bits",
                          name.empty() ? fmt::format("{:#x}", header.fourCc) : name));
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

void readChannels(const Header& header, int channels, ByteReader* bytes, Image8Builder* builder) {
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

void readBlocks(const Header& header, int kind, ByteReader* bytes, Image8Builder* builder) {
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

void readPixels(const Header& header, ByteReader* bytes, Image8Builder* builder) {
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

Result<SceneImage> decode(const std::string& file, const std::string& path) {
    ByteReader bytes(file);
    const Header header = readHeader(&bytes);
    if (bytes.failed()) { return brokenImage(path, "the file ends too early"); }
    if (header.isCubeMap) { return imageError(path, "is a cube map; expected a flat DDS image"); }
    const int kind = blockKind(header.fourCc), channels = channelCount(header.fourCc);
    const bool isPlain = header.fourCc == 0 && header.bits >= 8 && header.bits <= 32 &&
                         header.bits % 8 == 0 && (header.masks[0] | header.masks[1] | header.masks[2]) != 0;
    if (kind == 0 && channels == 0 && !isPlain) { return unknownPixels(header, path); }
    // Blocks of 8 bytes hold 16 pixels.
    if (Status size = checkStatedSize(path, header.width, header.height, file.size(), 2.0); !size) {
        return size.error();
    }
    Image8Builder builder({static_cast<int>(header.width), static_cast<int>(header.height)});
    if (kind != 0) {
        readBlocks(header, kind, &bytes, &builder);
    } else if (channels != 0) {
        readChannels(header, channels, &bytes, &builder);
    } else {
        readPixels(header, &bytes, &builder);
    }
    return bytes.failed() ? Result<SceneImage>(brokenImage(path, "the file ends too early"))
                          : builder.take(true);
}

}  // namespace

extern const ImageFormat kImageDds;
const ImageFormat kImageDds{.name = "DDS",
                            .extensions = ".dds",
                            .looksLike = [](std::string_view head) { return head.starts_with("DDS "); },
                            .decode = decode};

}  // namespace glint
