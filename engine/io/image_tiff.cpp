// TIFF through libtiff: the file's first picture. Floats stay floats, everything else becomes 8 bits.
#include <cstdarg>
#include <cstdio>
#include <cstring>

#include <tiffio.h>

#include "engine/io/image_builder.h"
#include "engine/io/image_formats.h"

namespace glint {
namespace {

/// libtiff's view of a file in memory, and its first message.
struct Reading {
    std::string_view bytes;
    uint64_t position = 0;
    std::string reason = {};

    /// Strips and tiles may be larger than the picture, but not than what the file unpacks to.
    uint64_t mostBlockBytes() const { return std::max(uint64_t{64} << 20, uint64_t{1032} * bytes.size()); }
};

Reading* readingOf(thandle_t handle) { return static_cast<Reading*>(handle); }

tmsize_t readBytes(thandle_t handle, void* out, tmsize_t count) {
    Reading* reading = readingOf(handle);
    const uint64_t left =
        reading->bytes.size() - std::min<uint64_t>(reading->position, reading->bytes.size());
    const uint64_t read = std::min(static_cast<uint64_t>(std::max<tmsize_t>(count, 0)), left);
    if (read > 0) { std::memcpy(out, reading->bytes.data() + reading->position, read); }
    reading->position += read;
    return static_cast<tmsize_t>(read);
}

tmsize_t refuseToWrite(thandle_t, void*, tmsize_t) { return 0; }

toff_t seek(thandle_t handle, toff_t offset, int whence) {
    Reading* reading = readingOf(handle);
    const uint64_t from =
        whence == SEEK_SET ? 0 : (whence == SEEK_CUR ? reading->position : reading->bytes.size());
    return reading->position = from + offset;
}

int close(thandle_t) { return 0; }
toff_t sizeOf(thandle_t handle) { return readingOf(handle)->bytes.size(); }

int onError(TIFF*, void* user, const char*, const char* format, va_list arguments) {
    char text[256];
    std::vsnprintf(text, sizeof text, format, arguments);
    auto* reading = static_cast<Reading*>(user);
    if (reading->reason.empty()) { reading->reason = text; }
    return 1;
}

int onWarning(TIFF*, void*, const char*, const char*, va_list) { return 1; }

struct CloseTiff {
    void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};
using Tiff = std::unique_ptr<TIFF, CloseTiff>;

Tiff openTiff(Reading* reading) {
    TIFFOpenOptions* options = TIFFOpenOptionsAlloc();
    TIFFOpenOptionsSetErrorHandlerExtR(options, onError, reading);
    TIFFOpenOptionsSetWarningHandlerExtR(options, onWarning, reading);
    TIFFOpenOptionsSetMaxSingleMemAlloc(options, static_cast<tmsize_t>(reading->mostBlockBytes()));
    Tiff tiff(TIFFClientOpenExt("", "rm", reading, readBytes, refuseToWrite, seek, close, sizeOf, nullptr,
                                nullptr, options));
    TIFFOpenOptionsFree(options);
    return tiff;
}

template <class Number>
Number tag(const Tiff& tiff, uint32_t which, Number otherwise = 0) {
    Number value = 0;
    return TIFFGetFieldDefaulted(tiff.get(), which, &value) != 0 ? value : otherwise;
}

/// By how the pixels are packed: a fax line of one colour takes a bit, Zstandard and LZMA have long repeats,
/// the others pack no closer than Deflate.
double mostPixelsPerByte(uint16_t compression, uint32_t width) {
    switch (compression) {
        case COMPRESSION_CCITTRLE:
        case COMPRESSION_CCITTFAX3:
        case COMPRESSION_CCITTFAX4:
            return 8.0 * width;
        case COMPRESSION_ZSTD:
        case COMPRESSION_LZMA:
        case COMPRESSION_LERC:
        case COMPRESSION_WEBP:
            return 8.0 * 40'000.0;
        default:
            return 8.0 * 1032.0;
    }
}

/// Any kind of integers, as libtiff makes them red, green, blue and alpha. False: its message tells.
bool readIntegers(const Tiff& tiff, Reading* reading, Image8Builder* builder) {
    const PixelPlaces& places = builder->places();
    TIFFRGBAImage image;
    char message[1024] = {};
    if (TIFFRGBAImageBegin(&image, tiff.get(), 1, message) == 0) {
        reading->reason = message;
        return false;
    }
    const auto width = static_cast<size_t>(places.storedWidth);
    // Asking for the orientation that the picture has gives its rows as they are stored.
    image.orientation = image.req_orientation = ORIENTATION_TOPLEFT;
    std::vector<uint32_t> raster(width * static_cast<size_t>(places.storedHeight));
    const bool whole = TIFFRGBAImageGet(&image, raster.data(), image.width, image.height) != 0;
    TIFFRGBAImageEnd(&image);
    std::vector<uint8_t> rgba(4 * width);
    for (int row = 0; whole && row < places.storedHeight; ++row) {
        for (size_t x = 0; x < width; ++x) {
            const uint32_t packed = raster[static_cast<size_t>(row) * width + x];
            const uint32_t alpha = TIFFGetA(packed);
            const auto straight = [alpha](uint32_t c) {  // libtiff multiplies by alpha
                return static_cast<uint8_t>(alpha == 0 ? c : std::min(255u, (c * 255 + alpha / 2) / alpha));
            };
            rgba[4 * x] = straight(TIFFGetR(packed));
            rgba[4 * x + 1] = straight(TIFFGetG(packed));
            rgba[4 * x + 2] = straight(TIFFGetB(packed));
            rgba[4 * x + 3] = static_cast<uint8_t>(alpha);
        }
        builder->setRow(row, rgba);
    }
    return whole;
}

/// How the floats lie in the file: in tiles, or strips as wide as the picture, of all channels or of
/// one each.
struct FloatBlocks {
    int width = 0;
    int height = 0;
    int samples = 1;  ///< in a pixel of a block
    int planes = 1;
    size_t sampleBytes = 4;  ///< 2 or 4
};

FloatBlocks floatBlocks(const Tiff& tiff, const PixelPlaces& places) {
    const bool tiled = TIFFIsTiled(tiff.get()) != 0;
    const bool planar = tag<uint16_t>(tiff, TIFFTAG_PLANARCONFIG) == PLANARCONFIG_SEPARATE;
    const int samples = tag<uint16_t>(tiff, TIFFTAG_SAMPLESPERPIXEL);
    const uint32_t stripRows = tag<uint32_t>(tiff, TIFFTAG_ROWSPERSTRIP);
    const auto rows = std::min(stripRows, static_cast<uint32_t>(places.storedHeight));
    return {.width = tiled ? static_cast<int>(tag<uint32_t>(tiff, TIFFTAG_TILEWIDTH)) : places.storedWidth,
            .height = static_cast<int>(tiled ? tag<uint32_t>(tiff, TIFFTAG_TILELENGTH) : rows),
            .samples = planar ? 1 : samples,
            .planes = planar ? samples : 1,
            .sampleBytes = tag<uint16_t>(tiff, TIFFTAG_BITSPERSAMPLE) / size_t{8}};
}

/// Grey repeats its one channel; alpha is not looked at.
void copyBlock(const std::vector<uint8_t>& stored, const FloatBlocks& blocks, int plane, int left, int top,
               ImageFBuilder* builder) {
    const PixelPlaces& places = builder->places();
    const bool grey = blocks.samples * blocks.planes < 3;
    const int channels = std::min(blocks.samples, (grey ? 1 : 3) - plane);
    const size_t pixelBytes = static_cast<size_t>(blocks.samples) * blocks.sampleBytes;
    for (int y = 0; y < std::min(blocks.height, places.storedHeight - top); ++y) {
        const uint8_t* from =
            &stored[static_cast<size_t>(y) * static_cast<size_t>(blocks.width) * pixelBytes];
        for (int x = 0; x < std::min(blocks.width, places.storedWidth - left); ++x, from += pixelBytes) {
            float* pixel = builder->pixel(left + x, top + y);
            for (int c = 0; c < channels; ++c) {
                pixel[plane + c] =
                    storedFloat(from + static_cast<size_t>(c) * blocks.sampleBytes, blocks.sampleBytes);
            }
            if (grey && plane == 0) { pixel[1] = pixel[2] = pixel[0]; }
        }
    }
}

/// False: libtiff's message tells.
bool readFloats(const Tiff& tiff, const FloatBlocks& blocks, const Reading& reading, ImageFBuilder* builder) {
    const PixelPlaces& places = builder->places();
    const bool tiled = TIFFIsTiled(tiff.get()) != 0;
    const tmsize_t size = tiled ? TIFFTileSize(tiff.get()) : TIFFStripSize(tiff.get());
    const double blockBytes = static_cast<double>(blocks.width) * blocks.height * blocks.samples *
                              static_cast<double>(blocks.sampleBytes);
    if (blockBytes > static_cast<double>(reading.mostBlockBytes())) { return false; }
    std::vector<uint8_t> stored(static_cast<size_t>(blockBytes));
    if (size <= 0 || static_cast<size_t>(size) > stored.size()) { return false; }
    uint32_t index = 0;
    for (int plane = 0; plane < blocks.planes; ++plane) {
        for (int top = 0; top < places.storedHeight; top += blocks.height) {
            for (int left = 0; left < places.storedWidth; left += blocks.width) {
                const tmsize_t read = tiled ? TIFFReadEncodedTile(tiff.get(), index, stored.data(), size)
                                            : TIFFReadEncodedStrip(tiff.get(), index, stored.data(), size);
                ++index;
                const int rows = tiled ? blocks.height : std::min(blocks.height, places.storedHeight - top);
                if (read < size / blocks.height * rows) { return false; }
                copyBlock(stored, blocks, plane, left, top, builder);
            }
        }
    }
    return true;
}

Result<SceneImage> decode(const std::string& bytes, const std::string& path) {
    Reading reading{bytes};
    const Tiff tiff = openTiff(&reading);
    if (!tiff) { return brokenImage(path, reading.reason); }
    const auto width = tag<uint32_t>(tiff, TIFFTAG_IMAGEWIDTH);
    const auto height = tag<uint32_t>(tiff, TIFFTAG_IMAGELENGTH);
    const double most = mostPixelsPerByte(tag<uint16_t>(tiff, TIFFTAG_COMPRESSION), width);
    if (Status size = checkStatedSize(path, width, height, bytes.size(), most); !size) {
        return size.error();
    }
    const auto orientation = tag<uint16_t>(tiff, TIFFTAG_ORIENTATION, 1);
    const PixelPlaces places{
        static_cast<int>(width), static_cast<int>(height),
        orientation >= 1 && orientation <= 8 ? static_cast<Orientation>(orientation) : Orientation::TopLeft};
    if (tag<uint16_t>(tiff, TIFFTAG_SAMPLEFORMAT) == SAMPLEFORMAT_IEEEFP) {
        const FloatBlocks blocks = floatBlocks(tiff, places);
        if ((blocks.sampleBytes != 2 && blocks.sampleBytes != 4) || blocks.width <= 0 || blocks.height <= 0) {
            return imageError(path, "holds floats of another size; expected 16 or 32 bits each");
        }
        ImageFBuilder builder(places);
        return readFloats(tiff, blocks, reading, &builder) ? Result<SceneImage>(builder.take())
                                                           : brokenImage(path, reading.reason);
    }
    Image8Builder builder(places);
    return readIntegers(tiff, &reading, &builder) ? Result<SceneImage>(builder.take())
                                                  : brokenImage(path, reading.reason);
}

}  // namespace

extern const ImageFormat kImageTiff;
const ImageFormat kImageTiff{.name = "TIFF",
                             .extensions = ".tif .tiff",
                             .looksLike =
                                 [](std::string_view head) {
                                     return head.starts_with(std::string_view("II*\0", 4)) ||
                                            head.starts_with(std::string_view("MM\0*", 4)) ||
                                            head.starts_with(std::string_view("II+\0", 4)) ||
                                            head.starts_with(std::string_view("MM\0+", 4));
                                 },
                             .decode = decode};

}  // namespace glint
