// What the BSDFs' parts have in common: the results of sampling and evaluating in the local frame. Host
// and device.
//
// Local frame: z is the shading normal on wo's side, so wo.z >= 0; wi.z > 0 is reflection, wi.z < 0
// transmission. All directions point away from the surface. Nothing here knows scenes, textures or
// world space.
#pragma once

#include "engine/kernels/fresnel.h"
#include "engine/kernels/microfacet.h"
#include "engine/kernels/shading_view.h"
#include "engine/math/rng.h"

namespace glint {

/// What is transported along the path: radiance (paths from the camera) shrinks by the squared relative index
/// of refraction when it enters a denser medium; importance, that is photons' power, does not.
enum class TransportMode : uint8_t { Radiance, Importance };

/// f |cos wi| and the density of wi by solid angle, without the parts that only one direction has (deltas).
struct LobeValue {
    Vec3 value{0.0f};
    float pdfSolidAngle = 0.0f;
};

struct LobeSample {
    Vec3 wiLocal{0.0f};
    Vec3 weight{0.0f};           ///< f |cos wi| / density
    float pdfSolidAngle = 0.0f;  ///< 0 when isSpecular
    float etaScale = 1.0f;       ///< squared relative index when radiance was scaled by its inverse, else 1
    bool isSpecular = false;
    bool isTransmission = false;
    bool valid = false;
};

namespace detail {

GLINT_HD inline LobeSample specularSample(const Vec3& wiLocal, const Vec3& weight) {
    LobeSample sample;
    sample.wiLocal = wiLocal;
    sample.weight = weight;
    sample.isSpecular = true;
    sample.valid = true;
    return sample;
}

GLINT_HD inline LobeSample glossySample(const Vec3& wiLocal, const Vec3& weight, float pdfSolidAngle) {
    LobeSample sample;
    sample.wiLocal = wiLocal;
    sample.weight = weight;
    sample.pdfSolidAngle = pdfSolidAngle;
    sample.valid = pdfSolidAngle > 0.0f;
    return sample;
}

GLINT_HD inline Vec3 mirrored(const Vec3& woLocal) { return {-woLocal.x, -woLocal.y, woLocal.z}; }

/// G2 / G1(wo): the weight, without Fresnel, of a reflection on a sampled visible normal.
GLINT_HD inline float ggxReflectionWeight(const Vec3& wo, const Vec3& wi, float alpha) {
    const float rootO = ggxRoot(wo, alpha);
    const float rootI = ggxRoot(wi, alpha);
    return wi.z * (wo.z + rootO) / maxf(wo.z * rootI + wi.z * rootO, 1e-20f);
}

}  // namespace detail

/// Where a smooth normal ns turns away from the light later than the geometric normal ng, shadow rays cut the
/// shading off along the facets. This factor fades diffuse reflection out softly before: Chiang, Li and
/// Burley 2019, "Taming the Shadow Terminator". 1 where ns = ng. Arguments: the cosines between the three.
GLINT_HD inline float shadowTerminator(float ngWi, float nsWi, float ngNs) {
    const float g = clampf(ngWi / maxf(nsWi * ngNs, 1e-20f), 0.0f, 1.0f);
    return g * (1.0f + g * (1.0f - g));
}

GLINT_HD inline LobeValue evaluateDiffuse(const Vec3& color, const Vec3& wi) {
    const float pdf = maxf(wi.z, 0.0f) * kInvPi;
    return {color * pdf, pdf};
}

GLINT_HD inline LobeSample sampleDiffuse(const Vec3& color, Vec2 u) {
    const Vec3 wi = sampleCosineHemisphere(u);
    return detail::glossySample(wi, color, wi.z * kInvPi);
}

/// A rough metal: `color` times Fresnel, GGX of `alpha`.
GLINT_HD inline LobeValue evaluateRoughConductor(const MaterialData& material, const Vec3& color,
                                                 const Vec3& wo, const Vec3& wi) {
    if (!(wi.z > 0.0f)) { return {}; }
    const Vec3 h = glm::normalize(wo + wi);
    const Vec3 fresnel = fresnelConductor(clampf(glm::dot(wo, h), 0.0f, 1.0f), material.eta, material.k);
    return {color * fresnel * ggxReflection(wo, wi, h, material.alpha),
            ggxReflectionPdf(wo, h, material.alpha)};
}

GLINT_HD inline LobeSample sampleRoughConductor(const MaterialData& material, const Vec3& color,
                                                const Vec3& wo, Vec2 u) {
    const Vec3 h = sampleVisibleNormal(wo, material.alpha, u);
    const Vec3 wi = reflect(wo, h);
    if (!(wi.z > 0.0f)) { return {}; }
    const Vec3 fresnel = fresnelConductor(clampf(glm::dot(wo, h), 0.0f, 1.0f), material.eta, material.k);
    return detail::glossySample(wi, color * fresnel * detail::ggxReflectionWeight(wo, wi, material.alpha),
                                ggxReflectionPdf(wo, h, material.alpha));
}

GLINT_HD inline LobeSample sampleSmoothConductor(const MaterialData& material, const Vec3& color,
                                                 const Vec3& wo) {
    return detail::specularSample(detail::mirrored(wo),
                                  color * fresnelConductor(minf(wo.z, 1.0f), material.eta, material.k));
}

}  // namespace glint
