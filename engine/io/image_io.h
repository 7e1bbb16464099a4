// Pictures from and to files, whatever their format (image_formats.h).
//
// Grey images become RGB, alpha is dropped. Nothing here knows of exposure or tone mapping
// (render/tonemap.h).
#pragma once

#include <memory>
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
/// replace.
Result<SceneImage> loadImage(const std::string& path);

/// The same from memory, without a source; `path` is used in messages.
Result<SceneImage> decodeImage(const std::string& bytes, const std::string& path);

/// Saves atomically (atomic_file.h). Error: the picture is empty, or the file cannot be written.
Status savePng(const std::string& path, const Image8& image);
/// Radiance RGBE: 8 bits of mantissa shared by the channels, values up to about 1e38, negative ones become 0.
Status saveHdr(const std::string& path, const ImageF& image);

}  // namespace glint
