// The smaller images of a mip map.
#pragma once

#include <vector>

#include "engine/kernels/shading_view.h"

namespace glint {

/// What TextureView::mips points to: linear values of each level from half the image's size to one texel.
/// Every level has the mean of the image, whatever its size: texels count by the part of them that a smaller
/// one covers.
std::vector<float> mipLevels(const TextureView& texture);

}  // namespace glint
