// Pictures from and to files, whatever their format (image_formats.h).
//
// Grey images become RGB. Nothing here knows of exposure or tone mapping (render/tonemap.h).
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "engine/base/result.h"
#include "engine/scene/image.h"

namespace glint {

/// Most pixels in an image that is read; checked before anything is allocated.
constexpr uint64_t kMaxImagePixels = uint64_t{1} << 28;

/// An 8-bit image as stored. Error: not readable, an HDR or EXR image, broken, empty, more
/// than kMaxImagePixels.
Result<std::shared_ptr<const Image8>> loadImage8(const std::string& path);

/// Linear colours: HDR and EXR as stored, 8-bit images decoded from sRGB. Every value of the result
/// is finite.
Result<std::shared_ptr<const ImageF>> loadImageF(const std::string& path);

/// What loadImageF() makes of an image that loadImage() has read.
std::shared_ptr<const ImageF> linearColors(const SceneImage& image);

/// Either of the two, as the file's content asks for; the source is the given path, which the caller may
/// replace. Error: also a float that is not finite.
Result<SceneImage> loadImage(const std::string& path);

/// The bytes of an image's file, for decodeImage(): its first ones alone where they are of no image. Error:
/// as readFile() (atomic_file.h); more than 2 GiB.
Result<std::string> readImageFile(const std::string& path);

/// The pixels, without a source; `path` is used in messages. Floats may be negative or not finite.
Result<SceneImage> decodeImage(const std::string& bytes, const std::string& path);

/// Error: a value that is not finite, with its place.
Status checkFinite(const ImageF& image, const std::string& path);

/// Memory that the pixels would take, as the first 64 KiB of the file say; nothing where they do not (EXR,
/// TIFF, WebP, broken or missing files).
std::optional<uint64_t> statedPixelBytes(const std::string& path);

/// A PNG file's bytes, with the picture's alpha. `path` is used in messages. Error: the picture is empty.
Result<std::string> encodePng(const Image8& image, const std::string& path);
/// Saves atomically (atomic_file.h). Error: the picture is empty, or the file cannot be written.
Status savePng(const std::string& path, const Image8& image);
/// Radiance RGBE: 8 bits of mantissa shared by the channels, values up to about 1e38, negative ones become 0.
Status saveHdr(const std::string& path, const ImageF& image);

}  // namespace glint
