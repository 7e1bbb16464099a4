// Diffuse, mirror or smooth refraction by given probabilities, one colour for all. Host and device.
#pragma once

#include "engine/kernels/bsdf/dielectric.h"
#include "engine/kernels/bsdf/diffuse.h"

namespace glint {

template <FeatureMask kMask>
struct MixtureModel : BsdfModelDefaults {
    static constexpr FeatureMask kFeatures = kFeatureMixture;

    /// Weights become probabilities; without any, all is diffuse.
    static GLINT_HD void settle(const MaterialData&, const View<CoatRow>&, ShadingInputs* in) {
        const Vec3 weights = in->mixtureWeights;
        const float sum = weights.x + weights.y + weights.z;
        in->mixtureWeights = sum > 0.0f ? weights / sum : Vec3(1.0f, 0.0f, 0.0f);
    }

    static GLINT_HD FeatureMask featuresOf(const MaterialData&) { return kFeatureMixture; }

    static GLINT_HD bool isSpecularOnly(const Bsdf<kMask>& bsdf) {
        return bsdf.inputs().mixtureWeights.x <= 0.0f;
    }

    static GLINT_HD bool hasSpecularLobe(const Bsdf<kMask>&) { return true; }

    static GLINT_HD LobeRange visiblePointLobes(const Bsdf<kMask>& bsdf, float) {
        return {0.0f, bsdf.inputs().mixtureWeights.x};
    }

    static GLINT_HD bool letsStoredPhotonsThrough(const MaterialData& material, float) {
        const Vec3& weights = material.inputs.mixtureWeights;
        const bool isTextured = material.textures.mixtureWeights.index != TextureSlot::kNone;
        return isTextured || (weights.x > 0.0f && weights.z > 0.0f);
    }

    static GLINT_HD BsdfValue evaluate(const Bsdf<kMask>& bsdf, const Vec3& wi, float ngWi) {
        const float diffuse = bsdf.inputs().mixtureWeights.x;
        const BsdfValue lobe =
            detail::evaluateLambert(bsdf.color * (diffuse * detail::terminator(bsdf, ngWi, wi.z)), wi);
        return {lobe.value, lobe.pdfSolidAngle * diffuse};
    }

    static GLINT_HD BsdfSample sample(const Bsdf<kMask>& bsdf, float uLobe, Vec2 u) {
        const Vec3& probability = bsdf.inputs().mixtureWeights;
        if (uLobe < probability.x) {
            BsdfSample sample = detail::sampleLambert(bsdf, u);
            sample.pdfSolidAngle *= probability.x;
            return sample;
        }
        if (uLobe < probability.x + probability.y || !(probability.z > 0.0f)) {
            return detail::specularSample(detail::mirrored(bsdf.woLocal), bsdf.color);
        }
        const float rest = (uLobe - probability.x - probability.y) / probability.z;
        return detail::sampleSmoothDielectric(bsdf, clampf(rest, 0.0f, kOneMinusEpsilon));
    }
};

}  // namespace glint
