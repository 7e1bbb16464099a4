// Small picture files of every kind that is read, made byte by byte or by the libraries that write them, with
// the pixels that they hold.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "engine/scene/image.h"

namespace glint::test {

struct PictureFile {
    std::string name;  ///< with the extension of its kind
    std::string bytes;
    Image8 pixels;      ///< what it shows
    int tolerance = 0;  ///< of a channel
};

/// 6 x 5 pixels, no two alike, that no turn or reflection leaves as they are.
Image8 patternImage();
/// The same with a transparent, a half transparent and otherwise opaque pixels.
Image8 transparentImage();

/// PNG, JPEG, BMP, TGA, TIFF, WebP, DDS, GIF, PNM and PSD, each with its ways of storing pixels.
std::vector<PictureFile> pictureFiles();
/// HDR, EXR and TIFF files of floats; their pixels are 1 / 255 each.
std::vector<PictureFile> floatPictureFiles();

/// 16 x 8 pixels, the left half white.
Image8 halfWhiteImage();
/// The TIFF header and directory of an EXIF block of that orientation.
std::string exifOf(int orientation);
/// The picture above with such a block.
std::string jpegWithOrientation(int orientation);
std::string webpWithOrientation(int orientation);

/// 6 x 5 pixels of four colours in turn, by their numbers of 1, 2, 4 or 8 bits; the palette has the first
/// `colors`. Interlaced below 8 bits.
std::string palettePng(int colors, int bits);

/// Numbers as files of one byte order or the other have them.
std::string little(uint64_t value, int bytes);
std::string big(uint64_t value, int bytes);

}  // namespace glint::test
