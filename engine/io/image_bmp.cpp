// BMP of Windows and OS/2 (Murray, vanRyper: Encyclopedia of Graphics File Formats, 1996; BITMAPV5HEADER): no
// packaged library reads it alone.
#include <algorithm>
#include <bit>

#include <fmt/format.h>

#include "engine/io/byte_stream.h"
#include "engine/io/image_builder.h"
#include "engine/io/image_formats.h"

namespace glint {
namespace {

/// Two bytes repeat a pixel 255 times.
constexpr double kMostPixelsPerRunByte = 127.5;
constexpr uint32_t kOs2HeaderSize = 12;

enum class Packing : uint32_t { None = 0, Runs8 = 1, Runs4 = 2, Masks = 3, MasksWithAlpha = 6 };

using Rgba = std::array<uint8_t, 4>;

struct Header {
    uint32_t pixelsAt = 0;
    uint32_t size = 0;
    int64_t width = 0;
    int64_t height = 0;  ///< below 0: the top row comes first
    uint32_t bits = 0;
    Packing packing = Packing::None;
    uint32_t masks[4] = {};  ///< of red, green, blue and alpha
    std::vector<Rgba> palette = {};
};

void readMasks(ByteReader* bytes, Header* header) {
    const bool given = header->packing == Packing::Masks || header->packing == Packing::MasksWithAlpha;
    if (given) {
        const bool withAlpha = header->packing == Packing::MasksWithAlpha || header->size >= 56;
        for (int i = 0; i < (withAlpha ? 4 : 3); ++i) {
            header->masks[i] = bytes->read<uint32_t>();
        }
    } else if (header->bits == 16) {
        std::ranges::copy(std::array{0x7c00u, 0x3e0u, 0x1fu}, header->masks);
    } else if (header->bits == 32) {
        std::ranges::copy(std::array{0xff0000u, 0xff00u, 0xffu, 0xff000000u}, header->masks);
    }
}

/// `colors` entries, or as many as come before the pixels.
void readPalette(ByteReader bytes, uint64_t position, uint64_t colors, Header* header) {
    const uint64_t entrySize = header->size == kOs2HeaderSize ? 3 : 4;
    const uint64_t room = header->pixelsAt > position ? (header->pixelsAt - position) / entrySize : 0;
    for (uint64_t i = 0; i < std::min({colors, room, uint64_t{256}}); ++i) {
        const std::string_view stored = bytes.readRaw(entrySize);
        if (bytes.failed()) { return; }
        header->palette.push_back({static_cast<uint8_t>(stored[2]), static_cast<uint8_t>(stored[1]),
                                   static_cast<uint8_t>(stored[0]), 255});
    }
}

Result<Header> readHeader(std::string_view file, const std::string& path) {
    ByteReader bytes(file);
    bytes.readRaw(10);
    Header header;
    header.pixelsAt = bytes.read<uint32_t>();
    header.size = bytes.read<uint32_t>();
    uint64_t colors = 0;
    if (header.size == kOs2HeaderSize) {
        header.width = bytes.read<uint16_t>();
        header.height = bytes.read<uint16_t>();
        bytes.read<uint16_t>();
        header.bits = bytes.read<uint16_t>();
    } else if (header.size >= 16) {
        header.width = bytes.read<int32_t>();
        header.height = bytes.read<int32_t>();
        bytes.read<uint16_t>();
        header.bits = bytes.read<uint16_t>();
        if (header.size >= 40) {
            header.packing = static_cast<Packing>(bytes.read<uint32_t>());
            bytes.readRaw(12);
            colors = bytes.read<uint32_t>();
            bytes.readRaw(4);
            readMasks(&bytes, &header);
        }
    }
    const uint64_t headerEnd = uint64_t{14} + header.size;
    if (bytes.failed() || header.size < kOs2HeaderSize || headerEnd > file.size()) {
        return brokenImage(path, "its header is not whole");
    }
    if (header.bits <= 8) {
        // Masks that follow a header of 40 bytes belong to pixels of 16 and 32 bits, which have no palette.
        readPalette(ByteReader(file.substr(headerEnd)), headerEnd,
                    colors == 0 ? uint64_t{1} << header.bits : colors, &header);
    }
    return header;
}

/// A stored row of pixels that are not packed. False: a colour is not in the palette.
bool unpackRow(std::string_view stored, const Header& header, std::vector<uint8_t>* rgba) {
    for (size_t x = 0; x < rgba->size() / 4; ++x) {
        Rgba pixel{};
        if (header.bits <= 8) {
            const size_t bit = x * header.bits;
            const size_t shift = 8 - header.bits - bit % 8;
            const size_t index = static_cast<uint8_t>(stored[bit / 8]) >> shift & ((1u << header.bits) - 1);
            if (index >= header.palette.size()) { return false; }
            pixel = header.palette[index];
        } else {
            uint32_t packed = 0;
            for (size_t byte = header.bits / 8; byte-- > 0;) {
                packed = packed << 8 | static_cast<uint8_t>(stored[x * header.bits / 8 + byte]);
            }
            pixel =
                header.bits == 24
                    ? Rgba{static_cast<uint8_t>(packed >> 16), static_cast<uint8_t>(packed >> 8),
                           static_cast<uint8_t>(packed), 255}
                    : Rgba{maskedByte(packed, header.masks[0], 0), maskedByte(packed, header.masks[1], 0),
                           maskedByte(packed, header.masks[2], 0), maskedByte(packed, header.masks[3], 255)};
        }
        std::ranges::copy(pixel, &(*rgba)[4 * x]);
    }
    return true;
}

/// Rows begin at multiples of four bytes.
uint64_t rowBytes(const Header& header) {
    return (static_cast<uint64_t>(header.width) * header.bits + 31) / 32 * 4;
}

Status readRows(std::string_view pixels, const Header& header, const std::string& path,
                Image8Builder* builder) {
    const PixelPlaces& places = builder->places();
    std::vector<uint8_t> rgba(4 * static_cast<size_t>(header.width));
    for (int row = 0; row < places.storedHeight; ++row) {
        if (!unpackRow(pixels.substr(static_cast<size_t>(row) * rowBytes(header)), header, &rgba)) {
            return brokenImage(path, "a colour is not in the palette");
        }
        builder->setRow(row, rgba);
    }
    return {};
}

/// Runs of 8-bit or 4-bit palette indices. Pixels that are jumped over are transparent.
class RunReader {
  public:
    RunReader(std::string_view pixels, const Header& header, Image8Builder* builder)
        : bytes_(pixels), header_(header), builder_(builder), rgba_(4 * static_cast<size_t>(header.width)) {}

    Status read(const std::string& path) {
        while (row_ < builder_->places().storedHeight) {
            const uint8_t count = bytes_.read<uint8_t>();
            const uint8_t value = bytes_.read<uint8_t>();
            if (bytes_.failed()) { return brokenImage(path, "the file ends too early"); }
            if (count > 0) {
                for (unsigned i = 0; i < count; ++i) {
                    put(indexIn(value, i));
                }
            } else if (value == 0) {
                endRow();
            } else if (value == 1) {
                break;
            } else if (value == 2) {
                column_ += bytes_.read<uint8_t>();
                for (int down = bytes_.read<uint8_t>(); down > 0; --down) {
                    const size_t column = column_;
                    endRow();
                    column_ = column;
                }
            } else {
                readPlain(value);
            }
            if (isWrong_) { return brokenImage(path, "a colour is not in the palette"); }
        }
        while (row_ < builder_->places().storedHeight) {
            endRow();
        }
        return {};
    }

  private:
    bool isFour() const { return header_.packing == Packing::Runs4; }
    size_t indexIn(uint8_t value, size_t i) const {
        return isFour() ? (i % 2 == 0 ? value >> 4 : value & 15) : value;
    }

    void put(size_t index) {
        isWrong_ |= index >= header_.palette.size();
        if (!isWrong_ && 4 * column_ < rgba_.size()) {
            std::ranges::copy(header_.palette[index], &rgba_[4 * column_]);
        }
        ++column_;
    }
    void endRow() {
        if (row_ < builder_->places().storedHeight) { builder_->setRow(row_++, rgba_); }
        std::ranges::fill(rgba_, uint8_t{0});
        column_ = 0;
    }
    /// Padded to an even number of bytes.
    void readPlain(size_t count) {
        const size_t size = isFour() ? (count + 1) / 2 : count;
        const std::string_view plain = bytes_.readRaw(size + size % 2);
        for (size_t i = 0; i < count && !bytes_.failed(); ++i) {
            put(indexIn(static_cast<uint8_t>(plain[isFour() ? i / 2 : i]), i));
        }
    }

    ByteReader bytes_;
    const Header& header_;
    Image8Builder* builder_;
    std::vector<uint8_t> rgba_;
    size_t column_ = 0;
    int row_ = 0;
    bool isWrong_ = false;
};

/// Whether the pixels are of a kind that is read.
bool isKnown(const Header& header) {
    const uint32_t bits = header.bits;
    switch (header.packing) {
        case Packing::None:
            return bits == 24 || (std::has_single_bit(bits) && bits <= 32);
        case Packing::Runs8:
            return bits == 8;
        case Packing::Runs4:
            return bits == 4;
        case Packing::Masks:
        case Packing::MasksWithAlpha:
            return bits == 16 || bits == 32;
    }
    return false;
}

Result<SceneImage> decode(const std::string& file, const std::string& path) {
    const Result<Header> header = readHeader(file, path);
    if (!header) { return header.error(); }
    if (!isKnown(*header)) {
        return imageError(path,
                          fmt::format("is a BMP image of {} bits a pixel, packed by method {}; expected 1 to "
                                      "32 bits, packed by method 0, 1, 2, 3 or 6",
                                      header->bits, static_cast<uint32_t>(header->packing)));
    }
    const auto width = static_cast<uint64_t>(std::max(header->width, int64_t{0}));
    const auto height = static_cast<uint64_t>(std::abs(header->height));
    const std::string_view pixels =
        std::string_view(file).substr(std::min<size_t>(header->pixelsAt, file.size()));
    if (Status size = checkStatedSize(path, width, height, pixels.size(), kMostPixelsPerRunByte); !size) {
        return size.error();
    }
    const bool runs = header->packing == Packing::Runs8 || header->packing == Packing::Runs4;
    // Some programs leave out what fills up the last row.
    if (!runs && rowBytes(*header) * (height - 1) + (width * header->bits + 7) / 8 > pixels.size()) {
        return brokenImage(path, "the file ends too early");
    }
    Image8Builder builder({static_cast<int>(width), static_cast<int>(height),
                           header->height < 0 ? Orientation::TopLeft : Orientation::BottomLeft});
    const Status read =
        runs ? RunReader(pixels, *header, &builder).read(path) : readRows(pixels, *header, path, &builder);
    return read ? Result<SceneImage>(builder.take(true)) : read.error();
}

}  // namespace

extern const ImageFormat kImageBmp;
const ImageFormat kImageBmp{.name = "BMP",
                            .extensions = ".bmp",
                            .looksLike = [](std::string_view head) { return head.starts_with("BM"); },
                            .decode = decode};

}  // namespace glint
