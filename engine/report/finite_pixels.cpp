// Plain loops over pixels.
#include "engine/report/finite_pixels.h"

#include <algorithm>
#include <cmath>

namespace glint {

bool isFinitePixel(const ImageF& image, size_t pixel) {
    const float* rgb = image.rgb.data() + 3 * pixel;
    return std::isfinite(rgb[0]) && std::isfinite(rgb[1]) && std::isfinite(rgb[2]);
}

std::vector<uint8_t> finiteInBoth(const ImageF& a, const ImageF& b) {
    std::vector<uint8_t> finite(a.rgb.size() / 3);
    for (size_t i = 0; i < finite.size(); ++i) {
        finite[i] = isFinitePixel(a, i) && isFinitePixel(b, i) ? 1 : 0;
    }
    return finite;
}

ImageF withBlackWhere(const ImageF& image, const std::vector<uint8_t>& finite) {
    ImageF out = image;
    for (size_t i = 0; i < finite.size(); ++i) {
        if (finite[i] == 0) { std::fill_n(out.rgb.begin() + static_cast<std::ptrdiff_t>(3 * i), 3, 0.0f); }
    }
    return out;
}

}  // namespace glint
