// What a scene file may say about how it is rendered. Command-line options and panels override it.
#pragma once

#include <cstdint>

#include "engine/base/kinds.h"
#include "engine/math/vec.h"
#include "engine/scene/integrator_kind.h"

namespace glint {

/// Half the support in pixels that a filter has unless it is given.
constexpr float usualRadius(FilterKind filter) { return filter == FilterKind::Box ? 0.5f : 1.5f; }

/// All of these but the integrator and the acceleration structure change the picture's expectation or its
/// noise. An edit of any restarts the films, but for the integrator, which chooses between the films that are
/// kept side by side.
struct RenderOptions {
    IntegratorKind integrator = IntegratorKind::PathTracing;
    /// Most scattering events along a path; 0: only directly visible emission. At 16, rooms of mirrors would
    /// lose a tenth of their light.
    int maxDepth = 64;
    int rouletteStartDepth = 4;  ///< Russian roulette from this scattering event on: it ends most paths early
    FilterKind filter = FilterKind::BlackmanHarris;
    float filterRadius = 1.5f;  ///< pixels, half the support; box: 0.5 is one pixel
    SamplerKind sampler = SamplerKind::Sobol;
    AcceleratorKind accelerator = AcceleratorKind::Bvh;  ///< changes nothing but the time
    uint32_t seed = 0;
    /// 0: off. Otherwise the most radiance one sample may bring; biased, and reported
    float fireflyClamp = 0.0f;

    bool operator==(const RenderOptions&) const = default;
};

/// Stochastic progressive photon mapping (Hachisuka and Jensen 2009). An edit of any restarts its
/// statistics only.
struct SppmOptions {
    uint32_t photonsPerPass = 262144;
    /// share of each pass's photons that is kept, in (0, 1): smaller shrinks radii faster
    float alpha = 2.0f / 3.0f;
    float radiusWorld = 0.0f;  ///< initial radius; 0: automatic, from each pixel's footprint
    /// automatic: initial radius in pixel footprints at the first visible point
    float radiusFootprints = 4.0f;
    /// metal and glass of at least this GGX alpha hold visible points; sharper ones reflect
    float storeRoughness = 0.1f;
    bool sampleDirectLight = true;  ///< direct light by light sampling; otherwise photons bring it, too
    PhotonLookupKind lookup = PhotonLookupKind::Grid;
    uint32_t memoryBudgetMiB = 1024;  ///< for statistics and photons; photons per pass are reduced to fit

    bool operator==(const SppmOptions&) const = default;
};

/// Phong's model (Phong 1975) under the scene's lights without a shape. An edit restarts its film only.
struct RayCastOptions {
    bool shadows = true;
    bool falloff = true;  ///< otherwise point and spot lights shine everywhere as at the scene's middle
    Vec3 ambient{0.0f};   ///< radiance from all around, which nothing shades

    bool operator==(const RayCastOptions&) const = default;
};

struct Resolution {
    int width = 512;
    int height = 512;

    bool operator==(const Resolution&) const = default;
};

}  // namespace glint
