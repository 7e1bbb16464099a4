// A sheet of no thickness that scatters light diffusely to both sides: a leaf, paper, a lampshade. Host
// and device.
//
// The colour is what it reflects, the transmission what it lets through, on both sides alike. What both would
// make of more than all light is not let through.
#pragma once

#include "engine/kernels/bsdf/diffuse.h"

namespace glint {

template <FeatureMask kMask>
struct TranslucentModel : BsdfModelDefaults {
    static constexpr FeatureMask kFeatures = kFeatureTranslucent;
    static constexpr bool kPhotonsLeaveAboutNg = true;

    static GLINT_HD bool transmitsSampledLight(const MaterialData&) { return true; }
    static GLINT_HD FeatureMask featuresOf(const MaterialData&) { return kFeatureTranslucent; }
    static GLINT_HD bool isSpecularOnly(const Bsdf<kMask>&) { return false; }
    static GLINT_HD bool hasSpecularLobe(const Bsdf<kMask>&) { return false; }
    static GLINT_HD LobeRange visiblePointLobes(const Bsdf<kMask>&, float) { return {0.0f, 1.0f}; }

    static GLINT_HD bool letsStoredPhotonsThrough(const MaterialData& material, float) {
        return material.textures.transmission.index != TextureSlot::kNone ||
               !isZero(material.inputs.transmission);
    }

    static GLINT_HD BsdfValue evaluate(const Bsdf<kMask>& bsdf, const Vec3& wi, float ngWi) {
        const bool reflects = wi.z > 0.0f;
        const float nsWi = std::fabs(wi.z),
                    share = reflects ? reflectedShare(bsdf) : 1.0f - reflectedShare(bsdf);
        const Vec3 color = reflects ? bsdf.color : transmitted(bsdf);
        return {color * (nsWi * kInvPi * detail::terminator(bsdf, std::fabs(ngWi), nsWi)),
                nsWi * kInvPi * share};
    }

    static GLINT_HD BsdfSample sample(const Bsdf<kMask>& bsdf, float uLobe, Vec2 u) {
        const float reflected = reflectedShare(bsdf);
        const bool reflects = uLobe < reflected;
        const float share = reflects ? reflected : 1.0f - reflected;
        Vec3 wi = sampleCosineHemisphere(u);
        const float cosine = wi.z;
        wi.z = reflects ? cosine : -cosine;
        const float ngWi = std::fabs(detail::geometricCosine(bsdf, bsdf.frame.toWorld(wi), wi.z));
        BsdfSample sample = detail::nonDeltaSample(
            wi, (reflects ? bsdf.color : transmitted(bsdf)) * (1.0f / share), cosine * kInvPi * share);
        sample.weight *= detail::terminator(bsdf, ngWi, cosine);
        sample.isTransmission = !reflects;
        return sample;
    }

    static GLINT_HD Vec3 displayAlbedo(const Bsdf<kMask>& bsdf) { return bsdf.color + transmitted(bsdf); }

  private:
    static GLINT_HD Vec3 transmitted(const Bsdf<kMask>& bsdf) {
        return glm::min(bsdf.inputs().transmission, Vec3(1.0f) - bsdf.color);
    }

    /// Of all samples. A black sheet's reflect nothing.
    static GLINT_HD float reflectedShare(const Bsdf<kMask>& bsdf) {
        const float reflected = maxComponent(bsdf.color);
        const float sum = reflected + maxComponent(transmitted(bsdf));
        return sum > 0.0f ? reflected / sum : 1.0f;
    }
};

}  // namespace glint
