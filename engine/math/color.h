// Linear Rec.709 colour. Host and device.
#pragma once

#include "engine/math/vec.h"

namespace glint {

GLINT_HD inline float luminance(const Vec3& rgb) {
    return 0.2126f * rgb.x + 0.7152f * rgb.y + 0.0722f * rgb.z;
}

/// IEC 61966-2-1 transfer functions for one channel in [0, 1].
GLINT_HD inline float srgbToLinear(float encoded) {
    return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}
GLINT_HD inline float linearToSrgb(float linear) {
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

}  // namespace glint
