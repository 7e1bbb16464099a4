// Which pixels can be compared at all, and pictures that hide the others from filters that look around.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/scene/image.h"

namespace glint {

/// True when all three channels are finite.
bool isFinitePixel(const ImageF& image, size_t pixel);

/// 1 for pixels that are finite in both pictures, which have one size.
std::vector<uint8_t> finiteInBoth(const ImageF& a, const ImageF& b);

/// A copy whose pixels are black where the mask is 0.
ImageF withBlackWhere(const ImageF& image, const std::vector<uint8_t>& finite);

}  // namespace glint
