// pbrt's textures that are formulas: pictures of them where they lie on u and v, their means where they
// fill space.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "engine/io/pbrt_environment.h"
#include "engine/io/pbrt_textures.h"
#include "engine/math/rng.h"

namespace glint {
namespace {

void append(const Vec3& color, ImageF* image) {
    image->rgb.insert(image->rgb.end(), {color.x, color.y, color.z});
}

/// Every second cell of a square of cells has a dot somewhere within it.
ImageF dotsImage(const Vec3& inside, const Vec3& outside) {
    constexpr int kCells = 16, kCellPixels = 32, kSize = kCells * kCellPixels;
    constexpr float kRadius = 0.35f;  // of a cell
    ImageF image{kSize, kSize, {}};
    image.rgb.reserve(size_t{3} * kSize * kSize);
    for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) {
            const auto cell = static_cast<uint64_t>(y / kCellPixels * kCells + x / kCellPixels);
            const auto uniform = [cell](uint64_t dimension) {
                return uniformFloat(static_cast<uint32_t>(hashCounter(cell, dimension)));
            };
            const Vec2 at =
                (Vec2(x % kCellPixels, y % kCellPixels) + Vec2(0.5f)) / static_cast<float>(kCellPixels);
            const Vec2 middle = Vec2(0.5f) + (1.0f - 2.0f * kRadius) * (Vec2(uniform(1), uniform(2)) - 0.5f);
            append(uniform(0) < 0.5f && glm::length(at - middle) < kRadius ? inside : outside, &image);
        }
    }
    return image;
}

}  // namespace

/// Linear between the middles of four texels.
PbrtValue PbrtTextures::makeFourCorners(const PbrtParams& params, bool isNumber) {
    Texture texture;
    place(params, &texture);
    texture.scale *= 0.5f;
    texture.offset = 0.5f * texture.offset + Vec2(0.25f);
    texture.wrapU = texture.wrapV = WrapMode::Clamp;
    ImageF corners{2, 2, {}};
    constexpr std::pair<std::string_view, float> kTopRowFirst[] = {
        {"v01", 1.0f}, {"v11", 1.0f}, {"v00", 0.0f}, {"v10", 0.0f}};
    for (const auto& [name, otherwise] : kTopRowFirst) {
        append(meanOf(part(params, name, isNumber, otherwise)), &corners);
    }
    return baked(texture, corners);
}

PbrtValue PbrtTextures::makeDots(const PbrtParams& params, bool isNumber) {
    params.approximated("approximated: dots are as large and as many, but lie elsewhere");
    Texture texture;
    place(params, &texture);
    texture.scale /= 16.0f;
    texture.offset /= 16.0f;
    const PbrtValue inside = part(params, "inside", isNumber, 1.0f),
                    outside = part(params, "outside", isNumber, 0.0f);
    if (inside.image || outside.image) {
        params.approximated("approximated: images on dots and between them are their means");
    }
    return baked(texture, dotsImage(meanOf(inside), meanOf(outside)));
}

std::optional<PbrtValue> PbrtTextures::projected(const PbrtParams& at, const PbrtValue& image, float tangent,
                                                 float* aspect) {
    const auto pixels = image.image ? pixelsOf(at, *image.image) : nullptr;
    if (!pixels) { return std::nullopt; }
    *aspect = static_cast<float>(pixels->width) / static_cast<float>(pixels->height);
    const Vec2 reach = tangent * Vec2(std::max(*aspect, 1.0f), std::max(1.0f / *aspect, 1.0f));
    // The cosine changes within the texels of small images.
    constexpr int kFewColumns = 1024;
    const int times = (kFewColumns + pixels->width - 1) / pixels->width;
    ImageF out{times * pixels->width, times * pixels->height, {}};
    for (int y = 0; y < out.height; ++y) {
        for (int x = 0; x < out.width; ++x) {
            const Vec2 at01((static_cast<float>(x) + 0.5f) / static_cast<float>(out.width),
                            (static_cast<float>(y) + 0.5f) / static_cast<float>(out.height));
            const Vec2 place = reach * (2.0f * at01 - Vec2(1.0f));
            const float* rgb =
                &pixels->rgb[3 * (static_cast<size_t>(y / times) * static_cast<size_t>(pixels->width) +
                                  static_cast<size_t>(x / times))];
            append(Vec3(rgb[0], rgb[1], rgb[2]) * std::pow(1.0f + glm::dot(place, place), -1.5f), &out);
        }
    }
    Texture texture = *image.image;
    texture.wrapU = texture.wrapV = WrapMode::Clamp;
    texture.filter = TexelFilter::Nearest;
    return baked(texture, out);
}

std::optional<PbrtValue> PbrtTextures::goniometric(const PbrtParams& at, const PbrtValue& image,
                                                   bool isLatLong) {
    const auto pixels = image.image ? pixelsOf(at, *image.image) : nullptr;
    if (!pixels) { return std::nullopt; }
    if (!isLatLong && pixels->width != pixels->height) {
        at.fail(fmt::format(
            "the image \"{}\" has {} x {} pixels; expected a square, in which equal areas are equal "
            "solid angles",
            image.image->name, pixels->width, pixels->height));
        return std::nullopt;
    }
    ImageF grey = isLatLong ? equalAreaOfPbrt(*pixels) : *pixels;
    for (size_t i = 0; i + 2 < grey.rgb.size(); i += 3) {
        std::fill_n(&grey.rgb[i], 3, (grey.rgb[i] + grey.rgb[i + 1] + grey.rgb[i + 2]) / 3.0f);
    }
    Texture texture = *image.image;
    texture.wrapU = texture.wrapV = WrapMode::Clamp;
    texture.filter = TexelFilter::Nearest;
    return baked(texture, grey);
}

/// Perlin's noise has the mean 0 and, without its sign, about 0.2: pbrt's own figure for what octaves too
/// fine to see add to its turbulence.
PbrtValue PbrtTextures::makeNoise(const PbrtParams& params, std::string_view kind) {
    constexpr float kMeanOfUnsigned = 0.2f;
    constexpr Vec3 kMeanOfMarble(0.8f, 0.8f, 0.83f);  // of the colours that its spline mixes
    context_.remark(params.place(), "approximated: textures of noise in space are their mean", kind);
    const int octaves = params.integer("octaves", 8, 0, 64);
    const float roughness = params.number("roughness", 0.5f, 0.0f, 1.0f);
    params.passOver({"scale", "variation"});
    if (kind == "marble") { return {kMeanOfMarble}; }
    float sum = 0.0f, weight = kMeanOfUnsigned;
    for (int i = 0; kind == "wrinkled" && i < octaves; ++i) {
        sum += weight;
        weight *= roughness;
    }
    return {Vec3(sum)};
}

}  // namespace glint
