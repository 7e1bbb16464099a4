// Radiance HDR (Ward 1991, "Real Pixels", and the Radiance file formats manual): text lines, an empty line, a
// line with the order and size, then scan lines: 2 2 and its width in 16 bits, then for each of 4 channels
// runs: a byte n > 128 and a value for n - 128 pixels, or n and n values. Widths below 8 or from 32768 on,
// and older files, are 4 plain bytes a pixel, where 1 1 1 n repeats the pixel before. libstb reads neither
// XYZE nor other orders, and up to 2.28 (2023) never returns from a run of length 0.
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "engine/io/image_builder.h"
#include "engine/io/image_formats.h"
#include "engine/io/image_io.h"
#include "engine/math/vec.h"

namespace glint {
namespace {

/// A run of at most 127 takes 2 bytes in each of 4 channels. Plain pixels repeat without an end.
constexpr double kMostPixelsPerByte = 16.0;

struct Header {
    std::string_view pixels;
    PixelPlaces places;
    bool isXyz = false;
};

std::string_view takeLine(std::string_view* rest) {
    const size_t end = std::min(rest->find('\n'), rest->size());
    const std::string_view line = rest->substr(0, end);
    rest->remove_prefix(std::min(end + 1, rest->size()));
    return line.ends_with('\r') ? line.substr(0, line.size() - 1) : line;
}

/// "-Y 512 +X 1024": the axis along which scan lines follow each other first, Y pointing up.
bool readOrder(std::string_view line, PixelPlaces* places) {
    struct Axis {
        char sign = 0, name = 0;
        int length = 0;
    } axes[2];
    for (Axis& axis : axes) {
        line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
        if (line.size() < 3) { return false; }
        axis.sign = line[0];
        axis.name = line[1];
        line.remove_prefix(2);
        line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
        const auto [end, code] = std::from_chars(line.data(), line.data() + line.size(), axis.length);
        if (code != std::errc() || axis.length < 0 || (axis.sign != '+' && axis.sign != '-')) {
            return false;
        }
        line.remove_prefix(static_cast<size_t>(end - line.data()));
    }
    const bool columns = axes[0].name == 'X' && axes[1].name == 'Y';
    if (!columns && (axes[0].name != 'Y' || axes[1].name != 'X')) { return false; }
    const bool fromRight = axes[columns ? 0 : 1].sign == '-';
    const bool fromBottom = axes[columns ? 1 : 0].sign == '+';
    constexpr Orientation kOrders[] = {
        Orientation::TopLeft, Orientation::TopRight, Orientation::BottomLeft, Orientation::BottomRight,
        Orientation::LeftTop, Orientation::RightTop, Orientation::LeftBottom, Orientation::RightBottom};
    places->orientation = kOrders[(columns ? 4 : 0) + (fromBottom ? 2 : 0) + (fromRight ? 1 : 0)];
    places->storedHeight = axes[0].length;
    places->storedWidth = axes[1].length;
    return true;
}

Result<Header> readHeader(std::string_view bytes, const std::string& path) {
    Header header;
    for (std::string_view line = takeLine(&bytes); !line.empty(); line = takeLine(&bytes)) {
        if (!line.starts_with("FORMAT=")) { continue; }
        const std::string_view format = line.substr(7);
        header.isXyz = format == "32-bit_rle_xyze";
        if (!header.isXyz && format != "32-bit_rle_rgbe") {
            return imageError(path, fmt::format("has the pixel format \"{}\"; expected 32-bit_rle_rgbe or "
                                                "32-bit_rle_xyze",
                                                format.substr(0, 40)));
        }
    }
    const std::string_view order = takeLine(&bytes);
    if (!readOrder(order, &header.places)) {
        return imageError(path, fmt::format("is a broken HDR image: its size is \"{}\"; expected one like "
                                            "\"-Y 512 +X 1024\"",
                                            order.substr(0, 40)));
    }
    header.pixels = bytes;
    return header;
}

using Rgbe = std::array<uint8_t, 4>;

/// Reads scan lines; false: they are broken or cut off.
class ScanLines {
  public:
    explicit ScanLines(std::string_view bytes) : rest_(bytes) {}

    bool read(std::vector<Rgbe>* line) {
        const size_t width = line->size();
        const bool runs =
            width >= 8 && width < 32768 && rest_.size() >= 4 && byte(0) == 2 && byte(1) == 2 && byte(2) < 128;
        if (!runs) { return readPixels(line); }
        if ((byte(2) << 8 | byte(3)) != width) { return false; }
        rest_.remove_prefix(4);
        for (size_t channel = 0; channel < 4; ++channel) {
            if (!readRuns(line, channel)) { return false; }
        }
        return true;
    }

  private:
    size_t byte(size_t i) const { return static_cast<uint8_t>(rest_[i]); }

    bool readRuns(std::vector<Rgbe>* line, size_t channel) {
        for (size_t pixel = 0; pixel < line->size();) {
            if (rest_.empty()) { return false; }
            const bool repeats = byte(0) > 128;
            const size_t count = repeats ? byte(0) - 128 : byte(0);
            const size_t size = 1 + (repeats ? 1 : count);
            if (count == 0 || count > line->size() - pixel || size > rest_.size()) { return false; }
            for (size_t i = 0; i < count; ++i) {
                (*line)[pixel++][channel] = static_cast<uint8_t>(rest_[repeats ? 1 : 1 + i]);
            }
            rest_.remove_prefix(size);
        }
        return true;
    }

    bool readPixels(std::vector<Rgbe>* line) {
        int shift = 0;
        for (size_t pixel = 0; pixel < line->size();) {
            if (rest_.size() < 4) { return false; }
            const Rgbe stored{static_cast<uint8_t>(rest_[0]), static_cast<uint8_t>(rest_[1]),
                              static_cast<uint8_t>(rest_[2]), static_cast<uint8_t>(rest_[3])};
            rest_.remove_prefix(4);
            if (stored[0] != 1 || stored[1] != 1 || stored[2] != 1) {
                (*line)[pixel++] = before_ = stored;
                shift = 0;
                continue;
            }
            const size_t count = shift < 24 ? size_t{stored[3]} << shift : line->size();
            if (count > line->size() - pixel) { return false; }
            std::fill_n(line->begin() + static_cast<std::ptrdiff_t>(pixel), count, before_);
            pixel += count;
            shift += 8;
        }
        return true;
    }

    std::string_view rest_;
    Rgbe before_{};
};

/// Linear Rec.709 from CIE 1931 XYZ, with D65 as white (IEC 61966-2-1).
Vec3 xyzToLinear(const Vec3& xyz) {
    return {3.2404542f * xyz.x - 1.5371385f * xyz.y - 0.4985314f * xyz.z,
            -0.9692660f * xyz.x + 1.8760108f * xyz.y + 0.0415560f * xyz.z,
            0.0556434f * xyz.x - 0.2040259f * xyz.y + 1.0572252f * xyz.z};
}

Vec3 colorOf(const Rgbe& stored, bool isXyz) {
    const float unit = stored[3] == 0 ? 0.0f : std::ldexp(1.0f, stored[3] - (128 + 8));
    const Vec3 color(stored[0] * unit, stored[1] * unit, stored[2] * unit);
    return isXyz ? xyzToLinear(color) : color;
}

Result<SceneImage> decode(const std::string& bytes, const std::string& path) {
    const Result<Header> header = readHeader(bytes, path);
    if (!header) { return header.error(); }
    const PixelPlaces& places = header->places;
    if (Status size =
            checkStatedSize(path, static_cast<uint64_t>(places.storedWidth),
                            static_cast<uint64_t>(places.storedHeight), bytes.size(), kMostPixelsPerByte);
        !size) {
        return size.error();
    }
    ImageFBuilder builder(places);
    ScanLines lines(header->pixels);
    std::vector<Rgbe> line(static_cast<size_t>(places.storedWidth));
    for (int row = 0; row < places.storedHeight; ++row) {
        if (!lines.read(&line)) { return brokenImage(path, "not all of its pixels are there"); }
        for (int column = 0; column < places.storedWidth; ++column) {
            const Vec3 color = colorOf(line[static_cast<size_t>(column)], header->isXyz);
            std::copy_n(&color.x, 3, builder.pixel(column, row));
        }
    }
    return builder.take();
}

}  // namespace

extern const ImageFormat kImageHdr;
const ImageFormat kImageHdr{
    .name = "HDR",
    .extensions = ".hdr .pic",
    .looksLike = [](std::string_view head) { return head.starts_with("#?"); },
    .decode = decode,
    .save = [](const std::string& path, const ImageForms& image) { return saveHdr(path, image.radiance()); }};

}  // namespace glint
