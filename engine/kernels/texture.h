// Image textures as colours. Host and device. Called when a BSDF is made.
//
// Left out: mip maps and other prefiltering (many samples a pixel average a texture, too).
#pragma once

#include "engine/kernels/features.h"
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

/// The same beyond [0, 1] by `wrap`. Nearest: all weight is on one of the two.
GLINT_HD inline TexelPair texelPair(float coordinate, int size, WrapMode wrap, TexelFilter filter) {
    TexelPair pair;
    if (wrap == WrapMode::Repeat) {
        pair = texelPair(coordinate, size);
    } else {
        float place = std::isfinite(coordinate) ? coordinate : 0.0f;
        if (wrap == WrapMode::Mirror) {
            place -= 2.0f * std::floor(0.5f * place);
            place = place > 1.0f ? 2.0f - place : place;
        }
        const float position = clampf(place, 0.0f, 1.0f) * static_cast<float>(size) - 0.5f;
        const float below = std::floor(position);
        const int index = static_cast<int>(below);
        pair = {index < 0 ? 0 : index, index + 1 < size ? index + 1 : size - 1, position - below};
    }
    if (filter == TexelFilter::Nearest) { pair.weight = pair.weight < 0.5f ? 0.0f : 1.0f; }
    return pair;
}

/// The texels around uv; v runs upwards from the image's bottom row, unless flipV is set.
template <FeatureMask kMask>
GLINT_HD void findTexels(const TextureView& texture, Vec2 uv, TexelPair* x, TexelPair* y) {
    Vec2 place(uv.x * texture.scale.x, uv.y * texture.scale.y);
    if constexpr (hasFeature<kMask>(kFeaturePlacedTextures)) {
        const Vec2 turn = texture.turn;
        if (turn.y != 0.0f || turn.x != 1.0f) {
            place = {turn.x * place.x - turn.y * place.y, turn.y * place.x + turn.x * place.y};
        }
        place += texture.offset;
        const float down = texture.wrapV == WrapMode::Repeat ? -place.y : 1.0f - place.y;
        *x = texelPair(place.x, texture.width, texture.wrapU, texture.filter);
        *y = texelPair(texture.flipV ? place.y : down, texture.height, texture.wrapV, texture.filter);
    } else {
        *x = texelPair(place.x, texture.width);
        *y = texelPair(texture.flipV ? place.y : -place.y, texture.height);
    }
}

}  // namespace detail

/// The linear colour at uv.
template <FeatureMask kMask = kAllFeatures>
GLINT_HD Vec3 sampleTexture(const TextureView& texture, Vec2 uv) {
    detail::TexelPair x, y;
    detail::findTexels<kMask>(texture, uv, &x, &y);
    const Vec3 top = glm::mix(detail::texel(texture, x.first, y.first),
                              detail::texel(texture, x.second, y.first), x.weight);
    const Vec3 bottom = glm::mix(detail::texel(texture, x.first, y.second),
                                 detail::texel(texture, x.second, y.second), x.weight);
    return glm::mix(top, bottom, y.weight);
}

/// Numbers at uv that are no colours: bytes count as linear, whatever the encoding.
template <FeatureMask kMask = kAllFeatures>
GLINT_HD Vec3 sampleNumbers(TextureView texture, Vec2 uv) {
    texture.encoding = ColorEncoding::Linear;
    return sampleTexture<kMask>(texture, uv);
}

}  // namespace glint
