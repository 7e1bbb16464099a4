// Powers of all emitter kinds and their cumulative distribution.
#include "engine/builders/power_distribution.h"

#include <cmath>

#include "engine/math/color.h"

namespace glint {
namespace {

float emitterPower(const SceneView& scene, const EmitterData& e) {
    const float radiance = luminance(e.radiance);
    const float exitance = kPi * radiance * (e.emitsBothSides ? 2.0f : 1.0f);
    const float sceneDisc = kPi * square(scene.sceneRadius);
    switch (e.kind) {
        case EmitterKind::Shape:
            return visitShape<float, kAllFeatures>(
                e.shape, [&](auto shape) { return decltype(shape)::power(scene.geometry, e, exitance); });
        case EmitterKind::Point:
            return radiance * 4.0f * kPi;
        case EmitterKind::Spot:
            return radiance * kTwoPi * (0.5f * (e.oneMinusCosInner + e.oneMinusCosOuter));
        case EmitterKind::Projector:
            return radiance * e.area * 4.0f * glm::length(e.axisU) * glm::length(e.axisV);
        case EmitterKind::Goniometric:
            return radiance * e.area * 4.0f * kPi;
        case EmitterKind::Directional:
            return radiance * sceneDisc;
        case EmitterKind::Environment:
            break;
    }
    if (hasPortal(scene.lights.portal)) {
        return scene.lights.environmentIrradiance * scene.lights.portal.opening.area;
    }
    // environmentIrradiance is pi times the mean luminance; the whole sphere of directions brings four
    // times that.
    return 4.0f * scene.lights.environmentIrradiance * sceneDisc;
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
