// The sum of the photons around a visible point, and the update of a pixel's statistics. Host and device.
//
// Hachisuka, Ogaki and Jensen 2008, "Progressive Photon Mapping", equations 7 to 13, with the shared
// statistics of Hachisuka and Jensen 2009. The photons come from any structure with visitNear(); its order is
// the order of the sum.
//
// The bias' estimate follows Hachisuka, Jakob and Jensen 2010, "A Progressive Error Estimation Framework for
// Photon Density Estimation": it is the kernel's second moment times half the Laplacian of the radiance, and
// the same photons under a smooth kernel give the Laplacian. Ours is the one with the least variance on a
// disc, a polynomial: see biasWeight().
#pragma once

#include "engine/kernels/disc_coverage.h"
#include "engine/math/color.h"

namespace glint {

namespace detail {

/// A photon counts on the surface of the visible point `p` only: within the ball, near its tangent
/// plane, where the surface has not bent away by more than 45 degrees, on none that is stacked on it,
/// and on the side that it came to: where a closed surface bends, light from within is over the horizon
/// of points nearby.
GLINT_HD inline bool liesOnSurface(const SceneView& view, const PhotonLayout& layout, const Photon& photon,
                                   const Vec3& p, const GatherSurface& surface, float radiusSquared) {
    const Vec3 offset = photon.p - p;
    const float height = glm::dot(offset, surface.ng);
    if (!(lengthSquared(offset) < radiusSquared &&
          height * height <= square(kGreatestHeight) * radiusSquared)) {
        return false;
    }
    Vec3 ng = layout.ng(photon);
    const bool isTurned = glm::dot(ng, surface.ng) < 0.0f;
    if (isTurned) { ng = -ng; }
    const Vec3 wi = layout.wi(photon);
    return glm::dot(ng, surface.ng) > kLeastNormalCosine &&
           (glm::dot(wi, ng) > 0.0f) == (glm::dot(wi, surface.ng) > 0.0f) &&
           sharePhotons(view, layout.surface(photon), surface.number, isTurned,
                        0.5f * (height + glm::dot(offset, ng)), radiusSquared);
}

/// What a pixel covers of u and v at the point; 0 where no texture asks for it.
template <FeatureMask kMask>
GLINT_HD inline float uvWidthOfPoint(const SceneView& view, const VisiblePoint& point) {
    if constexpr (hasFeature<kMask>(kFeatureMipmaps)) {
        if ((materialFlagsOf(view, view.geometry.instances[point.instance]) & kMaterialMipmaps) != 0) {
            return uvWidthIn(point.footprint);
        }
    }
    return 0.0f;
}

/// The direction of the facets at the point, whose shading normal is `ns`.
template <FeatureMask kMask>
GLINT_HD inline Vec3 facetAxisOfPoint(const SceneView& view, const VisiblePoint& point, const Vec3& ns) {
    if constexpr (hasFeature<kMask>(kFeatureFacets)) {
        if ((materialFlagsOf(view, view.geometry.instances[point.instance]) & kMaterialFacets) != 0) {
            const SinCos angle = sinCosTurns(0.5f * halfTurnIn(point.vertexColor));
            const Frame frame = Frame::fromNormal(ns);
            return angle.cos * frame.s + angle.sin * frame.t;
        }
    }
    return Vec3(0.0f);
}

/// Weight of a photon at a distance of sqrt(t) radii in the estimate of the bias of the mean over the disc.
/// Radiance L + a r^2 has a mean of L + a R^2 / 2 there, and a mean of a R^2 / 6 when weighted by 2t - 1, in
/// which constant and linear radiance cancel. The estimate has three times the mean's variance and is
/// uncorrelated with it where the radiance is about even.
GLINT_HD inline float biasWeight(float t) { return 3.0f * (2.0f * t - 1.0f); }

}  // namespace detail

/// Sums the photons within `radiusSquared` (world units squared) of the point. A photon that the BSDF sends
/// nothing of towards the camera (it came to the other side) neither adds nor counts. `statistics` and
/// `sampler`: the pixel's.
template <FeatureMask kMask, class PhotonMap>
GLINT_HD Gathered gatherPhotons(const SceneView& view, const PhotonMap& photons, const SppmParams& params,
                                const SppmPixel& statistics, const Sampler& sampler,
                                const VisiblePoint& point, float radiusSquared) {
    Gathered gathered;
    Vec3 bias(0.0f);
    const PhotonLayout layout = photonLayout(params);
    const Vec3 ng = unpackUnitVector<16>(point.ngPacked);
    const Vec3 ns = unpackUnitVector<16>(point.nsPacked);
    const GatherSurface surface{ng,
                                ns,
                                point.vertexColor,
                                point.uv,
                                view.geometry.instances[point.instance].material,
                                surfaceNumber<kMask>(view, params, point.instance),
                                detail::uvWidthOfPoint<kMask>(view, point),
                                detail::facetAxisOfPoint<kMask>(view, point, ns)};
    DiscClip clip;
    gathered.probe = detail::probeDisc<kMask>(view, params, statistics, sampler, point, surface,
                                              std::sqrt(radiusSquared), &clip);
    Wavelength wavelength;
    if constexpr (hasFeature<kMask>(kFeatureDispersion)) {
        if (point.hasWavelength != 0) { wavelength = wavelengthOf<kMask>(view, sampler); }
    }
    const Bsdf<kMask> bsdf =
        makeBsdf<kMask>(view, surface, point.woWorld, TransportMode::Radiance, wavelength.nm);
    const uint32_t scatteringsLeft = static_cast<uint32_t>(params.pass.maxDepth) - 1u - point.depth;
    photons.visitNear(point.p, std::sqrt(radiusSquared), [&](const Photon& photon) {
        if (!detail::liesOnSurface(view, layout, photon, point.p, surface, radiusSquared)) { return; }
        if (!clip.contains(photon.p - point.p)) { return; }
        if (layout.depth(photon) > scatteringsLeft) { return; }
        const Vec3 wi = layout.wi(photon);
        const float cosine = absDot(wi, ng);
        if (!(cosine > 0.0f)) { return; }
        const Vec3 reflected =
            evaluate(bsdf, wi) * (1.0f / cosine);  // evaluate() has |cos| to ns, flux is per area of ng
        if (isZero(reflected)) { return; }
        Vec3 flux = reflected * photon.flux;
        if constexpr (hasFeature<kMask>(kFeatureDispersion)) {
            flux *= spectralOverlap(wavelength, layout.band(photon), spectrumBands(view.spectrum.count));
            if (isZero(flux)) { return; }
        }
        gathered.flux += flux;
        bias += flux * detail::biasWeight(lengthSquared(photon.p - point.p) / radiusSquared);
        ++gathered.count;
    });
    gathered.flux *= point.throughput;
    gathered.bias = luminance(bias * point.throughput);
    return gathered;
}

/// The radius a pixel starts with when its first visible point turns up.
GLINT_HD inline double initialRadiusSquared(const SppmParams& params, float footprint) {
    const double radius = params.radiusWorld > 0.0f
                              ? static_cast<double>(params.radiusWorld)
                              : static_cast<double>(params.radiusFootprints) * static_cast<double>(footprint);
    return radius * radius;
}

namespace detail {

/// Luminance of tau / (pi R^2): the sum over all passes of what each brought by its own radius, since tau is
/// scaled along with R^2. 0 before the first visible point.
GLINT_HD inline double summedLuminance(const SppmPixel& pixel) {
    if (!(pixel.radiusSquared > 0.0)) { return 0.0; }
    return (0.2126 * pixel.flux[0] + 0.7152 * pixel.flux[1] + 0.0722 * pixel.flux[2]) /
           (3.14159265358979323846 * pixel.radiusSquared);
}

}  // namespace detail

/// Adds pass number `pass` (from 0) with this many emitted photons: N' = N + alpha M, R'^2 = R^2 N' / (N +
/// M), tau' = (tau + flux) R'^2 / R^2. A pass without a photon changes neither radius nor flux. The picture
/// is the mean of the passes' own estimates, so that their variance and mean bias are the picture's.
GLINT_HD inline void updatePixel(const Gathered& gathered, double alpha, uint32_t pass, double emittedInPass,
                                 SppmPixel* pixel) {
    const double found = static_cast<double>(gathered.count);
    const double passes = static_cast<double>(pass);
    const double before = detail::summedLuminance(*pixel);
    double bias = 0.0;
    if (gathered.count > 0) {
        bias = static_cast<double>(gathered.bias) /
               (3.14159265358979323846 * pixel->radiusSquared * emittedInPass);
        const double kept = pixel->photonCount + alpha * found;
        const double shrink = kept / (pixel->photonCount + found);
        for (int channel = 0; channel < 3; ++channel) {
            pixel->flux[channel] =
                (pixel->flux[channel] + static_cast<double>(gathered.flux[channel])) * shrink;
        }
        pixel->radiusSquared *= shrink;
        pixel->photonCount = kept;
    }
    // Welford's update, with the mean that tau holds already.
    const double after = detail::summedLuminance(*pixel);
    const double estimate = (after - before) / emittedInPass;
    const double meanBefore = passes > 0.0 ? before / (passes * emittedInPass) : 0.0;
    const double meanAfter = after / ((passes + 1.0) * emittedInPass);
    pixel->passM2 += maxf(0.0f, static_cast<float>((estimate - meanBefore) * (estimate - meanAfter)));
    const DiscProbe& probe = gathered.probe;
    if (probe.isMade) { pixel->probes += 1.0f; }
    if (probe.isCovered) { pixel->covered += 1.0f; }
    if (probe.isCovered && pixel->covered < pixel->probes) {
        // The weights add up to nothing over whole discs only.
        bias -= static_cast<double>(detail::biasWeight(probe.t)) * meanAfter * coverageFactor(*pixel);
    }
    pixel->bias += (static_cast<float>(bias) - pixel->bias) / static_cast<float>(passes + 1.0);
}

/// Radiance that the photons of all passes brought: tau / (emitted photons * pi R^2), by the part of the
/// discs that could bring any.
GLINT_HD inline Vec3 photonRadiance(const SppmPixel& pixel, double emittedPhotons) {
    if (!(pixel.radiusSquared > 0.0) || !(emittedPhotons > 0.0)) { return Vec3(0.0f); }
    const double scale =
        coverageFactor(pixel) / (emittedPhotons * 3.14159265358979323846 * pixel.radiusSquared);
    return {static_cast<float>(pixel.flux[0] * scale), static_cast<float>(pixel.flux[1] * scale),
            static_cast<float>(pixel.flux[2] * scale)};
}

}  // namespace glint
