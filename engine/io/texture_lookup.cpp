#include "engine/io/texture_lookup.h"

#include <algorithm>
#include <cmath>

#include "engine/io/image_io.h"

namespace glint {
namespace {

std::shared_ptr<const ImageF> storedColors(const Texture& texture) {
    const SceneImage& image = texture.image;
    if (!image.isRead()) { return nullptr; }
    if (image.floats || texture.encoding == ColorEncoding::Srgb) { return linearColors(image); }
    auto pixels = std::make_shared<ImageF>(ImageF{image.bytes->width, image.bytes->height, {}});
    for (const uint8_t byte : image.bytes->rgb) {
        pixels->rgb.push_back(static_cast<float>(byte) / 255.0f);
    }
    return pixels;
}

/// A coordinate of the image, which begins at 0 and ends at 1, as a texel's number and the share of the next.
struct Position {
    int first, second;
    float share;
};

Position positionOf(float coordinate, int size, WrapMode wrap, TexelFilter filter) {
    float place = coordinate;
    if (wrap == WrapMode::Repeat) { place -= std::floor(place); }
    if (wrap == WrapMode::Mirror) {
        place -= 2.0f * std::floor(0.5f * place);
        place = place > 1.0f ? 2.0f - place : place;
    }
    const float texels = std::clamp(place, 0.0f, 1.0f) * static_cast<float>(size) - 0.5f;
    const float below = std::floor(texels);
    const int index = static_cast<int>(below);
    const auto within = [&](int i) {
        return wrap == WrapMode::Repeat ? (i + size) % size : std::clamp(i, 0, size - 1);
    };
    const float share = texels - below;
    return {within(index), within(index + 1),
            filter != TexelFilter::Nearest ? share : (share < 0.5f ? 0.0f : 1.0f)};
}

}  // namespace

TextureLookup::TextureLookup(const Texture& texture)
    : texture_(texture),
      pixels_(storedColors(texture)),
      turn_(std::cos(texture.rotationDeg * kPi / 180.0f), std::sin(texture.rotationDeg * kPi / 180.0f)) {}

Vec3 TextureLookup::texel(int x, int y) const {
    const float* rgb = &pixels_->rgb[3 * (static_cast<size_t>(y) * static_cast<size_t>(pixels_->width) +
                                          static_cast<size_t>(x))];
    return {rgb[0], rgb[1], rgb[2]};
}

Vec3 TextureLookup::at(const Vec2& uv) const {
    const Vec2 scaled = uv * texture_.scale;
    const Vec2 place =
        Vec2(turn_.x * scaled.x - turn_.y * scaled.y, turn_.y * scaled.x + turn_.x * scaled.y) +
        texture_.offset;
    const Position x = positionOf(place.x, pixels_->width, texture_.wrapU, texture_.filter);
    const Position y = positionOf(texture_.flipV ? place.y : 1.0f - place.y, pixels_->height, texture_.wrapV,
                                  texture_.filter);
    const Vec3 top = glm::mix(texel(x.first, y.first), texel(x.second, y.first), x.share);
    const Vec3 bottom = glm::mix(texel(x.first, y.second), texel(x.second, y.second), x.share);
    const Vec3 shown = texture_.base + texture_.gain * glm::mix(top, bottom, y.share);
    return texture_.exponent == 1.0f ? shown : glm::pow(glm::max(shown, Vec3(0.0f)), Vec3(texture_.exponent));
}

}  // namespace glint
