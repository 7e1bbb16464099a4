// Lambert's law, and the shadow terminator that diffuse lobes of all models share. Host and device.
#pragma once

#include "engine/kernels/bsdf/bsdf_point.h"

namespace glint {

/// Where a smooth normal ns turns away from the light later than the geometric normal ng, shadow rays cut the
/// shading off along the facets. This factor fades diffuse reflection out softly before: Chiang, Li and
/// Burley 2019, "Taming the Shadow Terminator". 1 where ns = ng. Arguments: the cosines between the three.
GLINT_HD inline float shadowTerminator(float ngWi, float nsWi, float ngNs) {
    const float g = clampf(ngWi / maxf(nsWi * ngNs, 1e-20f), 0.0f, 1.0f);
    return g * (1.0f + g * (1.0f - g));
}

namespace detail {

/// How much the shadow terminator leaves of diffuse reflection. Arguments: wi's cosines with both normals.
template <FeatureMask kMask>
GLINT_HD float terminator(const Bsdf<kMask>& bsdf, float ngWi, float nsWi) {
    return hasFeature<kMask>(kFeatureShadingNormals) ? shadowTerminator(ngWi, nsWi, bsdf.ngNs) : 1.0f;
}

template <FeatureMask kMask>
GLINT_HD float terminatorOf(const Bsdf<kMask>& bsdf, const Vec3& wiLocal) {
    const float ngWi = geometricCosine(bsdf, frameOf(bsdf).toWorld(wiLocal), wiLocal.z);
    return terminator(bsdf, ngWi, wiLocal.z);
}

GLINT_HD inline BsdfValue evaluateLambert(const Vec3& color, const Vec3& wi) {
    const float pdf = maxf(wi.z, 0.0f) * kInvPi;
    return {color * pdf, pdf};
}

template <FeatureMask kMask>
GLINT_HD BsdfSample sampleLambert(const Bsdf<kMask>& bsdf, Vec2 u) {
    const Vec3 wi = sampleCosineHemisphere(u);
    BsdfSample sample = nonDeltaSample(wi, bsdf.color, wi.z * kInvPi);
    sample.weight *= terminatorOf(bsdf, wi);
    return sample;
}

}  // namespace detail

template <FeatureMask kMask>
struct DiffuseModel : BsdfModelDefaults {
    static constexpr FeatureMask kFeatures = kFeatureDiffuse;
    static constexpr bool kPhotonsLeaveAboutNg = true;

    static GLINT_HD FeatureMask featuresOf(const MaterialData&) { return kFeatureDiffuse; }
    static GLINT_HD bool isSpecularOnly(const Bsdf<kMask>&) { return false; }
    static GLINT_HD bool hasSpecularLobe(const Bsdf<kMask>&) { return false; }
    static GLINT_HD LobeRange visiblePointLobes(const Bsdf<kMask>&, float) { return {0.0f, 1.0f}; }

    static GLINT_HD BsdfValue evaluate(const Bsdf<kMask>& bsdf, const Vec3& wi, float ngWi) {
        return detail::evaluateLambert(bsdf.color * detail::terminator(bsdf, ngWi, wi.z), wi);
    }

    static GLINT_HD BsdfSample sample(const Bsdf<kMask>& bsdf, float, Vec2 u) {
        return detail::sampleLambert(bsdf, u);
    }
};

}  // namespace glint
