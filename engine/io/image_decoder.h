// PNG, JPEG, BMP, TGA, Radiance HDR and what else stb_image knows, from memory.
#pragma once

#include <optional>
#include <string>

#include "engine/base/result.h"
#include "engine/scene/image.h"

namespace glint {

/// The decoded pixels, without a source; `path` is used in messages. Grey images become RGB, alpha is
/// dropped. Error: not such an image, broken, empty, more than kMaxImagePixels (image_io.h).
Result<SceneImage> decode8(const std::string& bytes, const std::string& path);
/// The same for Radiance HDR. Error: also a value that is not finite.
Result<SceneImage> decodeHdr(const std::string& bytes, const std::string& path);

/// Memory that the pixels would take, as the first 64 KiB of the file say; nothing where they do not (EXR,
/// broken or missing files).
std::optional<uint64_t> statedPixelBytes(const std::string& path);

}  // namespace glint
