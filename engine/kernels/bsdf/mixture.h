// Diffuse, mirror or smooth refraction by given probabilities, one colour for all. Host and device.
#pragma once

#include "engine/kernels/bsdf/dielectric.h"
#include "engine/kernels/bsdf/diffuse.h"

namespace glint {

struct MixtureModel : BsdfModelDefaults {
    static constexpr FeatureMask kFeatures = kFeatureMixture;

    static GLINT_HD FeatureMask featuresOf(const MaterialData&) { return kFeatureMixture; }

    template <FeatureMask kMask>
    static GLINT_HD bool isSpecularOnly(const Bsdf<kMask>& bsdf) {
        return bsdf.material->mixtureProbability.x <= 0.0f;
    }

    template <FeatureMask kMask>
    static GLINT_HD bool hasSpecularLobe(const Bsdf<kMask>&) {
        return true;
    }

    template <FeatureMask kMask>
    static GLINT_HD LobeRange visiblePointLobes(const Bsdf<kMask>& bsdf, float) {
        return {0.0f, bsdf.material->mixtureProbability.x};
    }

    template <FeatureMask kMask>
    static GLINT_HD BsdfValue evaluate(const Bsdf<kMask>& bsdf, const Vec3& wi, float ngWi) {
        const float diffuse = bsdf.material->mixtureProbability.x;
        const BsdfValue lobe =
            detail::evaluateLambert(bsdf.color * (diffuse * detail::terminator(bsdf, ngWi, wi.z)), wi);
        return {lobe.value, lobe.pdfSolidAngle * diffuse};
    }

    template <FeatureMask kMask>
    static GLINT_HD BsdfSample sample(const Bsdf<kMask>& bsdf, float uLobe, Vec2 u) {
        const Vec3& probability = bsdf.material->mixtureProbability;
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
