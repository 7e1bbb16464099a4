// Image textures as colours: bilinear, repeating. Host and device. Called when a BSDF is made.
//
// Left out: mip maps and other prefiltering (many samples a pixel average a texture, too); other wrap modes.
#pragma once

#include "engine/kernels/shading_view.h"

namespace glint {
namespace detail {

/// (x + 0.055)/1.055 to the power 2.4 without a library, so that the table below is made by the compiler: by
/// Newton's iteration for the fifth root of base^12.
constexpr double powTwelveFifths(double base) {
    const double squared = base * base;
    const double twelfth = squared * squared * squared * squared * squared * squared;
    double root = 1.0;
    for (int i = 0; i < 200; ++i) {
        const double fourth = root * root * root * root;
        root -= (fourth * root - twelfth) / (5.0 * fourth);
    }
    return root;
}

struct SrgbTable {
    float linear[256];
};

constexpr SrgbTable makeSrgbTable() {
    SrgbTable table{};
    for (int i = 0; i < 256; ++i) {
        const double encoded = i / 255.0;
        table.linear[i] = static_cast<float>(encoded <= 0.04045 ? encoded / 12.92
                                                                : powTwelveFifths((encoded + 0.055) / 1.055));
    }
    return table;
}

/// Linear value of an sRGB byte (IEC 61966-2-1).
GLINT_HD inline float srgbByteToLinear(uint8_t byte) {
    static constexpr SrgbTable kTable = makeSrgbTable();
    return kTable.linear[byte];
}

GLINT_HD inline Vec3 texel(const TextureView& texture, int x, int y) {
    const size_t index =
        3 * (static_cast<size_t>(y) * static_cast<size_t>(texture.width) + static_cast<size_t>(x));
    if (texture.floats != nullptr) {
        const float* rgb = texture.floats + index;
        return {rgb[0], rgb[1], rgb[2]};
    }
    const uint8_t* rgb = texture.bytes + index;
    if (texture.encoding == ColorEncoding::Srgb) {
        return {srgbByteToLinear(rgb[0]), srgbByteToLinear(rgb[1]), srgbByteToLinear(rgb[2])};
    }
    return Vec3(rgb[0], rgb[1], rgb[2]) * (1.0f / 255.0f);
}

/// The texel left of (or above) a coordinate, its right neighbour, and the weight of the latter.
struct TexelPair {
    int first, second;
    float weight;
};

/// Repeats: any float is allowed; what is not finite counts as 0. Texel centres lie at (i + 1/2) / size.
GLINT_HD inline TexelPair texelPair(float coordinate, int size) {
    const float finite = std::isfinite(coordinate) ? coordinate : 0.0f;
    const float position = (finite - std::floor(finite)) * static_cast<float>(size) - 0.5f;
    const float below = std::floor(position);
    const int index = static_cast<int>(below);
    const int first = index < 0 ? index + size : (index >= size ? index - size : index);
    return {first, first + 1 == size ? 0 : first + 1, position - below};
}

}  // namespace detail

/// The linear colour at uv. v runs upwards from the image's bottom row, unless flipV is set.
GLINT_HD inline Vec3 sampleTexture(const TextureView& texture, Vec2 uv) {
    const float u = uv.x * texture.scale.x;
    const float v = uv.y * texture.scale.y;
    const detail::TexelPair x = detail::texelPair(u, texture.width);
    const detail::TexelPair y = detail::texelPair(texture.flipV ? v : -v, texture.height);
    const Vec3 top = glm::mix(detail::texel(texture, x.first, y.first),
                              detail::texel(texture, x.second, y.first), x.weight);
    const Vec3 bottom = glm::mix(detail::texel(texture, x.first, y.second),
                                 detail::texel(texture, x.second, y.second), x.weight);
    return glm::mix(top, bottom, y.weight);
}

/// Numbers at uv that are no colours: bytes count as linear, whatever the encoding.
GLINT_HD inline Vec3 sampleNumbers(TextureView texture, Vec2 uv) {
    texture.encoding = ColorEncoding::Linear;
    return sampleTexture(texture, uv);
}

}  // namespace glint
