// Plastic: a diffuse base under a clear dielectric coat, smooth or GGX. Host and device.
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

#include "engine/kernels/bsdf/diffuse.h"
#include "engine/kernels/bsdf/fresnel.h"
#include "engine/kernels/bsdf/microfacet.h"

namespace glint {
namespace detail {

/// E at cosine mu. The table holds E over the smooth boundary's Fresnel reflectance, which hardly varies, at
/// mu = (i / (n-1))^2.
GLINT_HD inline float coatAlbedo(const MaterialData& material, float mu) {
    const float cosine = clampf(mu, 0.0f, 1.0f);
    float cosT = 0.0f;
    const float fresnel = fresnelDielectric(cosine, material.ior, &cosT);
    if (isSmooth(material)) { return fresnel; }
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

/// baseScale multiplies the base: how much of it the shadow terminator leaves.
GLINT_HD inline BsdfValue evaluatePlastic(const MaterialData& material, const PlasticChoice& choice,
                                          const Vec3& wo, const Vec3& wi, float baseScale) {
    const float leaves = (1.0f - coatAlbedo(material, wi.z)) / maxf(1.0f - material.coatAverageAlbedo, 1e-6f);
    BsdfValue result = evaluateLambert(choice.base * (choice.enters * leaves * baseScale), wi);
    result.pdfSolidAngle *= 1.0f - choice.coatProbability;
    if (!isSmooth(material)) {
        const Vec3 h = glm::normalize(wo + wi);
        float cosT = 0.0f;
        const float fresnel = fresnelDielectric(clampf(glm::dot(wo, h), 0.0f, 1.0f), material.ior, &cosT);
        result.value += Vec3(fresnel * ggxReflection(wo, wi, h, material.alpha));
        result.pdfSolidAngle += choice.coatProbability * ggxReflectionPdf(wo, h, material.alpha);
    }
    return result;
}

}  // namespace detail

struct PlasticModel : BsdfModelDefaults {
    static constexpr FeatureMask kFeatures = kFeaturePlastic;

    static GLINT_HD FeatureMask featuresOf(const MaterialData& material) {
        return kFeaturePlastic | (detail::isSmooth(material) ? 0u : kFeatureGlossy);
    }

    template <FeatureMask kMask>
    static GLINT_HD bool isSpecularOnly(const Bsdf<kMask>&) {
        return false;
    }

    template <FeatureMask kMask>
    static GLINT_HD bool hasSpecularLobe(const Bsdf<kMask>& bsdf) {
        return detail::isSmooth(*bsdf.material);
    }

    template <FeatureMask kMask>
    static GLINT_HD LobeRange visiblePointLobes(const Bsdf<kMask>& bsdf, float) {
        if (!detail::isSmooth(*bsdf.material)) { return {0.0f, 1.0f}; }
        return {choice(bsdf).coatProbability, 1.0f};
    }

    template <FeatureMask kMask>
    static GLINT_HD BsdfValue evaluate(const Bsdf<kMask>& bsdf, const Vec3& wi, float ngWi) {
        const float baseScale = detail::terminator(bsdf, ngWi, wi.z);
        if (!(wi.z > 0.0f)) { return {}; }
        return detail::evaluatePlastic(*bsdf.material, choice(bsdf), bsdf.woLocal, wi, baseScale);
    }

    template <FeatureMask kMask>
    static GLINT_HD BsdfSample sample(const Bsdf<kMask>& bsdf, float uLobe, Vec2 u) {
        const MaterialData& material = *bsdf.material;
        const Vec3& wo = bsdf.woLocal;
        const detail::PlasticChoice chosen = choice(bsdf);
        Vec3 wi;
        if (uLobe < chosen.coatProbability) {
            if (detail::isSmooth(material)) {
                // E(wo) / coatProbability, which is 0 / 0 where the coat reflects nothing.
                const float weight = (1.0f - chosen.enters) / chosen.coatProbability;
                return detail::specularSample(detail::mirrored(wo), Vec3(weight));
            }
            wi = reflect(wo, sampleVisibleNormal(wo, material.alpha, u));
        } else {
            wi = sampleCosineHemisphere(u);
        }
        if (!(wi.z > 0.0f)) { return {}; }
        const BsdfValue value =
            detail::evaluatePlastic(material, chosen, wo, wi, detail::terminatorOf(bsdf, wi));
        if (!(value.pdfSolidAngle > 0.0f)) { return {}; }
        return detail::nonDeltaSample(wi, value.value / value.pdfSolidAngle, value.pdfSolidAngle);
    }

  private:
    template <FeatureMask kMask>
    static GLINT_HD detail::PlasticChoice choice(const Bsdf<kMask>& bsdf) {
        return detail::plasticChoice(*bsdf.material, bsdf.color, bsdf.woLocal);
    }
};

}  // namespace glint
