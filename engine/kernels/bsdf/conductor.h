// Metal: Fresnel reflection times the colour, smooth or with facets. Host and device.
#pragma once

#include "engine/kernels/bsdf/bsdf_point.h"
#include "engine/kernels/bsdf/facets.h"
#include "engine/kernels/bsdf/fresnel.h"

namespace glint {

template <FeatureMask kMask>
struct ConductorModel : BsdfModelDefaults {
    static constexpr FeatureMask kFeatures = kFeatureSpecular | kFeatureGlossy;

    static GLINT_HD FeatureMask featuresOf(const MaterialData& material) {
        return (detail::canBeSmooth(material) ? kFeatureSpecular : FeatureMask{0}) |
               (detail::canBeRough(material) ? kFeatureGlossy : FeatureMask{0});
    }

    static GLINT_HD bool isSpecularOnly(const Bsdf<kMask>& bsdf) { return detail::isSmooth(bsdf.inputs()); }
    static GLINT_HD bool hasSpecularLobe(const Bsdf<kMask>& bsdf) { return detail::isSmooth(bsdf.inputs()); }

    static GLINT_HD LobeRange visiblePointLobes(const Bsdf<kMask>& bsdf, float storeAlpha) {
        const float alpha = detail::narrowestAlpha<kMask>(*bsdf.material, bsdf.inputs());
        return isSpecularOnly(bsdf) || alpha < storeAlpha ? LobeRange{} : LobeRange{0.0f, 1.0f};
    }

    /// The reflectance at normal incidence.
    static GLINT_HD Vec3 displayAlbedo(const Bsdf<kMask>& bsdf) {
        return bsdf.color * fresnelConductor(1.0f, bsdf.inputs().eta, bsdf.inputs().k);
    }

    static GLINT_HD BsdfValue evaluate(const Bsdf<kMask>& bsdf, const Vec3& wi, float) {
        if constexpr (hasFeature<kMask>(kFeatureGlossy)) {
            const ShadingInputs& in = bsdf.inputs();
            const Vec3& wo = bsdf.woLocal;
            if (detail::isSmooth(in) || !(wi.z > 0.0f)) { return {}; }
            const Vec3 h = glm::normalize(wo + wi);
            const Vec3 fresnel = fresnelConductor(clampf(glm::dot(wo, h), 0.0f, 1.0f), in.eta, in.k);
            return detail::withFacets(bsdf, [&](const auto& facets) {
                return BsdfValue{bsdf.color * fresnel * facets.reflection(wo, wi, h),
                                 facets.reflectionPdf(wo, h)};
            });
        }
        return {};
    }

    static GLINT_HD BsdfSample sample(const Bsdf<kMask>& bsdf, float, Vec2 u) {
        if constexpr (hasFeature<kMask>(kFeatureGlossy)) {
            if (!detail::isSmooth(bsdf.inputs())) { return sampleRough(bsdf, u); }
        }
        if constexpr (hasFeature<kMask>(kFeatureSpecular)) {
            const Vec3 fresnel =
                fresnelConductor(minf(bsdf.woLocal.z, 1.0f), bsdf.inputs().eta, bsdf.inputs().k);
            return detail::specularSample(detail::mirrored(bsdf.woLocal), bsdf.color * fresnel);
        }
        return {};
    }

  private:
    static GLINT_HD BsdfSample sampleRough(const Bsdf<kMask>& bsdf, Vec2 u) {
        const ShadingInputs& in = bsdf.inputs();
        const Vec3& wo = bsdf.woLocal;
        return detail::withFacets(bsdf, [&](const auto& facets) -> BsdfSample {
            const Vec3 h = facets.sampleNormal(wo, u);
            const Vec3 wi = reflect(wo, h);
            if (!(wi.z > 0.0f)) { return {}; }
            const Vec3 fresnel = fresnelConductor(clampf(glm::dot(wo, h), 0.0f, 1.0f), in.eta, in.k);
            return detail::nonDeltaSample(wi, bsdf.color * fresnel * facets.reflectionWeight(wo, wi),
                                          facets.reflectionPdf(wo, h));
        });
    }
};

}  // namespace glint
