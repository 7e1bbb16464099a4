// Glass: a boundary between two dielectrics, smooth or with facets, and a thin sheet. Host and device.
//
// eta is the index on the far side over the one on wo's side. The colour tints what passes and what
// reflects; what glass absorbs on the way inside is glass_stack.h's. Left out: light that bounces more than
// once between facets; roughness of sheets.
#pragma once

#include "engine/kernels/bsdf/bsdf_point.h"
#include "engine/kernels/bsdf/facets.h"
#include "engine/kernels/bsdf/fresnel.h"

namespace glint {
namespace detail {

/// Where the indices differ by less than this, a rough boundary's half vectors have no digits left; light
/// passes straight.
constexpr float kLeastIndexDifference = 1e-3f;

GLINT_HD inline float radianceScale(float eta, TransportMode transport) {
    return transport == TransportMode::Radiance ? 1.0f / square(eta) : 1.0f;
}

GLINT_HD inline void markTransmission(BsdfSample* sample, float eta, TransportMode transport) {
    sample->isTransmission = true;
    sample->etaScale = transport == TransportMode::Radiance ? square(eta) : 1.0f;
}

/// Reflects with the Fresnel reflectance as its probability, else refracts.
template <FeatureMask kMask>
GLINT_HD BsdfSample sampleSmoothDielectric(const Bsdf<kMask>& bsdf, float uLobe) {
    const Vec3& wo = bsdf.woLocal;
    const float cosO = minf(wo.z, 1.0f);
    float cosT = 0.0f;
    const float fresnel = fresnelDielectric(cosO, bsdf.eta, &cosT);
    if (uLobe < fresnel) { return specularSample(mirrored(wo), bsdf.color); }
    BsdfSample sample = specularSample(Vec3(-wo.x / bsdf.eta, -wo.y / bsdf.eta, -cosT),
                                       bsdf.color * radianceScale(bsdf.eta, bsdf.transport));
    markTransmission(&sample, bsdf.eta, bsdf.transport);
    return sample;
}

/// A sheet of no thickness between like media: the two boundaries' reflections sum to 2R / (1 + R), and light
/// passes straight. `ior` is the sheet's over its surroundings' index.
GLINT_HD inline BsdfSample sampleThinDielectric(const Vec3& tint, float ior, const Vec3& wo, float uLobe) {
    float cosT = 0.0f;
    const float single = fresnelDielectric(minf(wo.z, 1.0f), ior, &cosT);
    if (uLobe < 2.0f * single / (1.0f + single)) { return specularSample(mirrored(wo), tint); }
    BsdfSample sample = specularSample(-wo, tint);
    sample.isTransmission = true;
    return sample;
}

/// Walter et al. 2007, "Microfacet Models for Refraction through Rough Surfaces", with visible normals.
/// Reflection uses the height-correlated G2; refraction the product of both G1 (their eq. 23).
template <FeatureMask kMask, class Facets>
GLINT_HD BsdfValue evaluateRoughDielectric(const Bsdf<kMask>& bsdf, const Facets& facets, const Vec3& wi) {
    if (wi.z == 0.0f) { return {}; }
    const Vec3& wo = bsdf.woLocal;
    const float eta = bsdf.eta;
    const bool reflects = wi.z > 0.0f;
    Vec3 h = glm::normalize(reflects ? wo + wi : wo + eta * wi);
    h = h.z < 0.0f ? -h : h;
    const float cosO = glm::dot(wo, h);
    if (!(cosO > 0.0f)) { return {}; }
    float cosT = 0.0f;
    const float fresnel = fresnelDielectric(minf(cosO, 1.0f), eta, &cosT);
    if (reflects) {
        return {bsdf.color * (fresnel * facets.reflection(wo, wi, h)), fresnel * facets.reflectionPdf(wo, h)};
    }
    const float cosI = glm::dot(wi, h);
    if (!(cosI < 0.0f)) { return {}; }
    const float jacobian = square(eta) * -cosI / maxf(square(cosO + eta * cosI), 1e-20f);
    const float pdf = (1.0f - fresnel) * facets.normalPdf(wo, h) * jacobian;
    return {bsdf.color * (pdf * facets.visible(-wi) * radianceScale(eta, bsdf.transport)), pdf};
}

template <FeatureMask kMask, class Facets>
GLINT_HD BsdfSample sampleRoughDielectric(const Bsdf<kMask>& bsdf, const Facets& facets, float uLobe,
                                          Vec2 u) {
    const Vec3& wo = bsdf.woLocal;
    const float eta = bsdf.eta;
    const Vec3 h = facets.sampleNormal(wo, u);
    const float cosO = clampf(glm::dot(wo, h), 0.0f, 1.0f);
    float cosT = 0.0f;
    const float fresnel = fresnelDielectric(cosO, eta, &cosT);
    if (uLobe < fresnel) {
        const Vec3 wi = reflect(wo, h);
        if (!(wi.z > 0.0f)) { return {}; }
        return nonDeltaSample(wi, bsdf.color * facets.reflectionWeight(wo, wi),
                              fresnel * facets.reflectionPdf(wo, h));
    }
    const Vec3 wi = glm::normalize(refract(wo, h, eta, cosO, cosT));
    if (!(wi.z < 0.0f)) { return {}; }
    const float jacobian = square(eta) * cosT / maxf(square(cosO - eta * cosT), 1e-20f);
    BsdfSample sample =
        nonDeltaSample(wi, bsdf.color * (facets.visible(-wi) * radianceScale(eta, bsdf.transport)),
                       (1.0f - fresnel) * facets.normalPdf(wo, h) * jacobian);
    markTransmission(&sample, eta, bsdf.transport);
    return sample;
}

}  // namespace detail

template <FeatureMask kMask>
struct DielectricModel : BsdfModelDefaults {
    static constexpr FeatureMask kFeatures = kFeatureDielectric;

    static GLINT_HD bool transmitsSampledLight(const MaterialData&) { return true; }

    static GLINT_HD void settle(const MaterialData&, const View<CoatRow>&, ShadingInputs* in) {
        if (std::fabs(in->ior - 1.0f) < detail::kLeastIndexDifference) { in->roughness = 0.0f; }
    }

    static GLINT_HD FeatureMask featuresOf(const MaterialData& material) {
        return kFeatureDielectric |
               (isThin(material) || !detail::canBeRough(material) ? FeatureMask{0} : kFeatureGlossy);
    }

    static GLINT_HD bool isSpecularOnly(const Bsdf<kMask>& bsdf) { return isSharp(bsdf); }
    static GLINT_HD bool hasSpecularLobe(const Bsdf<kMask>& bsdf) { return isSharp(bsdf); }

    static GLINT_HD LobeRange visiblePointLobes(const Bsdf<kMask>& bsdf, float storeAlpha) {
        const float alpha = detail::narrowestAlpha<kMask>(*bsdf.material, bsdf.inputs());
        return isSpecularOnly(bsdf) || alpha < storeAlpha ? LobeRange{} : LobeRange{0.0f, 1.0f};
    }

    static GLINT_HD bool letsStoredPhotonsThrough(const MaterialData& material, float storeAlpha) {
        return !isThin(material) && detail::canBeRough(material) &&
               (detail::hasRoughnessTexture(material) ||
                detail::narrowestAlpha<kMask>(material, material.inputs) >= storeAlpha);
    }

    static GLINT_HD BsdfValue evaluate(const Bsdf<kMask>& bsdf, const Vec3& wi, float) {
        if constexpr (hasFeature<kMask>(kFeatureGlossy)) {
            if (!isSharp(bsdf)) {
                return detail::withFacets(bsdf, [&](const auto& facets) {
                    return detail::evaluateRoughDielectric(bsdf, facets, wi);
                });
            }
        }
        return {};
    }

    static GLINT_HD BsdfSample sample(const Bsdf<kMask>& bsdf, float uLobe, Vec2 u) {
        const ShadingInputs& in = bsdf.inputs();
        if (isThin(*bsdf.material)) {
            return detail::sampleThinDielectric(bsdf.color, in.ior, bsdf.woLocal, uLobe);
        }
        if constexpr (hasFeature<kMask>(kFeatureGlossy)) {
            if (!detail::isSmooth(in)) {
                return detail::withFacets(bsdf, [&](const auto& facets) {
                    return detail::sampleRoughDielectric(bsdf, facets, uLobe, u);
                });
            }
        }
        return detail::sampleSmoothDielectric(bsdf, uLobe);
    }

  private:
    static GLINT_HD bool isThin(const MaterialData& material) {
        return (material.flags & kMaterialThin) != 0;
    }

    static GLINT_HD bool isSharp(const Bsdf<kMask>& bsdf) {
        return detail::isSmooth(bsdf.inputs()) || isThin(*bsdf.material);
    }
};

}  // namespace glint
