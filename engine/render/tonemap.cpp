// The curves are in the header, where the shader's author looks; here are the loops and the names.
#include "engine/render/tonemap.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/base/parallel.h"

namespace glint {
namespace {

constexpr std::array<std::string_view, kToneMapCount> kNames{"clamp", "srgb", "filmic", "reinhard", "soft"};

/// NaN compares false with everything and so becomes 0.
float toneInput(float x) { return x > 0.0f ? std::fmin(x, kMaxToneInput) : 0.0f; }

float encoded(float x) { return linearToSrgb(clampf(x, 0.0f, 1.0f)); }

}  // namespace

std::string_view toneMapName(ToneMap map) { return kNames[static_cast<size_t>(map)]; }

std::optional<ToneMap> toneMapFromName(std::string_view name) {
    const auto found = std::find(kNames.begin(), kNames.end(), name);
    return found == kNames.end() ? std::nullopt : std::optional(static_cast<ToneMap>(found - kNames.begin()));
}

Vec3 exposed(const Vec3& radiance, float exposureStops) {
    const float gain = std::exp2(exposureStops);
    return {toneInput(radiance.x * gain), toneInput(radiance.y * gain), toneInput(radiance.z * gain)};
}

Vec3 toneMapped(Vec3 radiance, float exposureStops, ToneMap map) {
    const Vec3 x = exposed(radiance, exposureStops);
    switch (map) {
        case ToneMap::Clamp:
            return {std::fmin(x.x, 1.0f), std::fmin(x.y, 1.0f), std::fmin(x.z, 1.0f)};
        case ToneMap::Srgb:
            return {encoded(x.x), encoded(x.y), encoded(x.z)};
        case ToneMap::Filmic:
            return {encoded(filmicCurve(x.x)), encoded(filmicCurve(x.y)), encoded(filmicCurve(x.z))};
        case ToneMap::Reinhard: {
            const Vec3 y = reinhard(x);
            return {encoded(y.x), encoded(y.y), encoded(y.z)};
        }
        case ToneMap::Soft: {
            const Vec3 y = softHighlights(x);
            return {encoded(y.x), encoded(y.y), encoded(y.z)};
        }
    }
    return x;
}

Image8 toneMapImage(const float* radianceRgb, int width, int height, const DisplayLook& look, int threads) {
    Image8 out{.width = width, .height = height, .rgb = {}};
    out.rgb.resize(size_t{3} * static_cast<size_t>(width) * static_cast<size_t>(height));
    const ToneMapper toned(look);
    parallelChunks(height, 16, threads, [&](int64_t beginRow, int64_t endRow) {
        for (int y = static_cast<int>(beginRow); y < static_cast<int>(endRow); ++y) {
            for (int x = 0; x < width; ++x) {
                const size_t i =
                    3 * (static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x));
                const Vec3 display = toned({radianceRgb[i], radianceRgb[i + 1], radianceRgb[i + 2]});
                for (int c = 0; c < 3; ++c) {
                    const float offset = look.dithers ? ditherOffset(x, y, c) : 0.0f;
                    out.rgb[i + static_cast<size_t>(c)] = displayByte(display[c], offset);
                }
            }
        }
    });
    return out;
}

Vec3 normalColor(const Vec3& unitOrZero) {
    return isZero(unitOrZero) ? Vec3(0.0f) : 0.5f * unitOrZero + Vec3(0.5f);
}

Vec3 idColor(uint32_t id) {
    if (id == 0) { return Vec3(0.0f); }
    // Hues a golden ratio apart stay far from each other for any run of ids.
    const double turns = static_cast<double>(id) * 0.61803398874989485;
    const float hue = 6.0f * static_cast<float>(turns - std::floor(turns));
    const auto channel = [hue](float offset) {
        const float distance = std::fabs(std::fmod(hue + offset, 6.0f) - 3.0f);
        return 0.25f + 0.7f * clampf(distance - 1.0f, 0.0f, 1.0f);
    };
    return {channel(0.0f), channel(4.0f), channel(2.0f)};
}

Vec3 depthColor(float depth, float nearest, float farthest) {
    if (!(depth > 0.0f)) { return Vec3(0.0f); }
    const float range = farthest - nearest;
    const float relative = range > 0.0f ? clampf((depth - nearest) / range, 0.0f, 1.0f) : 0.0f;
    return Vec3(1.0f - 0.9f * relative);
}

DepthRange depthRange(const std::vector<float>& depths) {
    DepthRange range{kInfinity, 0.0f};
    for (const float depth : depths) {
        if (depth > 0.0f && std::isfinite(depth)) {
            range.nearest = std::fmin(range.nearest, depth);
            range.farthest = std::fmax(range.farthest, depth);
        }
    }
    return range.farthest > 0.0f ? range : DepthRange{};
}

}  // namespace glint
