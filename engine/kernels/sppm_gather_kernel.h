// The sum of the photons around a visible point, and the update of a pixel's statistics. Host and device.
//
// Hachisuka, Ogaki and Jensen 2008, "Progressive Photon Mapping", equations 7 to 13, with the shared
// statistics of Hachisuka and Jensen 2009. The photons come from any structure with visitNear(); its order is
// the order of the sum.
#pragma once

#include "engine/kernels/bsdf.h"
#include "engine/kernels/scene_view.h"
#include "engine/kernels/sppm_view.h"
#include "engine/math/color.h"
#include "engine/math/octahedral.h"

namespace glint {

namespace detail {

/// What makeBsdf() needs of a surface.
struct GatherSurface {
    Vec3 ng, ns, vertexColor;
    Vec2 uv;
    uint32_t material;
};

/// A photon counts on the surface of the visible point only: within the ball, near its tangent plane, where
/// the surface has not bent away by more than 45 degrees.
GLINT_HD inline bool liesOnSurface(const Photon& photon, const VisiblePoint& point, const Vec3& ng,
                                   float radiusSquared) {
    constexpr float kLeastNormalCosine = 0.70710678f;
    constexpr float kGreatestHeight = 0.5f;  // of the radius
    const Vec3 offset = photon.p - point.p;
    const float height = glm::dot(offset, ng);
    return lengthSquared(offset) < radiusSquared &&
           height * height <= square(kGreatestHeight) * radiusSquared &&
           glm::dot(unpackUnitVector<12>(photon.ngAndDepth), ng) > kLeastNormalCosine;
}

}  // namespace detail

/// Sums the photons within `radiusSquared` (world units squared) of the point. A photon that the BSDF sends
/// nothing of towards the camera (it came to the other side) neither adds nor counts.
template <FeatureMask kMask, class PhotonMap>
GLINT_HD Gathered gatherPhotons(const SceneView& view, const PhotonMap& photons, const SppmParams& params,
                                const VisiblePoint& point, float radiusSquared) {
    Gathered gathered;
    const Vec3 ng = unpackUnitVector<16>(point.ngPacked);
    const detail::GatherSurface surface{ng, unpackUnitVector<16>(point.nsPacked), point.vertexColor, point.uv,
                                        point.material};
    const Bsdf<kMask> bsdf = makeBsdf<kMask>(view, surface, point.woWorld);
    const uint32_t scatteringsLeft = static_cast<uint32_t>(params.pass.maxDepth) - 1u - point.depth;
    photons.visitNear(point.p, std::sqrt(radiusSquared), [&](const Photon& photon) {
        if (!detail::liesOnSurface(photon, point, ng, radiusSquared)) return;
        if (photon.ngAndDepth >> 24 > scatteringsLeft) return;
        const Vec3 wi = unpackUnitVector<16>(photon.wiPacked);
        const float cosine = absDot(wi, ng);
        if (!(cosine > 0.0f)) return;
        const Vec3 reflected =
            evaluate(bsdf, wi) * (1.0f / cosine);  // evaluate() has |cos| to ns, flux is per area of ng
        if (isZero(reflected)) return;
        gathered.flux += reflected * photon.flux;
        ++gathered.count;
    });
    gathered.flux *= point.throughput;
    return gathered;
}

/// The radius a pixel starts with when its first visible point turns up.
GLINT_HD inline double initialRadiusSquared(const SppmParams& params, float footprint) {
    const double radius = params.radiusWorld > 0.0f
                              ? static_cast<double>(params.radiusWorld)
                              : static_cast<double>(params.radiusFootprints) * static_cast<double>(footprint);
    return radius * radius;
}

/// Adds pass number `pass` (from 0) with this many emitted photons: N' = N + alpha M, R'^2 = R^2 N' / (N +
/// M), tau' = (tau + flux) R'^2 / R^2. A pass without a photon changes neither radius nor flux.
GLINT_HD inline void updatePixel(const Gathered& gathered, double alpha, uint32_t pass, double emittedInPass,
                                 SppmPixel* pixel) {
    const double found = static_cast<double>(gathered.count);
    float estimate = 0.0f;
    if (gathered.count > 0) {
        const double area = 3.14159265358979323846 * pixel->radiusSquared;
        estimate = static_cast<float>(static_cast<double>(luminance(gathered.flux)) / (area * emittedInPass));
        const double kept = pixel->photonCount + alpha * found;
        const double shrink = kept / (pixel->photonCount + found);
        for (int channel = 0; channel < 3; ++channel) {
            pixel->flux[channel] =
                (pixel->flux[channel] + static_cast<double>(gathered.flux[channel])) * shrink;
        }
        pixel->radiusSquared *= shrink;
        pixel->photonCount = kept;
    }
    const float deviation = estimate - pixel->passMean;
    pixel->passMean += deviation / (static_cast<float>(pass) + 1.0f);
    pixel->passM2 += deviation * (estimate - pixel->passMean);
}

/// Radiance that the photons of all passes brought: tau / (emitted photons * pi R^2).
GLINT_HD inline Vec3 photonRadiance(const SppmPixel& pixel, double emittedPhotons) {
    if (!(pixel.radiusSquared > 0.0) || !(emittedPhotons > 0.0)) return Vec3(0.0f);
    const double scale = 1.0 / (emittedPhotons * 3.14159265358979323846 * pixel.radiusSquared);
    return {static_cast<float>(pixel.flux[0] * scale), static_cast<float>(pixel.flux[1] * scale),
            static_cast<float>(pixel.flux[2] * scale)};
}

}  // namespace glint
