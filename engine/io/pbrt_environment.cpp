#include "engine/io/pbrt_environment.h"

#include <algorithm>
#include <cmath>

#include "engine/math/color.h"
#include "engine/math/equal_area.h"

namespace glint {
namespace {

Vec3 texel(const ImageF& map, int x, int y) {
    const float* rgb =
        &map.rgb[3 * (static_cast<size_t>(y) * static_cast<size_t>(map.width) + static_cast<size_t>(x))];
    return {rgb[0], rgb[1], rgb[2]};
}

/// Beyond an edge, the square goes on at the other half of the same edge.
Vec3 squareTexel(const ImageF& map, int x, int y) {
    const int n = map.width, m = map.height;
    if (x < 0 || x >= n) {
        x = x < 0 ? -1 - x : 2 * n - 1 - x;
        y = m - 1 - y;
    }
    if (y < 0 || y >= m) {
        y = y < 0 ? -1 - y : 2 * m - 1 - y;
        x = n - 1 - x;
    }
    return texel(map, std::clamp(x, 0, n - 1), std::clamp(y, 0, m - 1));
}

Vec3 latLongTexel(const ImageF& map, int x, int y) {
    return texel(map, (x % map.width + map.width) % map.width, std::clamp(y, 0, map.height - 1));
}

/// `at` in [0, 1]^2.
template <class TexelAt>
Vec3 bilinear(const ImageF& map, const Vec2& at, const TexelAt& texelAt) {
    const float x = at.x * static_cast<float>(map.width) - 0.5f,
                y = at.y * static_cast<float>(map.height) - 0.5f;
    const float left = std::floor(x), top = std::floor(y);
    const int column = static_cast<int>(left), row = static_cast<int>(top);
    const auto along = [&](int r) {
        return glm::mix(texelAt(map, column, r), texelAt(map, column + 1, r), x - left);
    };
    return glm::mix(along(row), along(row + 1), y - top);
}

/// Each texel of Glint's map is the mean over samples x samples of its directions.
template <class RadianceOf>
ImageF laidOut(int width, int samples, const Affine& toWorld, const RadianceOf& radianceOf) {
    const Affine toMap = inverse(toWorld);
    ImageF out{width, width / 2, {}};
    out.rgb.resize(size_t{3} * static_cast<size_t>(width) * static_cast<size_t>(out.height));
    const float perColumn = 1.0f / static_cast<float>(width * samples);
    const float perRow = 1.0f / static_cast<float>(out.height * samples);
#pragma omp parallel for
    for (int y = 0; y < out.height; ++y) {
        for (int x = 0; x < width; ++x) {
            Vec3 sum(0.0f);
            float weights = 0.0f;
            for (int s = 0; s < samples * samples; ++s) {
                const int row = y * samples + s / samples;
                const float theta = kPi * perRow * (static_cast<float>(row) + 0.5f);
                const float phi =
                    kTwoPi * (perColumn * (static_cast<float>(x * samples + s % samples) + 0.5f) - 0.5f);
                const float ring = std::sin(theta);
                const Vec3 world(ring * std::sin(phi), std::cos(theta), -ring * std::cos(phi));
                sum += ring * radianceOf(glm::normalize(toMap.vector(world)));
                weights += ring;
            }
            const Vec3 mean = sum / weights;
            std::copy_n(
                &mean.x, 3,
                &out.rgb[3 * (static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x))]);
        }
    }
    return out;
}

/// A square map, each texel the mean over samples x samples of its directions.
template <class RadianceOf>
ImageF squareOf(int size, int samples, const RadianceOf& radianceOf) {
    ImageF out{size, size, {}};
    out.rgb.resize(size_t{3} * static_cast<size_t>(size) * static_cast<size_t>(size));
    const float perSample = 1.0f / static_cast<float>(size * samples);
#pragma omp parallel for
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            Vec3 sum(0.0f);
            for (int k = 0; k < samples * samples; ++k) {
                const int column = x * samples + k % samples, row = y * samples + k / samples;
                const Vec2 at(static_cast<float>(column) + 0.5f, static_cast<float>(row) + 0.5f);
                sum += radianceOf(equalAreaDirection(perSample * at));
            }
            const Vec3 mean = sum / static_cast<float>(samples * samples);
            std::copy_n(&mean.x, 3, &out.rgb[3 * static_cast<size_t>(y * size + x)]);
        }
    }
    return out;
}

/// Where pbrt-v3's maps have a unit direction.
Vec2 pbrtLatLong(const Vec3& d) {
    const float u = std::atan2(d.y, d.x) / kTwoPi;
    return {u < 0.0f ? u + 1.0f : u, std::acos(clampf(d.z, -1.0f, 1.0f)) / kPi};
}

constexpr int kMostColumns = 4096;
constexpr int kFewestColumns = 16, kMostSquareColumns = 2048;

}  // namespace

ImageF latLongOfEqualArea(const ImageF& map, const Affine& toWorld) {
    const int width = std::clamp(2 * map.width, 16, kMostColumns);
    const int samples = 2 * std::max(1, (2 * map.width + width - 1) / width);
    return laidOut(width, samples, toWorld,
                   [&](const Vec3& d) { return bilinear(map, equalAreaPoint(d), squareTexel); });
}

ImageF latLongOfPbrt(const ImageF& map, const Affine& toWorld) {
    const int width = std::clamp(map.width, 16, kMostColumns);
    const int samples = 2 * std::max(1, (map.width + width - 1) / width);
    return laidOut(width, samples, toWorld,
                   [&](const Vec3& d) { return bilinear(map, pbrtLatLong(d), latLongTexel); });
}

ImageF equalAreaOfLatLong(const ImageF& map, float rotationDeg) {
    const int size = std::clamp(map.width / 2, kFewestColumns, kMostSquareColumns);
    const int samples = 2 * std::max(1, (map.width + 2 * size - 1) / (2 * size));
    const float c = std::cos(rotationDeg * kPi / 180.0f), s = std::sin(rotationDeg * kPi / 180.0f);
    return squareOf(size, samples, [&](const Vec3& w) {
        const Vec3 d(c * w.x - s * w.z, w.y, s * w.x + c * w.z);
        const Vec2 uv(0.5f + std::atan2(d.x, -d.z) / kTwoPi, std::acos(clampf(d.y, -1.0f, 1.0f)) / kPi);
        return bilinear(map, uv, latLongTexel);
    });
}

ImageF equalAreaOfPbrt(const ImageF& map) {
    return squareOf(std::clamp(map.width, kFewestColumns, kMostSquareColumns), 2,
                    [&](const Vec3& d) { return bilinear(map, pbrtLatLong(d), latLongTexel); });
}

double illuminanceOfEqualArea(const ImageF& map) {
    double sum = 0.0;
    for (int y = 0; y < map.height; ++y) {
        for (int x = 0; x < map.width; ++x) {
            const Vec2 at((static_cast<float>(x) + 0.5f) / static_cast<float>(map.width),
                          (static_cast<float>(y) + 0.5f) / static_cast<float>(map.height));
            const float cosine = equalAreaDirection(at).z;
            if (cosine > 0.0f) { sum += static_cast<double>(cosine * luminance(texel(map, x, y))); }
        }
    }
    // As pbrt has it: its texels count half of their solid angles.
    return sum * 2.0 * static_cast<double>(kPi) /
           (static_cast<double>(map.width) * static_cast<double>(map.height));
}

}  // namespace glint
