// Checks the runs of a Radiance HDR file before stb_image decodes them: up to version 2.28 (2023) it never
// ends on a run of length 0, which is also what it reads beyond the end of a file that is cut off. Called by
// image_io.cpp only.
#pragma once

#include <string_view>

namespace glint {

/// True when the pixels that a file of this size announces are all there. `bytes` begins with an HDR header
/// that stb_image accepts.
bool hdrPixelsAreWhole(std::string_view bytes, int width, int height);

}  // namespace glint
