// Pictures that importers make, as files in memory.
#pragma once

#include <string>

#include "engine/scene/image.h"

namespace glint {

/// A picture as a file in memory that bears a name beside that of `path`.
ImageSource bakedImage(const ImageF& image, const std::string& path, size_t number);

}  // namespace glint
