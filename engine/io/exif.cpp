// EXIF 2.3, section 4: a TIFF header, then a directory of 12-byte entries: tag, type, count, value.
#include "engine/io/exif.h"

#include <cstdint>

namespace glint {
namespace {

constexpr uint32_t kOrientationTag = 0x0112;
constexpr uint32_t kShort = 3;

/// Unsigned numbers of either byte order at places in a text; 0 beyond its end.
struct Numbers {
    std::string_view bytes;
    bool bigEndian = true;

    uint32_t at(uint64_t place, uint32_t size) const {
        if (place > bytes.size() || bytes.size() - place < size) { return 0; }
        uint32_t value = 0;
        for (uint32_t i = 0; i < size; ++i) {
            value = value << 8 | static_cast<uint8_t>(bytes[place + (bigEndian ? i : size - 1 - i)]);
        }
        return value;
    }
};

}  // namespace

Orientation exifOrientation(std::string_view exif) {
    constexpr std::string_view kMark("Exif\0\0", 6);
    if (exif.starts_with(kMark)) { exif.remove_prefix(kMark.size()); }
    const Numbers numbers{exif, exif.starts_with("MM")};
    if (!exif.starts_with("MM") && !exif.starts_with("II")) { return Orientation::TopLeft; }
    const uint64_t directory = numbers.at(4, 4);
    const uint32_t entries = numbers.at(directory, 2);
    for (uint32_t i = 0; i < entries; ++i) {
        const uint64_t entry = directory + 2 + uint64_t{12} * i;
        const uint32_t value = numbers.at(entry + 8, 2);
        if (numbers.at(entry, 2) == kOrientationTag && numbers.at(entry + 2, 2) == kShort && value >= 1 &&
            value <= 8) {
            return static_cast<Orientation>(value);
        }
    }
    return Orientation::TopLeft;
}

Orientation jpegOrientation(std::string_view jpeg) {
    const Numbers numbers{jpeg};
    // Segments before the pixels: 0xFF, a marker, and a length that counts itself.
    for (uint64_t place = 2; numbers.at(place, 1) == 0xff && numbers.at(place + 1, 1) != 0xda;) {
        const uint32_t length = numbers.at(place + 2, 2);
        const std::string_view segment = jpeg.substr(std::min<uint64_t>(place + 4, jpeg.size()));
        if (numbers.at(place + 1, 1) == 0xe1 && segment.starts_with("Exif")) {
            return exifOrientation(segment.substr(0, length < 2 ? 0 : length - 2));
        }
        place += 2 + length;
        if (length < 2) { break; }
    }
    return Orientation::TopLeft;
}

Orientation webpOrientation(std::string_view webp) {
    const Numbers numbers{webp, false};
    // Chunks behind "RIFF", a length and "WEBP": a name, a length, and that many bytes, made even.
    for (uint64_t place = 12; place + 8 <= webp.size();) {
        const uint64_t length = numbers.at(place + 4, 4);
        if (webp.substr(place, 4) == "EXIF") { return exifOrientation(webp.substr(place + 8, length)); }
        place += 8 + length + length % 2;
    }
    return Orientation::TopLeft;
}

}  // namespace glint
