// Images of pbrt's textures, and what is computed of their texels where Glint's textures cannot.
#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "engine/io/baked_image.h"
#include "engine/io/image_io.h"
#include "engine/io/pbrt_textures.h"
#include "engine/math/color.h"

namespace glint {
namespace {

Vec3 texelOf(const ImageF& image, int x, int y) {
    const float* rgb =
        &image.rgb[3 * (static_cast<size_t>(y) * static_cast<size_t>(image.width) + static_cast<size_t>(x))];
    return {rgb[0], rgb[1], rgb[2]};
}

bool sitsAlike(const Texture& a, const Texture& b) {
    return a.flipV == b.flipV && a.scale == b.scale && a.offset == b.offset &&
           a.rotationDeg == b.rotationDeg && a.wrapU == b.wrapU && a.wrapV == b.wrapV;
}

WrapMode wrapOf(const PbrtParams& params) {
    const std::string word = params.text("wrap", "repeat");
    if (word == "repeat") { return WrapMode::Repeat; }
    if (word != "clamp") {
        params.context().remark(params.place(), "approximated: images are clamped beyond their edges", word);
    }
    return WrapMode::Clamp;
}

}  // namespace

/// "sRGB", "linear", or "gamma 2.2", whose values are raised to that power.
void PbrtTextures::setEncoding(const PbrtParams& params, float scale, bool isInverted, Texture* texture) {
    const std::string encoding = params.text("encoding", params.flag("gamma", true) ? "sRGB" : "linear");
    float gamma = 1.0f;
    if (encoding.starts_with("gamma ")) {
        std::from_chars(encoding.data() + 6, encoding.data() + encoding.size(), gamma);
        gamma = gamma > 0.1f && gamma < 10.0f ? gamma : 1.0f;
    } else if (encoding != "linear" && encoding != "sRGB") {
        context_.remark(params.place(), "approximated: images of an unknown encoding are sRGB", encoding);
    }
    const bool isCurve = gamma != 1.0f;
    texture->encoding = isCurve || encoding == "linear" ? ColorEncoding::Linear : ColorEncoding::Srgb;
    if (isCurve && isInverted) {
        params.approximated("approximated: images of a gamma that are inverted are sRGB");
        texture->encoding = ColorEncoding::Srgb;
    } else if (isCurve) {
        texture->exponent = gamma;
    }
    texture->base = isInverted ? 1.0f : 0.0f;
    texture->gain = isInverted ? -scale : std::pow(scale, 1.0f / texture->exponent);
}

PbrtValue PbrtTextures::makeImage(const PbrtParams& params, bool isNumber) {
    Texture texture;
    place(params, &texture);
    texture.wrapU = texture.wrapV = wrapOf(params);
    const std::string filter = params.text("filter", "bilinear");
    texture.filter = filter == "point" ? TexelFilter::Nearest : TexelFilter::Bilinear;
    setEncoding(params, params.number("scale", 1.0f, 0.0f), params.flag("invert", false), &texture);
    params.passOver({"maxanisotropy", "trilinear"});
    if (!params.has("filename")) {
        params.fail("the imagemap has no \"filename\"");
        return {};
    }
    texture.image.source = FileSource{context_.fileOf(params.place(), params.text("filename"))};
    return isNumber ? ofNumbers(params, texture) : PbrtValue{Vec3(0.5f), texture};
}

PbrtValue PbrtTextures::imageFile(const PbrtParams& params, std::string_view name, ColorEncoding encoding) {
    Texture texture;
    const std::string file = params.text(name);
    texture.name = file;
    texture.encoding = encoding;
    texture.image.source = FileSource{context_.fileOf(params.place(), file)};
    return {Vec3(0.5f), texture};
}

PbrtValue PbrtTextures::ofNumbers(const PbrtParams& at, const Texture& texture) {
    const Result<SceneImage> image = assets_.texture(texture.image.source);
    if (image && image->bytes && !image->bytes->alpha.empty()) {
        Texture alpha = texture;
        alpha.channel = TextureChannel::Alpha;
        return {Vec3(0.5f), alpha};
    }
    const auto pixels = pixelsOf(at, texture);
    if (!pixels) { return {}; }
    ImageF means = *pixels;
    bool areGrey = true, areZeroOrOne = true;
    for (size_t i = 0; i + 2 < means.rgb.size(); i += 3) {
        const float* rgb = &pixels->rgb[i];
        areGrey = areGrey && rgb[0] == rgb[1] && rgb[1] == rgb[2];
        areZeroOrOne = areZeroOrOne && (rgb[0] == 0.0f || rgb[0] == 1.0f);
        std::fill_n(&means.rgb[i], 3, (rgb[0] + rgb[1] + rgb[2]) / 3.0f);
    }
    // Glint reads numbers as they are stored, which 0 and 1 are in every encoding.
    const bool isPlain = texture.base == 0.0f && texture.gain == 1.0f && texture.exponent == 1.0f;
    const bool isStored =
        texture.encoding == ColorEncoding::Linear || image->floats || (areZeroOrOne && isPlain);
    return areGrey && isStored ? PbrtValue{Vec3(0.5f), texture} : baked(texture, means);
}

std::shared_ptr<const ImageF> PbrtTextures::pixelsOf(const PbrtParams& at, const Texture& texture) {
    const Result<SceneImage> image = assets_.texture(texture.image.source);
    if (!image) {
        context_.remark(at.place(), "images cannot be read; 0.5 takes their place", image.error().message);
        return nullptr;
    }
    auto pixels = std::make_shared<ImageF>();
    if (texture.channel == TextureChannel::Alpha) {
        *pixels = {image->bytes->width, image->bytes->height, {}};
        for (const uint8_t byte : image->bytes->alpha) {
            pixels->rgb.insert(pixels->rgb.end(), 3, static_cast<float>(byte) / 255.0f);
        }
    } else if (texture.encoding == ColorEncoding::Srgb || image->floats) {
        *pixels = *linearColors(*image);
    } else {
        *pixels = {image->bytes->width, image->bytes->height, {}};
        for (const uint8_t byte : image->bytes->rgb) {
            pixels->rgb.push_back(static_cast<float>(byte) / 255.0f);
        }
    }
    for (float& value : pixels->rgb) {
        value = texture.base + texture.gain * value;
        if (texture.exponent != 1.0f) { value = std::pow(std::max(value, 0.0f), texture.exponent); }
    }
    return pixels;
}

PbrtValue PbrtTextures::baked(const Texture& texture, const ImageF& pixels) {
    Texture own = texture;
    own.image = {.source = bakedImage(pixels, context_.scene.path, baked_++)};
    own.encoding = ColorEncoding::Linear;
    own.channel = TextureChannel::Red;
    own.base = 0.0f;
    own.gain = own.exponent = 1.0f;
    return {Vec3(0.5f), own};
}

PbrtValue PbrtTextures::changed(const PbrtParams& at, const PbrtValue& value,
                                const std::function<float(float)>& change) {
    const auto pixels = value.image ? pixelsOf(at, *value.image) : nullptr;
    if (!pixels) { return value; }
    ImageF out = *pixels;
    std::ranges::transform(out.rgb, out.rgb.begin(), change);
    return baked(*value.image, out);
}

Vec3 PbrtTextures::meanOf(const PbrtValue& value) {
    if (!value.image) { return value.value; }
    const auto pixels = pixelsOf(PbrtParams(&context_, {}, PbrtColorSpace::Srgb), *value.image);
    if (!pixels || pixels->rgb.empty()) { return Vec3(0.5f); }
    glm::dvec3 sum(0.0);
    for (size_t i = 0; i + 2 < pixels->rgb.size(); i += 3) {
        sum += glm::dvec3(pixels->rgb[i], pixels->rgb[i + 1], pixels->rgb[i + 2]);
    }
    return Vec3(sum / (static_cast<double>(pixels->rgb.size()) / 3.0));
}

PbrtValue PbrtTextures::scaled(const PbrtParams& at, const PbrtValue& a, const PbrtValue& b) {
    if (!a.image && !b.image) { return {a.value * b.value}; }
    const PbrtValue &image = a.image ? a : b, &factor = a.image ? b : a;
    const Vec3 f = factor.value;
    const bool isPlain = !factor.image && f.x == f.y && f.y == f.z && f.x >= 0.0f;
    return isPlain ? adjusted(image, 0.0f, f.x, 1.0f) : mixed(at, {Vec3(0.0f)}, image, factor);
}

PbrtValue PbrtTextures::mixed(const PbrtParams& at, const PbrtValue& a, const PbrtValue& b,
                              const PbrtValue& amount) {
    if (!a.image && !b.image && !amount.image) { return {glm::mix(a.value, b.value, amount.value)}; }
    const PbrtValue* parts[] = {&a, &b, &amount};
    const Texture* first = nullptr;
    std::shared_ptr<const ImageF> pixels[3];
    Vec3 constants[3];
    ImageF out;
    for (int i = 0; i < 3; ++i) {
        constants[i] = parts[i]->value;
        if (!parts[i]->image) { continue; }
        if (first != nullptr && !sitsAlike(*first, *parts[i]->image)) {
            at.approximated(
                "approximated: of textures that lie differently, one is its mean where they meet");
            constants[i] = meanOf(*parts[i]);
            continue;
        }
        pixels[i] = pixelsOf(at, *parts[i]->image);
        if (!pixels[i]) { continue; }
        first = first == nullptr ? &*parts[i]->image : first;
        out.width = std::max(out.width, pixels[i]->width);
        out.height = std::max(out.height, pixels[i]->height);
    }
    if (first == nullptr) { return {glm::mix(constants[0], constants[1], constants[2])}; }
    for (int y = 0; y < out.height; ++y) {
        for (int x = 0; x < out.width; ++x) {
            Vec3 v[3];
            for (int i = 0; i < 3; ++i) {
                v[i] = pixels[i] ? texelOf(*pixels[i], x * pixels[i]->width / out.width,
                                           y * pixels[i]->height / out.height)
                                 : constants[i];
            }
            const Vec3 mix = glm::mix(v[0], v[1], v[2]);
            out.rgb.insert(out.rgb.end(), {mix.x, mix.y, mix.z});
        }
    }
    return baked(*first, out);
}

}  // namespace glint
