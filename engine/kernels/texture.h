// Image textures as colours and numbers. Host and device. Called when a BSDF is made, for bumps and cut-outs.
//
// Mip maps are isotropic (Williams 1983, "Pyramidal Parametrics"), with linear values and each level the
// exact mean of the one before, whatever its size. Left out: anisotropic filters, since many samples a pixel
// average a texture, too; mip maps of alpha, since a ray passes a cut-out or does not (cutout.h): with the
// mean in place of the texels as many would, and the noise would stay.
#pragma once

#include "engine/kernels/features.h"
#include "engine/kernels/shading_view.h"
#include "engine/math/color.h"

namespace glint {

/// Half the texels each way, rounded down: the next level of a mip map.
GLINT_HD inline int nextMipSize(int size) { return size > 1 ? size / 2 : 1; }

/// Floats in TextureView::mips of an image of this size.
GLINT_HD inline size_t mipValues(int width, int height) {
    size_t values = 0;
    while (width > 1 || height > 1) {
        width = nextMipSize(width);
        height = nextMipSize(height);
        values += 3 * static_cast<size_t>(width) * static_cast<size_t>(height);
    }
    return values;
}

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

/// Where uv lie in the image but for its wrapping, which wants v of repeated images to run downwards.
template <FeatureMask kMask>
GLINT_HD Vec2 placedUv(const TextureView& texture, Vec2 uv) {
    Vec2 place(uv.x * texture.scale.x, uv.y * texture.scale.y);
    if constexpr (hasFeature<kMask>(kFeaturePlacedTextures)) {
        const Vec2 turn = texture.turn;
        if (turn.y != 0.0f || turn.x != 1.0f) {
            place = {turn.x * place.x - turn.y * place.y, turn.y * place.x + turn.x * place.y};
        }
        place += texture.offset;
    }
    return place;
}

/// The texels around uv; v runs upwards from the image's bottom row, unless flipV is set.
template <FeatureMask kMask>
GLINT_HD void findTexels(const TextureView& texture, Vec2 uv, TexelPair* x, TexelPair* y) {
    const Vec2 place = placedUv<kMask>(texture, uv);
    if constexpr (hasFeature<kMask>(kFeaturePlacedTextures)) {
        const float down = texture.wrapV == WrapMode::Repeat ? -place.y : 1.0f - place.y;
        *x = texelPair(place.x, texture.width, texture.wrapU, texture.filter);
        *y = texelPair(texture.flipV ? place.y : down, texture.height, texture.wrapV, texture.filter);
    } else {
        *x = texelPair(place.x, texture.width);
        *y = texelPair(texture.flipV ? place.y : -place.y, texture.height);
    }
}

template <FeatureMask kMask>
GLINT_HD Vec3 mixTexels(const TextureView& texture, Vec2 uv) {
    TexelPair x, y;
    findTexels<kMask>(texture, uv, &x, &y);
    const Vec3 top = glm::mix(texel(texture, x.first, y.first), texel(texture, x.second, y.first), x.weight);
    const Vec3 bottom =
        glm::mix(texel(texture, x.first, y.second), texel(texture, x.second, y.second), x.weight);
    return glm::mix(top, bottom, y.weight);
}

/// The texture with a level of its mip map for its image; 0 is the image itself.
GLINT_HD inline TextureView mipLevel(const TextureView& texture, int level) {
    TextureView view = texture;
    for (int i = 0; i < level; ++i) {
        view.bytes = nullptr;
        view.floats =
            i == 0 ? texture.mips
                   : view.floats + 3 * static_cast<size_t>(view.width) * static_cast<size_t>(view.height);
        view.width = nextMipSize(view.width);
        view.height = nextMipSize(view.height);
    }
    return view;
}

/// The mean over about `uvWidth` of u and v.
template <FeatureMask kMask>
GLINT_HD Vec3 sampleMipmap(const TextureView& texture, Vec2 uv, float uvWidth) {
    const float texels = std::fabs(texture.scale.x * texture.scale.y) * static_cast<float>(texture.width) *
                         static_cast<float>(texture.height);
    const float coarsest =
        std::log2(static_cast<float>(texture.width > texture.height ? texture.width : texture.height));
    const float level = minf(std::log2(uvWidth * std::sqrt(texels)), std::floor(coarsest));
    if (!(level > 0.0f)) { return mixTexels<kMask>(texture, uv); }
    const float below = std::floor(level);
    const TextureView fine = mipLevel(texture, static_cast<int>(below));
    const Vec3 finer = mixTexels<kMask>(fine, uv);
    if (level == below) { return finer; }
    return glm::mix(finer, mixTexels<kMask>(mipLevel(texture, static_cast<int>(below) + 1), uv),
                    level - below);
}

/// What the texture shows for what its image holds.
template <FeatureMask kMask, class Value>
GLINT_HD Value adjusted(const TextureView& texture, Value value) {
    if constexpr (hasFeature<kMask>(kFeaturePlacedTextures)) {
        if (texture.base != 0.0f || texture.gain != 1.0f) { value = texture.base + texture.gain * value; }
        if (texture.exponent != 1.0f) {
            value = glm::pow(glm::max(value, Value(0.0f)), Value(texture.exponent));
        }
    }
    return value;
}

}  // namespace detail

/// The linear colour at uv. uvWidth: what a pixel covers of u and v, for textures with a mip map.
template <FeatureMask kMask = kAllFeatures>
GLINT_HD Vec3 sampleTexture(const TextureView& texture, Vec2 uv, float uvWidth = 0.0f) {
    if constexpr (hasFeature<kMask>(kFeatureMipmaps)) {
        if (texture.mips != nullptr && uvWidth > 0.0f) {
            return detail::adjusted<kMask>(texture, detail::sampleMipmap<kMask>(texture, uv, uvWidth));
        }
    }
    return detail::adjusted<kMask>(texture, detail::mixTexels<kMask>(texture, uv));
}

/// Numbers at uv that are no colours: bytes count as linear, whatever the encoding. Mip maps of bytes that
/// are sRGB for others do not hold them.
template <FeatureMask kMask = kAllFeatures>
GLINT_HD Vec3 sampleNumbers(TextureView texture, Vec2 uv, float uvWidth = 0.0f) {
    if (texture.encoding != ColorEncoding::Linear) { texture.mips = nullptr; }
    texture.encoding = ColorEncoding::Linear;
    return sampleTexture<kMask>(texture, uv, uvWidth);
}

/// The image's alpha at uv, as it is.
template <FeatureMask kMask = kAllFeatures>
GLINT_HD float sampleAlpha(const TextureView& texture, Vec2 uv) {
    if (texture.alpha == nullptr) { return 1.0f; }
    detail::TexelPair x, y;
    detail::findTexels<kMask>(texture, uv, &x, &y);
    const auto at = [&](int column, int row) {
        return static_cast<float>(
                   texture.alpha[static_cast<size_t>(row) * static_cast<size_t>(texture.width) +
                                 static_cast<size_t>(column)]) *
               (1.0f / 255.0f);
    };
    return glm::mix(glm::mix(at(x.first, y.first), at(x.second, y.first), x.weight),
                    glm::mix(at(x.first, y.second), at(x.second, y.second), x.weight), y.weight);
}

/// The single number that the texture shows at uv: its channel.
template <FeatureMask kMask = kAllFeatures>
GLINT_HD float sampleNumber(const TextureView& texture, Vec2 uv, float uvWidth = 0.0f) {
    if constexpr (hasFeature<kMask>(kFeaturePlacedTextures)) {
        if (texture.channel == TextureChannel::Alpha) {
            return detail::adjusted<kMask>(texture, sampleAlpha<kMask>(texture, uv));
        }
        const Vec3 numbers = sampleNumbers<kMask>(texture, uv, uvWidth);
        switch (texture.channel) {
            case TextureChannel::Green:
                return numbers.y;
            case TextureChannel::Blue:
                return numbers.z;
            case TextureChannel::Luminance:
                return luminance(numbers);
            default:
                return numbers.x;
        }
    }
    return sampleNumbers<kMask>(texture, uv, uvWidth).x;
}

}  // namespace glint
