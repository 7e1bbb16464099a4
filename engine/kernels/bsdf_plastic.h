// Plastic: a diffuse base under a clear dielectric coat, smooth or GGX. Host and device. Called by
// bsdf.h only.
//
// What the coat does not reflect, 1 - E(wo), enters; inside, it goes back and forth between the diffuse base
// and the coat's underside, which reflects the share Fi of diffuse light; what leaves is shaped by 1 - E(wi):
//     f = base (1 - E(wo)) (1 - E(wi)) / pi * (1 - Fi) / ((1 - Eavg) (1 - base Fi)),
// which is reciprocal and, for base = 1, reflects exactly what enters. E is the coat's directional albedo:
// Fresnel for a smooth coat, a table for a rough one. For a smooth coat 1 - Fi = (1 - Eavg) / ior^2, and
// this is the usual model (Pharr, Jakob and Humphreys 2023, section 14.3, discuss it; Kelemen and
// Szirmay-Kalos 2001 for the coupling). Left out: absorption in the coat; the broadening of what enters
// through a rough coat.
#pragma once

#include "engine/kernels/bsdf_lobes.h"

namespace glint {
namespace detail {

/// E at cosine mu. The table holds E over the smooth boundary's Fresnel reflectance, which hardly varies, at
/// mu = (i / (n-1))^2.
GLINT_HD inline float coatAlbedo(const MaterialData& material, float mu) {
    const float cosine = clampf(mu, 0.0f, 1.0f);
    float cosT = 0.0f;
    const float fresnel = fresnelDielectric(cosine, material.ior, &cosT);
    if (material.alpha < kSmoothAlpha) { return fresnel; }
    const float position = std::sqrt(cosine) * static_cast<float>(kCoatSamples - 1);
    const int index =
        position < static_cast<float>(kCoatSamples - 2) ? static_cast<int>(position) : kCoatSamples - 2;
    const float weight = position - static_cast<float>(index);
    const float ratio = (1.0f - weight) * material.coatRatio[index] + weight * material.coatRatio[index + 1];
    return minf(fresnel * ratio, 1.0f);
}

/// The base's reflectance of light that has entered, summed over all orders.
GLINT_HD inline Vec3 coatedBase(const MaterialData& material, const Vec3& base) {
    const float inside = material.coatInternalAlbedo;
    return base * ((1.0f - inside) / (Vec3(1.0f) - base * inside));
}

/// How the lobes are chosen for one wo: by the light each reflects.
struct PlasticChoice {
    Vec3 base;     ///< coatedBase
    float enters;  ///< 1 - E(wo)
    float coatProbability;
};

GLINT_HD inline PlasticChoice plasticChoice(const MaterialData& material, const Vec3& color, const Vec3& wo) {
    PlasticChoice choice;
    const float reflected = coatAlbedo(material, wo.z);
    choice.base = coatedBase(material, color);
    choice.enters = 1.0f - reflected;
    const float diffuse = choice.enters * maxComponent(choice.base);
    const float sum = reflected + diffuse;
    choice.coatProbability = sum > 0.0f ? reflected / sum : 0.0f;
    return choice;
}

GLINT_HD inline LobeValue evaluatePlasticWith(const MaterialData& material, const PlasticChoice& choice,
                                              const Vec3& wo, const Vec3& wi, float baseScale) {
    const float leaves = (1.0f - coatAlbedo(material, wi.z)) / maxf(1.0f - material.coatAverageAlbedo, 1e-6f);
    LobeValue result = evaluateDiffuse(choice.base * (choice.enters * leaves * baseScale), wi);
    result.pdfSolidAngle *= 1.0f - choice.coatProbability;
    if (material.alpha >= kSmoothAlpha) {
        const Vec3 h = glm::normalize(wo + wi);
        float cosT = 0.0f;
        const float fresnel = fresnelDielectric(clampf(glm::dot(wo, h), 0.0f, 1.0f), material.ior, &cosT);
        result.value += Vec3(fresnel * ggxReflection(wo, wi, h, material.alpha));
        result.pdfSolidAngle += choice.coatProbability * ggxReflectionPdf(wo, h, material.alpha);
    }
    return result;
}

}  // namespace detail

/// baseScale multiplies the base: how much of it the shadow terminator leaves.
GLINT_HD inline LobeValue evaluatePlastic(const MaterialData& material, const Vec3& color, const Vec3& wo,
                                          const Vec3& wi, float baseScale) {
    if (!(wi.z > 0.0f)) { return {}; }
    return detail::evaluatePlasticWith(material, detail::plasticChoice(material, color, wo), wo, wi,
                                       baseScale);
}

/// baseScale(wiLocal): likewise, of the direction that is found.
template <class BaseScale>
GLINT_HD LobeSample samplePlastic(const MaterialData& material, const Vec3& color, const Vec3& wo,
                                  float uLobe, Vec2 u, BaseScale&& baseScale) {
    const detail::PlasticChoice choice = detail::plasticChoice(material, color, wo);
    Vec3 wi;
    if (uLobe < choice.coatProbability) {
        if (material.alpha < kSmoothAlpha) {
            // E(wo) / coatProbability, which is 0 / 0 where the coat reflects nothing.
            const float weight = (1.0f - choice.enters) / choice.coatProbability;
            return detail::specularSample(detail::mirrored(wo), Vec3(weight));
        }
        wi = reflect(wo, sampleVisibleNormal(wo, material.alpha, u));
    } else {
        wi = sampleCosineHemisphere(u);
    }
    if (!(wi.z > 0.0f)) { return {}; }
    const LobeValue value = detail::evaluatePlasticWith(material, choice, wo, wi, baseScale(wi));
    if (!(value.pdfSolidAngle > 0.0f)) { return {}; }
    return detail::glossySample(wi, value.value / value.pdfSolidAngle, value.pdfSolidAngle);
}

}  // namespace glint
