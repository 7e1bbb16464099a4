// Powers of all emitter kinds and their cumulative distribution.
#include "engine/builders/power_distribution.h"

#include <cmath>

#include "engine/math/color.h"

namespace glint {
namespace {

/// Knud Thomsen's approximation of an ellipsoid's surface (2004, relative error below 1.1 %), good enough to
/// choose by. Exact powers are not needed: the probability is divided out.
float ellipsoidArea(const Mat3& linear) {
    constexpr float kPower = 1.6075f;
    const float a = std::pow(glm::length(linear[0]), kPower);
    const float b = std::pow(glm::length(linear[1]), kPower);
    const float c = std::pow(glm::length(linear[2]), kPower);
    return 4.0f * kPi * std::pow((a * b + a * c + b * c) / 3.0f, 1.0f / kPower);
}

float emitterPower(const SceneView& scene, const EmitterData& e) {
    const float radiance = luminance(e.radiance);
    const float exitance = kPi * radiance * (e.emitsBothSides ? 2.0f : 1.0f);
    const float sceneDisc = kPi * square(scene.sceneRadius);
    switch (e.tag) {
        case EmitterTag::Sphere:
            return exitance * 4.0f * kPi * square(e.radiusWorld);
        case EmitterTag::Ellipsoid:
            return exitance * ellipsoidArea(scene.geometry.instances[e.instance].objectToWorld.linear);
        case EmitterTag::Point:
            return radiance * 4.0f * kPi;
        case EmitterTag::Spot:
            return radiance * kTwoPi * (0.5f * (e.oneMinusCosInner + e.oneMinusCosOuter));
        case EmitterTag::Directional:
            return radiance * sceneDisc;
        case EmitterTag::Environment:
            // environmentIrradiance is pi times the mean luminance; the whole sphere of directions brings
            // four times that.
            return 4.0f * scene.lights.environmentIrradiance * sceneDisc;
        default:
            return exitance * e.area;
    }
}

}  // namespace

PowerDistributionView PowerDistribution::view() const {
    PowerDistributionView out;
    out.cdf = cdf.data();
    out.emitterCount = cdf.empty() ? 0 : static_cast<uint32_t>(cdf.size() - 1);
    out.totalPower = totalPower;
    return out;
}

PowerDistribution buildPowerDistribution(const SceneView& scene) {
    PowerDistribution table;
    std::vector<double> sums{0.0};
    for (uint32_t i = 0; i < scene.lights.emitters.count; ++i) {
        const float power = emitterPower(scene, scene.lights.emitters[i]);
        sums.push_back(sums.back() +
                       static_cast<double>(std::isfinite(power) && power > 0.0f ? power : 0.0f));
    }
    const double total = sums.back();
    if (!(total > 0.0) || !std::isfinite(total)) { return table; }
    table.totalPower = static_cast<float>(total);
    table.cdf.reserve(sums.size());
    for (const double sum : sums) {
        table.cdf.push_back(static_cast<float>(sum / total));
    }
    return table;
}

}  // namespace glint
