// The light half of an SPPM pass: one photon from its light through the scene. Host and device.
//
// A photon is stored at every surface that can hold a visible point, before it is scattered there. Flux, not
// radiance, is transported: bsdf/importance.h.
#pragma once

#include "engine/kernels/bsdf/importance.h"
#include "engine/kernels/glass_stack.h"
#include "engine/kernels/intersect.h"
#include "engine/kernels/photon_emission.h"
#include "engine/kernels/photon_surface.h"
#include "engine/kernels/sampler.h"
#include "engine/math/color.h"

namespace glint {

/// Where one photon's power went, luminance; emitted is what it set out with. For energy balances
/// and counters.
struct PhotonTally {
    float emitted = 0.0f;
    float escaped = 0.0f;
    uint32_t rays = 0;
    bool faulty = false;  ///< a flux became non-finite or negative: the photon ended there
};

/// Photons are numbered over all passes, so that they stratify over all of them together. 2^32 share one key.
GLINT_HD inline Sampler makePhotonSampler(const PassParams& pass, uint64_t photonNumber) {
    constexpr int kPhotonRow = 0x7fffffff;  // no pixel has this y
    PassParams numbered = pass;
    numbered.pass = static_cast<uint32_t>(photonNumber);
    return makeSampler(numbered, static_cast<int>(photonNumber >> 32), kPhotonRow);
}

template <FeatureMask kMask>
GLINT_HD Photon makePhoton(const SceneView& view, const SppmParams& params, const SurfacePoint& surface,
                           const Vec3& wo, const Vec3& flux, int depth, uint32_t band) {
    Photon photon;
    photon.p = surface.p;
    photon.flux = flux;
    if constexpr (hasFeature<kMask>(kFeatureCutouts)) {
        // Photons pass what is half there, and so do the camera's rays: the flux is that on what is there.
        const MaterialData& material = view.materials[surface.material];
        photon.flux *= 1.0f / maxf(opacityAt<kMask>(view, material, surface.uv), 1.0f / 64.0f);
    }
    photonLayout(params).pack(wo, surface.ng, static_cast<uint32_t>(depth),
                              surfaceNumber<kMask>(view, params, surface.instance), band, &photon);
    return photon;
}

/// A photon on its way.
struct PhotonPath {
    Ray ray;
    Vec3 flux{0.0f};
    GlassStack glasses;  ///< looked at by masks with attenuation only
    float left = 1.0f;   ///< the largest share of a channel that glass left on the last way
};

/// What glass absorbs on the way to the surface that the photon has met.
template <FeatureMask kMask>
GLINT_HD void attenuatePhoton(const SceneView& view, const SurfacePoint& surface, float distance,
                              PhotonPath* photon) {
    if constexpr (hasFeature<kMask>(kFeatureAttenuation)) {
        const Vec3 absorption = absorptionBefore(view, photon->glasses, surface, -photon->ray.direction);
        const Vec3 left = transmittance(absorption, distance);
        photon->flux *= left;
        photon->left = maxComponent(left);
    }
}

/// Scatters the photon; false: it was absorbed. The roulette keeps its flux about constant.
template <FeatureMask kMask>
GLINT_HD bool scatterPhoton(const SceneView& view, const Sampler& sampler, const SurfacePoint& surface,
                            const Bsdf<kMask>& bsdf, const Vec3& wo, int depth, PhotonPath* photon) {
    const float uLobe = get1D<kMask>(sampler, dimension(BounceDimension::Lobe, depth));
    const Vec2 u = get2D<kMask>(sampler, dimension(BounceDimension::Direction, depth));
    const BsdfSample next = sampleImportance<kMask>(view, surface, bsdf, wo, uLobe, u);
    if (!next.valid) { return false; }
    const Vec3 scattered = photon->flux * next.weight;
    const float chance = minf(1.0f, maxComponent(scattered) / maxComponent(photon->flux) * photon->left);
    if (!(chance > 0.0f)) { return false; }
    if (chance < 1.0f && get1D<kMask>(sampler, dimension(BounceDimension::Roulette, depth)) >= chance) {
        return false;
    }
    photon->flux = scattered * (1.0f / chance);
    leaveSurface(surface, next.wi, &photon->ray);
    if (hasFeature<kMask>(kFeatureAttenuation) && next.isTransmission) {
        passSurface(view, surface.material, glm::dot(next.wi, surface.ng) < 0.0f, &photon->glasses);
    }
    return true;
}

/// Whether the photon came to the back of a surface that is seen from its front only. Camera and shadow rays,
/// which go the other way, meet its front there and end, so that no light may pass.
template <FeatureMask kMask>
GLINT_HD bool hitsHiddenBack(const SceneView& view, const SurfacePoint& surface, const Vec3& wo) {
    return hasFeature<kMask>(kFeatureFrontOnly) &&
           (view.geometry.instances[surface.instance].flags & kInstanceFrontOnly) != 0 &&
           glm::dot(surface.ng, wo) < 0.0f;
}

/// Traces photon `photonNumber` and calls store(photon) for each place where it counts.
template <FeatureMask kMask, class Store>
GLINT_HD PhotonTally tracePhoton(const SceneView& view, const PowerDistributionView& power,
                                 const SppmParams& params, uint64_t photonNumber, Store&& store) {
    const Sampler sampler = makePhotonSampler(params.pass, photonNumber);
    const EmittedPhoton emitted =
        emitPhoton<kMask>(view, power, get1D<kMask>(sampler, dimension(EmissionDimension::Light)),
                          get2D<kMask>(sampler, dimension(EmissionDimension::Point)),
                          get2D<kMask>(sampler, dimension(EmissionDimension::Direction)));
    PhotonTally tally;
    PhotonPath path;
    path.ray = emitted.ray;
    path.flux = emitted.flux;
    Vec3& flux = path.flux;
    Wavelength wavelength;
    tally.emitted = luminance(flux);
    const int firstStored = params.sampleDirectLight ? 1 : 0;
    // The visible point's own scattering is the last of maxDepth.
    for (int depth = 0; depth < params.pass.maxDepth && !isZero(flux); ++depth) {
        if (!isFinite(flux) || minComponent(flux) < 0.0f) {
            tally.faulty = true;
            return tally;
        }
        Hit hit;
        ++tally.rays;
        // Without the feature, backs of one-sided surfaces are hit, too.
        if (!intersect<kMask & ~kFeatureFrontOnly>(view, path.ray, &hit)) {
            tally.escaped = luminance(flux);
            return tally;
        }
        const SurfacePoint surface = surfaceAt<kMask>(view, path.ray, hit);
        const Vec3 wo = -path.ray.direction;
        if (hitsHiddenBack<kMask>(view, surface, wo)) { return tally; }
        attenuatePhoton<kMask>(view, surface, hit.t, &path);
        const Vec3 arriving = flux;
        const uint32_t band = wavelength.band;
        disperse<kMask>(view, sampler, surface.material, &wavelength, &flux);
        const Bsdf<kMask> bsdf = makeBsdf<kMask>(view, surface, wo, TransportMode::Importance, wavelength.nm);
        if (depth >= firstStored && visiblePointLobes(bsdf, params.storeAlpha).probability() > 0.0f) {
            store(makePhoton<kMask>(view, params, surface, wo, arriving, depth, band));
        }
        if (!scatterPhoton<kMask>(view, sampler, surface, bsdf, wo, depth, &path)) { return tally; }
    }
    return tally;
}

}  // namespace glint
