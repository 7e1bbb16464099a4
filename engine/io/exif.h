// The one thing that Glint asks of EXIF: which way up the camera was held.
#pragma once

#include <string_view>

#include "engine/io/image_builder.h"

namespace glint {

/// The orientation that an EXIF block states; `exif` begins with its TIFF header ("II" or "MM"), or with
/// "Exif\0\0" before that. TopLeft where it states none or is broken.
Orientation exifOrientation(std::string_view exif);

/// The same of a JPEG file, from its APP1 segment.
Orientation jpegOrientation(std::string_view jpeg);

/// The same of a WebP file, from its EXIF chunk.
Orientation webpOrientation(std::string_view webp);

}  // namespace glint
