// How a photon scatters: the adjoint of what paths from the camera meet. Host and device.
//
// A surface that shows a camera path the radiance L(wo) = f |cos wi| L(wi) sends on, of the power that comes
// from wi, f |cos wi| |ng.wo| / |ng.wi| per solid angle. With interpolated normals f is not symmetric (Veach
// 1997, "Robust Monte Carlo Methods for Light Transport Simulation", section 5.3), and here it also depends
// on wo how far ns is bent. So lobes with a density are evaluated as the camera path would see them, and
// specular lobes run backwards, their two folds (bsdf.h) included. Left out: directions that a rough or a
// mixed material shows to a camera path only because ns bends, or leans far, away from the photon's. Here
// `wo` is where the photon comes from.
#pragma once

#include "engine/kernels/bsdf/bsdf.h"
#include "engine/kernels/surface.h"

namespace glint {
namespace detail {

/// A direction that folding may have taken to a given one, picked among `ways` (0: there is none).
struct Unfolded {
    Vec3 direction{0.0f};
    float ways = 0.0f;
};

/// `w` or its image behind the plane of `mirror`: what lies on the side that `side` points to.
GLINT_HD inline Unfolded unfold(const Vec3& w, const Vec3& mirror, const Vec3& side, float u) {
    const Vec3 image = w - 2.0f * glm::dot(w, mirror) * mirror;
    const bool itself = glm::dot(w, side) > 0.0f;
    const bool other = glm::dot(image, side) > 0.0f;
    if (itself && other) { return {u < 0.5f ? w : image, 2.0f}; }
    if (itself) { return {w, 1.0f}; }
    return {image, other ? 1.0f : 0.0f};
}

template <FeatureMask kMask>
GLINT_HD BsdfSample specularImportance(const Bsdf<kMask>& bsdf, const Unfolded& from, const Vec3& wo,
                                       const BsdfSample& lobe, float u) {
    const Vec3 side = bsdf.frame.toLocal(lobe.isTransmission ? -bsdf.ngWorld : bsdf.ngWorld);
    const Unfolded to = unfold(lobe.wi, Vec3(0.0f, 0.0f, 1.0f), side, u);
    const float below = absDot(bsdf.ngWorld, wo) * std::fabs(to.direction.z);
    if (!(from.ways * to.ways > 0.0f) || !(below > 0.0f)) { return {}; }
    BsdfSample result;
    result.wi = bsdf.frame.toWorld(to.direction);
    const float above = std::fabs(from.direction.z) * absDot(bsdf.ngWorld, result.wi);
    result.weight = lobe.weight * (from.ways * to.ways * above / below);
    result.isSpecular = true;
    result.isTransmission = lobe.isTransmission;
    result.valid = true;
    return result;
}

template <FeatureMask kMask>
GLINT_HD BsdfSample nonDeltaAdjoint(const SceneView& view, const SurfacePoint& surface,
                                    const Bsdf<kMask>& bsdf, const Vec3& wo, const BsdfSample& lobe) {
    BsdfSample result;
    result.wi = frameOf(bsdf).toWorld(lobe.wi);
    if (!(geometricCosine(bsdf, result.wi, lobe.wi.z) * lobe.wi.z > 0.0f)) { return {}; }
    const float below = absDot(surface.ng, wo) * lobe.pdfSolidAngle;
    if (!(below > 0.0f)) { return {}; }
    const Bsdf<kMask> seen =
        makeBsdf<kMask>(view, surface, result.wi, TransportMode::Radiance, bsdf.wavelengthNm);
    result.weight = evaluate(seen, wo) * (absDot(surface.ng, result.wi) / below);
    result.pdfSolidAngle = lobe.pdfSolidAngle;
    result.isTransmission = lobe.isTransmission;
    result.valid = true;
    return result;
}

}  // namespace detail

/// A direction in which a photon from `wo` goes on; weight is the share of its power over the density. `bsdf`
/// was made for `wo` and importance; uLobe and u in [0, 1).
template <FeatureMask kMask>
GLINT_HD BsdfSample sampleImportance(const SceneView& view, const SurfacePoint& surface,
                                     const Bsdf<kMask>& bsdf, const Vec3& wo, float uLobe, Vec2 u) {
    if constexpr (hasFeature<kMask>(kFeatureShadingNormals)) {
        if (surface.ns != surface.ng) {
            Bsdf<kMask> unfolded = bsdf;
            detail::Unfolded from;
            if constexpr (!isDiffuseOnly<kMask>()) {
                const Vec3 up(0.0f, 0.0f, 1.0f);
                if (detail::hasSpecularLobe(bsdf)) {
                    from = detail::unfold(bsdf.woLocal, bsdf.frame.toLocal(bsdf.ngWorld), up, u.x);
                    unfolded.woLocal = from.direction;
                    if (from.ways > 1.0f) { u.x = 2.0f * (u.x < 0.5f ? u.x : u.x - 0.5f); }
                }
                // Only lobes with a density are left where no camera path leads to wo.
                unfolded.woLocal.z = std::fabs(unfolded.woLocal.z);
            }
            const BsdfSample lobe = detail::sampleLocal(unfolded, uLobe, u);
            if (!lobe.valid) { return {}; }
            if constexpr (!isDiffuseOnly<kMask>()) {
                if (lobe.isSpecular) { return detail::specularImportance(bsdf, from, wo, lobe, u.y); }
            }
            return detail::nonDeltaAdjoint(view, surface, bsdf, wo, lobe);
        }
    }
    return sample(bsdf, uLobe, u);
}

}  // namespace glint
