// DDS (Microsoft, "Programming guide for DDS"): the largest picture of a flat texture, or of each face of a
// cube. Left out: BC6H and BC7, which no package of a sensible size unpacks.
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "engine/io/cube_map.h"
#include "engine/io/dds_pixels.h"
#include "engine/io/image_builder.h"
#include "engine/io/image_formats.h"

namespace glint {
namespace {

constexpr uint32_t kCubeMap = 0x200, kAllFaces = 0xfc00;
constexpr uint32_t kHasMipLevels = 0x20000;
constexpr uint32_t kDx10 = 0x30315844;  // "DX10"

/// DXGI's names of what the fields above can say.
void useDxgiFormat(uint32_t format, DdsHeader* header) {
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
        case 10:
            header->fourCc = 113;  // halves
            return;
        case 2:
            header->fourCc = 116;  // floats
            return;
        default:
            header->dxgiFormat = format;
            return;
    }
}

DdsHeader readHeader(ByteReader* bytes) {
    DdsHeader header;
    bytes->readRaw(8);
    const uint32_t given = bytes->read<uint32_t>();
    header.height = bytes->read<uint32_t>();
    header.width = bytes->read<uint32_t>();
    bytes->readRaw(8);
    const uint32_t levels = bytes->read<uint32_t>();
    if ((given & kHasMipLevels) != 0) { header.mipLevels = std::max(levels, 1u); }
    bytes->readRaw(48);
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
    const uint32_t caps = bytes->read<uint32_t>();
    header.isCubeMap = (caps & kCubeMap) != 0;
    header.hasAllFaces = (caps & kAllFaces) == kAllFaces;
    bytes->readRaw(12);
    if (header.fourCc == kDx10) {
        const uint32_t format = bytes->read<uint32_t>();
        bytes->readRaw(4);
        constexpr uint32_t kTextureCube = 4;
        if ((bytes->read<uint32_t>() & kTextureCube) != 0) { header.isCubeMap = header.hasAllFaces = true; }
        bytes->readRaw(8);
        useDxgiFormat(format, &header);
    }
    return header;
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

Error unknownPixels(const DdsHeader& header, const std::string& path) {
    const std::string_view name = nameOf(header.dxgiFormat);
    return imageError(
        path, fmt::format("has DDS pixels of kind {}; expected DXT1 to DXT5 (BC1 to BC3), BC4, BC5, four "
                          "halves or floats, or plain ones of 8 to 32 bits",
                          name.empty() ? fmt::format("{:#x}", header.fourCc) : name));
}

Result<SceneImage> decode(const std::string& file, const std::string& path) {
    ByteReader bytes(file);
    const DdsHeader header = readHeader(&bytes);
    if (bytes.failed()) { return brokenImage(path, "the file ends too early"); }
    if (!isReadable(header)) { return unknownPixels(header, path); }
    if (header.isCubeMap && (!header.hasAllFaces || header.width != header.height || header.width < 2)) {
        return imageError(path,
                          "is part of a cube map; expected all of its six square faces, or a flat DDS image");
    }
    const uint64_t faces = header.isCubeMap ? 6 : 1;
    // Blocks of 8 bytes hold 16 pixels.
    if (Status size = checkStatedSize(path, header.width, faces * header.height, file.size(), 2.0); !size) {
        return size.error();
    }
    std::vector<SceneImage> images;
    for (uint64_t face = 0; face < faces && !bytes.failed(); ++face) {
        if (face > 0) { skipDdsCopies(header, &bytes); }
        images.push_back(readDdsFace(header, &bytes));
    }
    if (bytes.failed()) { return brokenImage(path, "the file ends too early"); }
    return header.isCubeMap ? cubeColumn(images) : std::move(images[0]);
}

}  // namespace

extern const ImageFormat kImageDds;
const ImageFormat kImageDds{.name = "DDS",
                            .extensions = ".dds",
                            .looksLike = [](std::string_view head) { return head.starts_with("DDS "); },
                            .decode = decode};

}  // namespace glint
