// DDS (Microsoft, "Programming guide for DDS"): the largest picture of a flat texture. Blocks are unpacked by
// libsquish.
#include <bit>

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
        default:
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
    const int kind = blockKind(header.fourCc);
    const bool isPlain = header.fourCc == 0 && header.bits >= 8 && header.bits <= 32 &&
                         header.bits % 8 == 0 && (header.masks[0] | header.masks[1] | header.masks[2]) != 0;
    if (kind == 0 && !isPlain) {
        return imageError(
            path, fmt::format("has DDS pixels of kind {:#x}; expected DXT1 to DXT5 (BC1 to BC3), or plain "
                              "ones of 8 to 32 bits",
                              header.fourCc));
    }
    // Blocks of 8 bytes hold 16 pixels.
    if (Status size = checkStatedSize(path, header.width, header.height, file.size(), 2.0); !size) {
        return size.error();
    }
    Image8Builder builder({static_cast<int>(header.width), static_cast<int>(header.height)});
    kind != 0 ? readBlocks(header, kind, &bytes, &builder) : readPixels(header, &bytes, &builder);
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
