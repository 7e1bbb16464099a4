// Glass: a boundary between two dielectrics, smooth or GGX, and a thin sheet. Host and device. Called by
// bsdf.h only.
//
// eta is the index on the far side over the one on wo's side. `tint` multiplies what passes and what
// reflects. Left out: absorption along the way inside, dispersion, light that bounces more than once between
// facets; roughness of sheets.
#pragma once

#include "engine/kernels/bsdf_lobes.h"

namespace glint {
namespace detail {

GLINT_HD inline float radianceScale(float eta, TransportMode transport) {
    return transport == TransportMode::Radiance ? 1.0f / square(eta) : 1.0f;
}

GLINT_HD inline void markTransmission(LobeSample* sample, float eta, TransportMode transport) {
    sample->isTransmission = true;
    sample->etaScale = transport == TransportMode::Radiance ? square(eta) : 1.0f;
}

}  // namespace detail

/// Reflects with the Fresnel reflectance as its probability, else refracts.
GLINT_HD inline LobeSample sampleSmoothDielectric(const Vec3& tint, float eta, const Vec3& wo, float uLobe,
                                                  TransportMode transport) {
    const float cosO = minf(wo.z, 1.0f);
    float cosT = 0.0f;
    const float fresnel = fresnelDielectric(cosO, eta, &cosT);
    if (uLobe < fresnel) { return detail::specularSample(detail::mirrored(wo), tint); }
    LobeSample sample = detail::specularSample(Vec3(-wo.x / eta, -wo.y / eta, -cosT),
                                               tint * detail::radianceScale(eta, transport));
    detail::markTransmission(&sample, eta, transport);
    return sample;
}

/// A sheet of no thickness between like media: the two boundaries' reflections sum to 2R / (1 + R), and light
/// passes straight. `ior` is the sheet's over its surroundings' index.
GLINT_HD inline LobeSample sampleThinDielectric(const Vec3& tint, float ior, const Vec3& wo, float uLobe) {
    float cosT = 0.0f;
    const float single = fresnelDielectric(minf(wo.z, 1.0f), ior, &cosT);
    if (uLobe < 2.0f * single / (1.0f + single)) {
        return detail::specularSample(detail::mirrored(wo), tint);
    }
    LobeSample sample = detail::specularSample(-wo, tint);
    sample.isTransmission = true;
    return sample;
}

/// Walter et al. 2007, "Microfacet Models for Refraction through Rough Surfaces", with visible normals.
/// Reflection uses the height-correlated G2; refraction the product of both G1 (their eq. 23).
GLINT_HD inline LobeValue evaluateRoughDielectric(const Vec3& tint, float alpha, float eta, const Vec3& wo,
                                                  const Vec3& wi, TransportMode transport) {
    if (wi.z == 0.0f) { return {}; }
    const bool reflects = wi.z > 0.0f;
    Vec3 h = glm::normalize(reflects ? wo + wi : wo + eta * wi);
    h = h.z < 0.0f ? -h : h;
    const float cosO = glm::dot(wo, h);
    if (!(cosO > 0.0f)) { return {}; }
    float cosT = 0.0f;
    const float fresnel = fresnelDielectric(minf(cosO, 1.0f), eta, &cosT);
    if (reflects) {
        return {tint * (fresnel * ggxReflection(wo, wi, h, alpha)), fresnel * ggxReflectionPdf(wo, h, alpha)};
    }
    const float cosI = glm::dot(wi, h);
    if (!(cosI < 0.0f)) { return {}; }
    const float jacobian = square(eta) * -cosI / maxf(square(cosO + eta * cosI), 1e-20f);
    const float pdf = (1.0f - fresnel) * visibleNormalPdf(wo, h, alpha) * jacobian;
    return {tint * (pdf * ggxVisible(-wi, alpha) * detail::radianceScale(eta, transport)), pdf};
}

GLINT_HD inline LobeSample sampleRoughDielectric(const Vec3& tint, float alpha, float eta, const Vec3& wo,
                                                 float uLobe, Vec2 u, TransportMode transport) {
    const Vec3 h = sampleVisibleNormal(wo, alpha, u);
    const float cosO = clampf(glm::dot(wo, h), 0.0f, 1.0f);
    float cosT = 0.0f;
    const float fresnel = fresnelDielectric(cosO, eta, &cosT);
    if (uLobe < fresnel) {
        const Vec3 wi = reflect(wo, h);
        if (!(wi.z > 0.0f)) { return {}; }
        return detail::glossySample(wi, tint * detail::ggxReflectionWeight(wo, wi, alpha),
                                    fresnel * ggxReflectionPdf(wo, h, alpha));
    }
    const Vec3 wi = glm::normalize(refract(wo, h, eta, cosO, cosT));
    if (!(wi.z < 0.0f)) { return {}; }
    const float jacobian = square(eta) * cosT / maxf(square(cosO - eta * cosT), 1e-20f);
    LobeSample sample =
        detail::glossySample(wi, tint * (ggxVisible(-wi, alpha) * detail::radianceScale(eta, transport)),
                             (1.0f - fresnel) * visibleNormalPdf(wo, h, alpha) * jacobian);
    detail::markTransmission(&sample, eta, transport);
    return sample;
}

}  // namespace glint
