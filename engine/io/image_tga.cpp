// TGA (Truevision TGA File Format Specification 2.0): a header of 18 bytes, an identification, a palette,
// then pixels, plain or in packets of runs. No packaged library reads it whole.
#include <algorithm>

#include "engine/io/byte_stream.h"
#include "engine/io/image_builder.h"
#include "engine/io/image_formats.h"

namespace glint {
namespace {

/// A packet of two bytes repeats a pixel 128 times.
constexpr double kMostPixelsPerByte = 64.0;

struct Header {
    uint8_t identificationSize, hasPalette, kind;
    uint16_t firstColor, colorCount;
    uint8_t colorBits;
    uint16_t left, bottom, width, height;
    uint8_t pixelBits, descriptor;

    bool isPacked() const { return kind >= 9; }
    bool isPalette() const { return (kind & 7) == 1; }
    bool isGrey() const { return (kind & 7) == 3; }
    /// The bits of the descriptor say where the first pixel belongs.
    Orientation orientation() const {
        constexpr Orientation kOrders[] = {Orientation::BottomLeft, Orientation::BottomRight,
                                           Orientation::TopLeft, Orientation::TopRight};
        return kOrders[descriptor >> 4 & 3];
    }
};

Header readHeader(ByteReader* bytes) {
    Header header{};
    header.identificationSize = bytes->read<uint8_t>();
    header.hasPalette = bytes->read<uint8_t>();
    header.kind = bytes->read<uint8_t>();
    header.firstColor = bytes->read<uint16_t>();
    header.colorCount = bytes->read<uint16_t>();
    header.colorBits = bytes->read<uint8_t>();
    header.left = bytes->read<uint16_t>();
    header.bottom = bytes->read<uint16_t>();
    header.width = bytes->read<uint16_t>();
    header.height = bytes->read<uint16_t>();
    header.pixelBits = bytes->read<uint8_t>();
    header.descriptor = bytes->read<uint8_t>();
    return header;
}

bool isOneOf(int value, std::initializer_list<int> known) {
    return std::find(known.begin(), known.end(), value) != known.end();
}

/// Whether the header makes sense: the format has no mark of its own.
bool looksLike(std::string_view head) {
    ByteReader bytes(head);
    const Header header = readHeader(&bytes);
    if (bytes.failed() || header.width == 0 || header.height == 0 || header.hasPalette > 1 ||
        !isOneOf(header.kind, {1, 2, 3, 9, 10, 11})) {
        return false;
    }
    const bool hasColors = header.hasPalette == 1 && isOneOf(header.colorBits, {15, 16, 24, 32});
    if (header.isPalette()) { return hasColors && isOneOf(header.pixelBits, {8, 16}); }
    return (hasColors || header.hasPalette == 0) &&
           (header.isGrey() ? isOneOf(header.pixelBits, {8, 16})
                            : isOneOf(header.pixelBits, {15, 16, 24, 32}));
}

using Rgba = std::array<uint8_t, 4>;

/// A colour as palettes and pixels store it: blue first, or 5 bits each.
Rgba colorOf(std::string_view stored) {
    const auto byte = [stored](size_t i) { return static_cast<uint8_t>(stored[i]); };
    if (stored.size() == 2) {
        const unsigned packed = byte(0) | static_cast<unsigned>(byte(1)) << 8;
        const auto five = [packed](unsigned shift) {
            return static_cast<uint8_t>((packed >> shift & 31) * 255 / 31);
        };
        return {five(10), five(5), five(0), 255};
    }
    return {byte(2), byte(1), byte(0), stored.size() == 4 ? byte(3) : uint8_t{255}};
}

class Pixels {
  public:
    Pixels(const Header& header, ByteReader* bytes) : header_(header), bytes_(bytes) {
        bytes->readRaw(header.identificationSize);
        const size_t colorBytes = (header.colorBits + size_t{7}) / 8;
        for (int i = 0; header.hasPalette == 1 && i < header.colorCount; ++i) {
            const std::string_view stored = bytes->readRaw(colorBytes);
            if (bytes->failed()) { break; }
            palette_.push_back(colorOf(stored));
        }
    }

    /// The next pixel of the file; black once bytes have failed.
    Rgba next() {
        if (!header_.isPacked()) { return read(); }
        if (left_ == 0) {
            const uint8_t packet = bytes_->read<uint8_t>();
            left_ = (packet & 127) + 1;
            repeats_ = packet >= 128;
            if (repeats_) { pixel_ = read(); }
        }
        --left_;
        return repeats_ ? pixel_ : read();
    }
    bool hasUnknownColor() const { return hasUnknownColor_; }

  private:
    Rgba read() {
        const std::string_view stored = bytes_->readRaw((header_.pixelBits + size_t{7}) / 8);
        if (bytes_->failed()) { return {}; }
        const auto byte = [stored](size_t i) { return static_cast<uint8_t>(stored[i]); };
        if (header_.isGrey()) {
            return {byte(0), byte(0), byte(0), stored.size() == 2 ? byte(1) : uint8_t{255}};
        }
        if (!header_.isPalette()) { return colorOf(stored); }
        const int index = byte(0) | (stored.size() == 2 ? byte(1) << 8 : 0);
        const int entry = index - header_.firstColor;
        hasUnknownColor_ |= entry < 0 || static_cast<size_t>(entry) >= palette_.size();
        return hasUnknownColor_ ? Rgba{} : palette_[static_cast<size_t>(entry)];
    }

    const Header& header_;
    ByteReader* bytes_;
    std::vector<Rgba> palette_;
    Rgba pixel_{};
    int left_ = 0;
    bool repeats_ = false;
    bool hasUnknownColor_ = false;
};

Result<SceneImage> decode(const std::string& file, const std::string& path) {
    if (!looksLike(file)) { return brokenImage(path, "its header is that of no TGA image"); }
    ByteReader bytes(file);
    const Header header = readHeader(&bytes);
    const double most = header.isPacked() ? kMostPixelsPerByte : 1.0;
    if (Status size = checkStatedSize(path, header.width, header.height, file.size(), most); !size) {
        return size.error();
    }
    Pixels pixels(header, &bytes);
    Image8Builder builder({header.width, header.height, header.orientation()});
    std::vector<uint8_t> rgba(size_t{4} * header.width);
    for (int row = 0; row < header.height; ++row) {
        for (size_t x = 0; x < header.width; ++x) {
            std::ranges::copy(pixels.next(), &rgba[4 * x]);
        }
        builder.setRow(row, rgba);
    }
    if (bytes.failed()) { return brokenImage(path, "the file ends too early"); }
    if (pixels.hasUnknownColor()) { return brokenImage(path, "a colour is not in the palette"); }
    return builder.take(true);
}

}  // namespace

extern const ImageFormat kImageTga;
const ImageFormat kImageTga{.name = "TGA", .extensions = ".tga", .looksLike = looksLike, .decode = decode};

}  // namespace glint
