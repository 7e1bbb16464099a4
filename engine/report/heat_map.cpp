#include "engine/report/heat_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace glint {
namespace {

/// Linear between evenly spaced stops.
Vec3 alongStops(std::span<const Vec3> stops, float share) {
    const float place = std::clamp(share, 0.0f, 1.0f) * static_cast<float>(stops.size() - 1);
    const size_t below = std::min(static_cast<size_t>(place), stops.size() - 2);
    const float part = place - static_cast<float>(below);
    return stops[below] * (1.0f - part) + stops[below + 1] * part;
}

}  // namespace

HeatScale heatScale(const std::vector<float>& values) {
    HeatScale scale;
    for (const float value : values) {
        if (!(value > 0.0f) || !std::isfinite(value)) { continue; }
        scale.smallest = scale.smallest > 0.0f ? std::min(scale.smallest, value) : value;
        scale.largest = std::max(scale.largest, value);
    }
    return scale;
}

Vec3 heatColor(float share) {
    static const std::array<Vec3, 6> kStops{Vec3(0.10f, 0.08f, 0.30f), Vec3(0.10f, 0.32f, 0.55f),
                                            Vec3(0.12f, 0.55f, 0.52f), Vec3(0.45f, 0.75f, 0.30f),
                                            Vec3(0.97f, 0.86f, 0.25f), Vec3(1.00f, 0.98f, 0.90f)};
    return alongStops(kStops, share);
}

Vec3 heatColor(float value, const HeatScale& scale) {
    if (!(value > 0.0f) || !std::isfinite(value)) { return Vec3(0.0f); }
    const float span = std::log(scale.largest / scale.smallest);
    return heatColor(span > 1e-6f ? std::log(value / scale.smallest) / span : 0.5f);
}

Vec3 signedColor(float share) {
    static const std::array<Vec3, 3> kBelow{Vec3(0.0f), Vec3(0.10f, 0.42f, 0.80f), Vec3(0.75f, 0.92f, 1.00f)};
    static const std::array<Vec3, 3> kAbove{Vec3(0.0f), Vec3(0.85f, 0.40f, 0.05f), Vec3(1.00f, 0.93f, 0.70f)};
    return alongStops(share < 0.0f ? kBelow : kAbove, std::abs(share));
}

}  // namespace glint
