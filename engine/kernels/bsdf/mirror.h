// Perfect reflection tinted by the colour. Host and device.
#pragma once

#include "engine/kernels/bsdf/bsdf_point.h"

namespace glint {

template <FeatureMask kMask>
struct MirrorModel : BsdfModelDefaults {
    static constexpr FeatureMask kFeatures = kFeatureSpecular;
    static GLINT_HD FeatureMask featuresOf(const MaterialData&) { return kFeatureSpecular; }
    static GLINT_HD bool isSpecularOnly(const Bsdf<kMask>&) { return true; }
    static GLINT_HD bool hasSpecularLobe(const Bsdf<kMask>&) { return true; }
    static GLINT_HD LobeRange visiblePointLobes(const Bsdf<kMask>&, float) { return {}; }
    static GLINT_HD BsdfValue evaluate(const Bsdf<kMask>&, const Vec3&, float) { return {}; }

    static GLINT_HD BsdfSample sample(const Bsdf<kMask>& bsdf, float, Vec2) {
        return detail::specularSample(detail::mirrored(bsdf.woLocal), bsdf.color);
    }
};

}  // namespace glint
