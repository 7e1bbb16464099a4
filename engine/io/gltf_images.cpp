#include "engine/io/gltf_images.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include <fmt/format.h>

#include "engine/io/atomic_file.h"
#include "engine/io/embedded_files.h"
#include "engine/io/file_path.h"
#include "engine/io/image_io.h"
#include "engine/io/scene_export.h"
#include "engine/math/color.h"

namespace glint {
namespace {

bool isPng(std::string_view bytes) { return bytes.starts_with("\x89PNG"); }
bool isJpeg(std::string_view bytes) { return bytes.starts_with("\xff\xd8\xff"); }

bool isChanged(const Texture& texture) {
    return texture.base != 0.0f || texture.gain != 1.0f || texture.exponent != 1.0f;
}
/// As glTF's own files are read: the square of a multiple.
bool isSquared(const Texture& texture) { return texture.base == 0.0f && texture.exponent == 2.0f; }

bool isMultiplied(const Texture& texture) { return texture.base == 0.0f && texture.exponent == 1.0f; }

float adjusted(const Texture& texture, float value) {
    value = texture.base + texture.gain * value;
    return texture.exponent == 1.0f ? value : std::pow(std::max(value, 0.0f), texture.exponent);
}

uint8_t byteOf(float value) { return static_cast<uint8_t>(std::lround(255.0f * clampf(value, 0.0f, 1.0f))); }

int widthOf(const SceneImage& image) { return image.bytes ? image.bytes->width : image.floats->width; }
int heightOf(const SceneImage& image) { return image.bytes ? image.bytes->height : image.floats->height; }

/// As stored: bytes are not decoded.
Vec3 numbersAt(const SceneImage& image, size_t pixel) {
    Vec3 numbers;
    for (size_t c = 0; c < 3; ++c) {
        numbers[static_cast<int>(c)] = image.bytes
                                           ? static_cast<float>(image.bytes->rgb[3 * pixel + c]) / 255.0f
                                           : image.floats->rgb[3 * pixel + c];
    }
    return numbers;
}

float alphaAt(const SceneImage& image, size_t pixel) {
    const bool hasAlpha = image.bytes && !image.bytes->alpha.empty();
    return hasAlpha ? static_cast<float>(image.bytes->alpha[pixel]) / 255.0f : 1.0f;
}

float numberAt(const Texture& texture, size_t pixel) {
    const Vec3 numbers = numbersAt(texture.image, pixel);
    switch (texture.channel) {
        case TextureChannel::Green:
            return numbers.y;
        case TextureChannel::Blue:
            return numbers.z;
        case TextureChannel::Alpha:
            return alphaAt(texture.image, pixel);
        case TextureChannel::Luminance:
            return luminance(numbers);
        default:
            return numbers.x;
    }
}

Vec3 encodedColor(const Texture& texture, size_t pixel) {
    const bool isSrgb = texture.image.bytes && texture.encoding == ColorEncoding::Srgb;
    Vec3 color = numbersAt(texture.image, pixel);
    for (int c = 0; c < 3 && (isChanged(texture) || !isSrgb); ++c) {
        const float linear = isSrgb ? srgbToLinear(color[c]) : color[c];
        color[c] = linearToSrgb(clampf(adjusted(texture, linear), 0.0f, 1.0f));
    }
    return color;
}

/// Before shareFactor() and roughnessFactor().
float shareAt(const Texture& texture, size_t pixel) {
    const float number = numberAt(texture, pixel);
    return isMultiplied(texture) ? number : adjusted(texture, number);
}
float roughnessAt(const Texture& texture, size_t pixel) {
    const float number = numberAt(texture, pixel);
    return isSquared(texture) ? number : safeSqrt(adjusted(texture, number));
}

Vec3 colorFor(GltfImageUse use, const Texture& texture, size_t pixel) {
    switch (use) {
        case GltfImageUse::Roughness:
            return {1.0f, roughnessAt(texture, pixel), 1.0f};
        case GltfImageUse::Share:
            return Vec3(shareAt(texture, pixel));
        case GltfImageUse::Normal: {
            Vec3 numbers = numbersAt(texture.image, pixel);
            for (int c = 0; c < 3; ++c) {
                numbers[c] = adjusted(texture, numbers[c]);
            }
            return numbers;
        }
        default:
            return encodedColor(texture, pixel);
    }
}

float alphaFor(GltfImageUse use, const Texture& texture, size_t pixel) {
    if (use == GltfImageUse::ShareInAlpha) { return shareAt(texture, pixel); }
    if (use == GltfImageUse::RoughnessInAlpha) { return roughnessAt(texture, pixel); }
    return adjusted(texture, numberAt(texture, pixel));
}

/// The texture's own placement behind a v that is counted as the file does.
GltfJson placementOf(const Texture& texture, bool isFlipped) {
    const float angle = texture.rotationDeg * (kPi / 180.0f);
    Vec2 scale = texture.scale, offset = texture.offset;
    double turnDeg = -static_cast<double>(texture.rotationDeg);
    if (isFlipped) {
        offset += scale.y * Vec2(-std::sin(angle), std::cos(angle));
        scale.y = -scale.y;
    }
    if (!texture.flipV) {  // what counts v from the bottom
        offset.y = 1.0f - offset.y;
        scale.y = -scale.y;
        turnDeg = -turnDeg;
    }
    GltfJson placement = GltfJson::object();
    if (offset != Vec2(0.0f)) { placement["offset"] = gltfJson(offset); }
    if (turnDeg != 0.0) { placement["rotation"] = turnDeg * (std::numbers::pi / 180.0); }
    if (scale != Vec2(1.0f)) { placement["scale"] = gltfJson(scale); }
    return placement;
}

}  // namespace

float shownNumber(const Texture& texture, size_t pixel) {
    return adjusted(texture, numberAt(texture, pixel));
}

float GltfImages::roughnessFactor(int index) const {
    return isSquared(texture(index)) ? clampf(texture(index).gain, 0.0f, 1.0f) : 1.0f;
}

float GltfImages::shareFactor(int index) const {
    return isMultiplied(texture(index)) ? clampf(texture(index).gain, 0.0f, 1.0f) : 1.0f;
}

Image8 GltfImages::bake(const Image& image) {
    const Texture& size = texture(image.color >= 0 ? image.color : image.alpha);
    Image8 baked{widthOf(size.image), heightOf(size.image), {}, {}};
    const size_t pixels = static_cast<size_t>(baked.width) * static_cast<size_t>(baked.height);
    const Texture* color = image.color >= 0 ? &texture(image.color) : nullptr;
    const Texture* alpha = image.alpha >= 0 ? &texture(image.alpha) : nullptr;
    const bool isSurface = image.use == GltfImageUse::Roughness;
    const bool hasAlpha = image.use == GltfImageUse::Color && color != nullptr && color->image.bytes &&
                          !color->image.bytes->alpha.empty();
    for (size_t i = 0; i < pixels; ++i) {
        Vec3 rgb = color != nullptr ? colorFor(image.use, *color, i) : Vec3(1.0f);
        if (alpha != nullptr && isSurface) { rgb.z = shareAt(*alpha, i); }
        for (int c = 0; c < 3; ++c) {
            baked.rgb.push_back(byteOf(rgb[c]));
        }
        if (alpha != nullptr && !isSurface) {
            baked.alpha.push_back(byteOf(alphaFor(image.use, *alpha, i)));
        } else if (hasAlpha) {
            baked.alpha.push_back(color->image.bytes->alpha[i]);
        }
    }
    return baked;
}

std::shared_ptr<const std::string> GltfImages::fileOf(const Image& image) {
    const bool isPlain = image.use == GltfImageUse::Color || image.use == GltfImageUse::Normal;
    if (image.alpha >= 0 || !isPlain) { return nullptr; }
    const Texture& from = texture(image.color);
    const bool isReadAlike = image.use == GltfImageUse::Normal || from.encoding == ColorEncoding::Srgb;
    if (isChanged(from) || !from.image.bytes || !isReadAlike) { return nullptr; }
    std::shared_ptr<const std::string> bytes;
    if (const auto* embedded = std::get_if<EmbeddedFile>(&from.image.source)) { bytes = embedded->bytes; }
    if (const std::string name = pathOf(from.image.source); !name.empty()) {
        Result<std::string> read = readFile(resolvePath(name, scene_.path));
        if (read) { bytes = std::make_shared<const std::string>(std::move(*read)); }
    }
    return bytes && (isPng(*bytes) || isJpeg(*bytes)) ? bytes : nullptr;
}

size_t GltfImages::addImage(const std::string& name, const std::shared_ptr<const std::string>& bytes) {
    const std::string key = fmt::format("{} {}", std::hash<std::string>()(*bytes), bytes->size());
    if (const auto known = files_.find(key); known != files_.end()) { return known->second; }
    const std::string stem = std::filesystem::path(name).stem().string();
    GltfJson image{{"name", stem}, {"mimeType", isPng(*bytes) ? "image/png" : "image/jpeg"}};
    if (hasExtension(path_, ".glb")) {
        image["bufferView"] = out_.addView(*bytes);
    } else {
        const bool isBelow = name.find('/') != std::string::npos;  // stays where it is
        const Result<std::string> written =
            isBelow ? Result<std::string>(name) : writeBeside({name, bytes}, path_);
        if (!written && status_) { status_ = written.error(); }
        image["uri"] = gltfUri(written ? *written : name);
    }
    return files_[key] = out_.add("images", std::move(image));
}

size_t GltfImages::imageOf(const Image& image) {
    if (const auto known = images_.find(image); known != images_.end()) { return known->second; }
    const Texture& from = texture(image.color >= 0 ? image.color : image.alpha);
    std::shared_ptr<const std::string> bytes = fileOf(image);
    std::string name = std::filesystem::path(path_).stem().string();
    if (bytes) {
        const auto* embedded = std::get_if<EmbeddedFile>(&from.image.source);
        name =
            embedded != nullptr ? embedded->name : rebasePath(pathOf(from.image.source), scene_.path, path_);
        const std::filesystem::path path(name);
        if (path.is_absolute() || *path.begin() == "..") { name = path.filename().string(); }
    } else {
        name += fmt::format("-picture{}.png", baked_++);
        if (!from.image.bytes) { warnOnce("approximated: pictures have eight bits", &warnings_); }
        const Result<std::string> png = encodePng(bake(image), path_);
        if (!png && status_) { status_ = png.error(); }
        bytes = std::make_shared<const std::string>(png ? *png : std::string());
    }
    return images_[image] = addImage(name, bytes);
}

GltfJson GltfImages::samplerOf(const Texture& texture) {
    constexpr int kNearest = 9728, kLinear = 9729, kLinearOfMipmaps = 9987;
    const auto wrapOf = [](WrapMode wrap) {
        return wrap == WrapMode::Clamp ? 33071 : wrap == WrapMode::Mirror ? 33648 : 10497;
    };
    const bool isNearest = texture.filter == TexelFilter::Nearest;
    GltfJson sampler{{"magFilter", isNearest ? kNearest : kLinear},
                     {"minFilter", isNearest ? kNearest : kLinearOfMipmaps},
                     {"wrapS", wrapOf(texture.wrapU)},
                     {"wrapT", wrapOf(texture.wrapV)}};
    const auto [known, isNew] = samplers_.try_emplace(sampler.dump(), 0);
    if (isNew) { known->second = out_.add("samplers", std::move(sampler)); }
    return known->second;
}

/// Whether they can be one picture.
bool GltfImages::fits(int color, int alpha) {
    const Texture &a = texture(color), &b = texture(alpha);
    return widthOf(a.image) == widthOf(b.image) && heightOf(a.image) == heightOf(b.image) &&
           a.scale == b.scale && a.rotationDeg == b.rotationDeg && a.offset == b.offset &&
           a.flipV == b.flipV && a.wrapU == b.wrapU && a.wrapV == b.wrapV;
}

GltfJson GltfImages::info(int color, int alpha, GltfImageUse use, bool isFlipped) {
    for (const int index : {color, alpha}) {
        if (index < 0 || texture(index).image.isRead()) { continue; }
        if (status_) {
            status_ = Error{fmt::format("the image \"{}\" has not been read", texture(index).name),
                            {.file = path_}};
        }
        return {};
    }
    if (color >= 0 && alpha >= 0 && !fits(color, alpha)) {
        warnOnce(
            "approximated: images of opacity or metalness that lie otherwise than those of colours or "
            "roughness are left out",
            &warnings_);
        alpha = -1;
    }
    const Texture& from = texture(color >= 0 ? color : alpha);
    GltfJson made{{"sampler", samplerOf(from)}, {"source", imageOf({color, alpha, use})}};
    const auto [known, isNew] = textures_.try_emplace(made.dump(), 0);
    if (isNew) { known->second = out_.add("textures", std::move(made)); }
    GltfJson info = GltfJson::object({{"index", known->second}});
    if (GltfJson placement = placementOf(from, isFlipped); !placement.empty()) {
        out_.extend(&info, "KHR_texture_transform", std::move(placement));
    }
    return info;
}

}  // namespace glint
