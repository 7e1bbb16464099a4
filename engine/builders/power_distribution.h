// How photons are shared out among a scene's lights. Built for SPPM only.
#pragma once

#include <memory>
#include <vector>

#include "engine/kernels/photon_emission.h"

namespace glint {

struct PowerDistribution {
    std::vector<float> cdf;
    float totalPower = 0.0f;

    /// Host pointers into this object.
    PowerDistributionView view() const;
    size_t bytes() const { return cdf.size() * sizeof(float); }
};

/// Lights by their power (luminance): flat and round area lights pi times area times radiance, on both
/// sides where they emit on both; the infinitely far ones over the scene's bounding disc. Empty when
/// nothing emits photons.
PowerDistribution buildPowerDistribution(const SceneView& scene);

}  // namespace glint
