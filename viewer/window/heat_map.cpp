#include "viewer/window/heat_map.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace glint {

HeatScale heatScale(const std::vector<float>& values) {
    HeatScale scale;
    for (const float value : values) {
        if (!(value > 0.0f) || !std::isfinite(value)) continue;
        scale.smallest = scale.smallest > 0.0f ? std::min(scale.smallest, value) : value;
        scale.largest = std::max(scale.largest, value);
    }
    return scale;
}

Vec3 heatColor(float share) {
    static const std::array<Vec3, 6> kStops{Vec3(0.10f, 0.08f, 0.30f), Vec3(0.10f, 0.32f, 0.55f),
                                            Vec3(0.12f, 0.55f, 0.52f), Vec3(0.45f, 0.75f, 0.30f),
                                            Vec3(0.97f, 0.86f, 0.25f), Vec3(1.00f, 0.98f, 0.90f)};
    const float place = std::clamp(share, 0.0f, 1.0f) * static_cast<float>(kStops.size() - 1);
    const size_t below = std::min(static_cast<size_t>(place), kStops.size() - 2);
    const float part = place - static_cast<float>(below);
    return kStops[below] * (1.0f - part) + kStops[below + 1] * part;
}

Vec3 heatColor(float value, const HeatScale& scale) {
    if (!(value > 0.0f) || !std::isfinite(value)) return Vec3(0.0f);
    const float span = std::log(scale.largest / scale.smallest);
    return heatColor(span > 1e-6f ? std::log(value / scale.smallest) / span : 0.5f);
}

}  // namespace glint
