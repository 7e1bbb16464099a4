// The image formats that Glint reads and writes. Whatever asks what a picture is, or lists what can be read
// or written, asks this table.
//
// A further format is a file image_<name>.cpp that defines its ImageFormat, and a name in image_formats.cpp.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "engine/base/result.h"
#include "engine/io/exr_io.h"
#include "engine/scene/image.h"

namespace glint {

/// One picture in each of the forms that files hold, made when a format asks for it.
struct ImageForms {
    std::function<Image8()> display;           ///< for the eye: exposed and tone-mapped
    std::function<ImageF()> radiance;          ///< linear
    std::function<Result<ExrImage>()> layers;  ///< linear, with layers and attributes
};

struct ImageFormat {
    std::string_view name;        ///< in messages
    std::string_view extensions;  ///< in lower case, with their dots, a blank apart; the first is saved
    bool (*looksLike)(std::string_view head);  ///< whether the file's first bytes are of this format
    /// The pixels, without a source; `path` is used in messages. Grey becomes RGB. Floats may be
    /// negative or not finite. Error: not such an image, broken or cut off, empty, more than
    /// kMaxImagePixels (image_io.h).
    Result<SceneImage> (*decode)(const std::string& bytes, const std::string& path);
    /// Saves atomically; null: not written.
    Status (*save)(const std::string& path, const ImageForms& image) = nullptr;
    bool hasLayers = false;  ///< saves ImageForms::layers
};

std::span<const ImageFormat> imageFormats();

/// The format of a file, as kindOf() tells; null: none.
const ImageFormat* imageFormatOf(const std::string& path, std::string_view bytes);

/// The format that a picture is saved in under that name; null: the name's ending is of none that is written.
const ImageFormat* savedFormatOf(const std::string& path);

/// "PNG, JPEG, … or EXR".
std::string listReadableImages();
/// ".png, .hdr or .exr".
std::string listSavedExtensions();

}  // namespace glint
