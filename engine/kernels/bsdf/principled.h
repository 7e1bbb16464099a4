// The principled model of glTF 2.0 and of Burley: principled_layers.h has its layers. Host and device.
#pragma once

#include "engine/kernels/bsdf/principled_layers.h"

namespace glint {

template <FeatureMask kMask>
struct PrincipledModel : BsdfModelDefaults {
    static constexpr FeatureMask kFeatures = kFeaturePrincipled;

    static GLINT_HD void settle(const MaterialData& material, const View<CoatRow>& coats, ShadingInputs* in) {
        constexpr float kLeastIor = 1.00001f;  // tells both sides of a body apart
        if (detail::letsLightPass<kMask>(material)) { in->ior = maxf(in->ior, kLeastIor); }
        PlasticModel<kMask>::settle(material, coats, in);
    }

    static GLINT_HD FeatureMask featuresOf(const MaterialData& material) {
        const bool transmits = (material.flags & kMaterialTransmits) != 0;
        return kFeaturePrincipled | (transmits ? kFeatureTransmission : FeatureMask{0});
    }

    static GLINT_HD bool transmitsSampledLight(const MaterialData& material) {
        return detail::letsLightPass<kMask>(material);
    }

    static GLINT_HD bool letsStoredPhotonsThrough(const MaterialData& material, float) {
        return detail::letsLightPass<kMask>(material);
    }

    static GLINT_HD bool isSpecularOnly(const Bsdf<kMask>& bsdf) {
        const ShadingInputs& in = bsdf.inputs();
        return detail::isSmooth(in) && !(scatteredShare(bsdf) > 0.0f) && isZero(in.sheenColor) &&
               !hasRoughCoat(in);
    }

    static GLINT_HD bool hasSpecularLobe(const Bsdf<kMask>& bsdf) {
        const ShadingInputs& in = bsdf.inputs();
        return detail::isSmooth(in) || (in.clearcoat > 0.0f && !hasRoughCoat(in)) ||
               (detail::letsLightPass<kMask>(*bsdf.material) &&
                std::fabs(in.ior - 1.0f) < detail::kLeastIndexDifference);
    }

    /// Stores where there is sheen or more than a trace of a diffuse base; otherwise where no rough layer is
    /// too sharp.
    static GLINT_HD LobeRange visiblePointLobes(const Bsdf<kMask>& bsdf, float storeAlpha) {
        constexpr float kMostMetallic = 0.95f;
        const ShadingInputs& in = bsdf.inputs();
        if (isSpecularOnly(bsdf)) { return {}; }
        const bool scatters = in.metallic < kMostMetallic && scatteredShare(bsdf) > 1.0f - kMostMetallic;
        const bool isBroad = scatters || !isZero(in.sheenColor);
        const bool hasSharpBase =
            !detail::isSmooth(in) && detail::narrowestAlpha<kMask>(*bsdf.material, in) < storeAlpha;
        const bool hasSharpCoat = hasRoughCoat(in) && in.clearcoatRoughness < storeAlpha;
        if (!isBroad && (hasSharpBase || hasSharpCoat)) { return {}; }
        return {detail::PrincipledLayers<kMask>(bsdf).sharpEnd(), 1.0f};
    }

    static GLINT_HD BsdfValue evaluate(const Bsdf<kMask>& bsdf, const Vec3& wi, float ngWi) {
        const float baseScale = detail::terminator(bsdf, ngWi, wi.z);
        if (!(wi.z > 0.0f) && !(wi.z < 0.0f && detail::letsLightPass<kMask>(*bsdf.material))) { return {}; }
        return detail::withFacets(bsdf, [&](const auto& base) {
            return evaluateTo(detail::PrincipledLayers<kMask>(bsdf), base, wi, baseScale);
        });
    }

    static GLINT_HD BsdfSample sample(const Bsdf<kMask>& bsdf, float uLobe, Vec2 u) {
        const detail::PrincipledLayers<kMask> layers(bsdf);
        if (uLobe < layers.mirrorProbability) {
            return detail::specularSample(detail::mirrored(layers.wo),
                                          layers.mirror / layers.mirrorProbability);
        }
        if (uLobe < layers.sharpEnd()) {
            BsdfSample sample = detail::specularSample(
                layers.passage.straight(layers.wo),
                layers.sharp * (layers.passage.radianceScale / layers.sharpProbability));
            layers.passage.mark(&sample, bsdf.transport);
            return sample;
        }
        return detail::withFacets(bsdf, [&](const auto& base) -> BsdfSample {
            const Vec3 wi = layers.sample(base, uLobe, u);
            const bool passes = detail::letsLightPass<kMask>(*bsdf.material) && wi.z < 0.0f;
            if (!(wi.z > 0.0f) && !passes) { return {}; }
            const float baseScale = passes ? 1.0f : detail::terminatorOf(bsdf, wi);
            const BsdfValue value = evaluateTo(layers, base, wi, baseScale);
            if (!(value.pdfSolidAngle > 0.0f)) { return {}; }
            BsdfSample sample =
                detail::nonDeltaSample(wi, value.value / value.pdfSolidAngle, value.pdfSolidAngle);
            if (passes) { layers.passage.mark(&sample, bsdf.transport); }
            return sample;
        });
    }

  private:
    template <class Facets>
    static GLINT_HD BsdfValue evaluateTo(const detail::PrincipledLayers<kMask>& layers, const Facets& base,
                                         const Vec3& wi, float baseScale) {
        if (detail::letsLightPass<kMask>(layers.material) && wi.z < 0.0f) {
            return layers.evaluatePassing(base, wi);
        }
        return layers.evaluate(base, wi, baseScale);
    }

    /// Of what enters, diffusely.
    static GLINT_HD float scatteredShare(const Bsdf<kMask>& bsdf) {
        const ShadingInputs& in = bsdf.inputs();
        const float notMetal = 1.0f - in.metallic;
        return detail::letsLightPass<kMask>(*bsdf.material) ? notMetal * (1.0f - in.specularTransmission)
                                                            : notMetal;
    }

    static GLINT_HD bool hasRoughCoat(const ShadingInputs& in) {
        return in.clearcoat > 0.0f && in.clearcoatRoughness >= kSmoothAlpha;
    }
};

}  // namespace glint
