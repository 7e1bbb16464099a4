// The format (Ward 1991, "Real Pixels", and the Radiance file formats manual): text lines, an empty line, a
// line with the size, then scan lines, each 2 2 and its width in 16 bits, then for each of 4 channels runs: a
// byte n > 128 and a value for n - 128 pixels, or n and n values. Widths below 8 or from 32768 on, and older
// files, are 4 plain bytes a pixel.
#include "engine/io/hdr_check.h"

#include <cstddef>
#include <cstdint>

namespace glint {
namespace {

/// What follows the header; empty when there is no end of it.
std::string_view pixelBytes(std::string_view bytes) {
    const size_t headerEnd = bytes.find("\n\n");
    const size_t sizeEnd = headerEnd == std::string_view::npos ? headerEnd : bytes.find('\n', headerEnd + 2);
    return sizeEnd == std::string_view::npos ? std::string_view() : bytes.substr(sizeEnd + 1);
}

/// The bytes that the runs of one channel take, or 0 when they are wrong or cut off.
size_t channelSize(std::string_view bytes, size_t width) {
    size_t at = 0;
    for (size_t pixel = 0; pixel < width;) {
        if (at >= bytes.size()) { return 0; }
        const size_t code = static_cast<uint8_t>(bytes[at]);
        const size_t count = code > 128 ? code - 128 : code;
        if (count == 0 || count > width - pixel) { return 0; }
        pixel += count;
        at += 1 + (code > 128 ? 1 : count);
    }
    return at <= bytes.size() ? at : 0;
}

}  // namespace

bool hdrPixelsAreWhole(std::string_view bytes, int width, int height) {
    std::string_view rest = pixelBytes(bytes);
    const size_t columns = static_cast<size_t>(width);
    const auto beginsRuns = [&] {
        return rest.size() >= 4 && rest[0] == 2 && rest[1] == 2 &&
               (static_cast<uint8_t>(rest[2]) & 0x80) == 0;
    };
    if (width < 8 || width >= 32768 || !beginsRuns()) {
        return rest.size() >= 4 * columns * static_cast<size_t>(height);
    }
    for (int row = 0; row < height; ++row) {
        if (!beginsRuns()) { return false; }
        rest.remove_prefix(4);
        for (int channel = 0; channel < 4; ++channel) {
            const size_t size = channelSize(rest, columns);
            if (size == 0) { return false; }
            rest.remove_prefix(size);
        }
    }
    return true;
}

}  // namespace glint
