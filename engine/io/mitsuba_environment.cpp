#include "engine/io/mitsuba_environment.h"

#include <algorithm>
#include <cmath>

namespace glint {
namespace {

Vec3 texel(const ImageF& map, int x, int y) {
    const int column = (x % map.width + map.width) % map.width, row = std::clamp(y, 0, map.height - 1);
    const float* rgb = &map.rgb[3 * (static_cast<size_t>(row) * static_cast<size_t>(map.width) +
                                     static_cast<size_t>(column))];
    return {rgb[0], rgb[1], rgb[2]};
}

/// x and y count texels from the middle of the first one.
Vec3 lookUp(const ImageF& map, float x, float y) {
    const float left = std::floor(x), top = std::floor(y);
    const int column = static_cast<int>(left), row = static_cast<int>(top);
    const auto along = [&](int at) {
        return glm::mix(texel(map, column, at), texel(map, column + 1, at), x - left);
    };
    return glm::mix(along(row), along(row + 1), y - top);
}

template <class ColorAt>
ImageF filled(int width, int height, const ColorAt& colorAt) {
    ImageF out{width, height, {}};
    out.rgb.reserve(size_t{3} * static_cast<size_t>(width) * static_cast<size_t>(height));
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const Vec3 color = colorAt(x, y);
            out.rgb.insert(out.rgb.end(), {color.x, color.y, color.z});
        }
    }
    return out;
}

}  // namespace

std::optional<float> turnAboutY(const Affine& map) {
    const Mat3& m = map.linear;
    const float scale = glm::length(m[1]);
    const float cosine = m[0].x / scale, sine = m[2].x / scale;
    const Mat3 turn(cosine, 0, -sine, 0, 1, 0, sine, 0, cosine);
    for (int c = 0; c < 3; ++c) {
        if (!(glm::length(m[c] / scale - turn[c]) < 1e-5f)) { return std::nullopt; }
    }
    return std::atan2(sine, cosine) * (180.0f / kPi);
}

ImageF withCentredRows(const ImageF& map) {
    const int height = 2 * map.height;
    return filled(map.width, height, [&](int x, int y) {
        const float v = (static_cast<float>(y) + 0.5f) / static_cast<float>(height);
        return lookUp(map, static_cast<float>(x), v * static_cast<float>(map.height - 1));
    });
}

ImageF withRowsAtPoles(const ImageF& map) {
    const int height = 2 * map.height + 1;
    return filled(map.width, height, [&](int x, int y) {
        const float v = static_cast<float>(y) / static_cast<float>(height - 1);
        return lookUp(map, static_cast<float>(x), v * static_cast<float>(map.height) - 0.5f);
    });
}

ImageF turnedMap(const ImageF& map, const Affine& toWorld, bool hasRowsAtPoles) {
    const Affine toMap = isInvertible(toWorld) ? inverse(toWorld) : Affine();
    const int width = 2 * map.width, height = 2 * map.height;
    return filled(width, height, [&](int x, int y) {
        const float phi = ((static_cast<float>(x) + 0.5f) / static_cast<float>(width) - 0.5f) * kTwoPi;
        const float theta = (static_cast<float>(y) + 0.5f) / static_cast<float>(height) * kPi;
        const Vec3 world(std::sin(theta) * std::sin(phi), std::cos(theta), -std::sin(theta) * std::cos(phi));
        const Vec3 local = glm::normalize(toMap.vector(world));
        const float u = std::atan2(local.x, -local.z) / kTwoPi;
        const float v = std::acos(clampf(local.y, -1.0f, 1.0f)) / kPi;
        const auto rows = static_cast<float>(map.height);
        return lookUp(map, u * static_cast<float>(map.width) - 0.5f,
                      hasRowsAtPoles ? v * (rows - 1.0f) : v * rows - 0.5f);
    });
}

}  // namespace glint
