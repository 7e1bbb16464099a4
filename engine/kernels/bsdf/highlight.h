// A diffuse surface with one highlight, as models have it that know of no Fresnel reflection: what Phong's
// (phong.h) and Ward's (ward.h) share. Host and device.
//
// A lobe is what white highlights reflect:
//   Lobe(inputs, material, wo)  seen from one direction
//   alpha()                     as wide as facets of this alpha
//   reflection(wi, room)        f |cos wi|, scaled in both directions to reflect at most `room`, which is 1
//                               or more; symmetric, but for the cosine
//   pdf(wi), sample(u)          may leave the upper half space
// The colour is the share that is reflected diffusely. Where that and the specular reflectance sum to more
// than 1 in some channel, both are scaled.
#pragma once

#include "engine/kernels/bsdf/diffuse.h"

namespace glint {
namespace detail {

/// What the diffuse part and the highlight reflect, and how the two are chosen: by what each reflects.
struct HighlightShares {
    Vec3 diffuse, specular;
    float room;                  ///< how often the highlight's reflectance there is without gaining light
    float highlightProbability;  ///< 0 where nothing is reflected

    GLINT_HD HighlightShares(const Vec3& color, const Vec3& reflectance) {
        const float scale = 1.0f / maxf(maxComponent(color + reflectance), 1.0f);
        diffuse = scale * color;
        specular = scale * reflectance;
        constexpr float kMost = 1e9f;
        room = kMost;
        for (int c = 0; c < 3; ++c) {
            room = minf(room, (1.0f - diffuse[c]) / maxf(specular[c], 1.0f / kMost));
        }
        room = maxf(room, 1.0f);
        const float ofHighlight = maxComponent(specular);
        const float sum = ofHighlight + maxComponent(diffuse);
        highlightProbability = sum > 0.0f ? ofHighlight / sum : 0.0f;
    }
};

}  // namespace detail

template <FeatureMask kMask, class Lobe>
struct HighlightModel : BsdfModelDefaults {
    static constexpr FeatureMask kFeatures = kFeatureHighlights;

    static GLINT_HD FeatureMask featuresOf(const MaterialData&) { return kFeatureHighlights; }
    static GLINT_HD bool isSpecularOnly(const Bsdf<kMask>&) { return false; }
    static GLINT_HD bool hasSpecularLobe(const Bsdf<kMask>&) { return false; }

    /// Stores where there is more than a trace of diffuse reflection, or where the highlight is not
    /// too sharp.
    static GLINT_HD LobeRange visiblePointLobes(const Bsdf<kMask>& bsdf, float storeAlpha) {
        constexpr float kTrace = 0.05f;
        const bool isBroad = sharesOf(bsdf).highlightProbability < 1.0f - kTrace;
        return isBroad || lobeOf(bsdf).alpha() >= storeAlpha ? LobeRange{0.0f, 1.0f} : LobeRange{};
    }

    static GLINT_HD Vec3 displayAlbedo(const Bsdf<kMask>& bsdf) {
        const detail::HighlightShares shares = sharesOf(bsdf);
        return shares.diffuse + shares.specular;
    }

    static GLINT_HD BsdfValue evaluate(const Bsdf<kMask>& bsdf, const Vec3& wi, float ngWi) {
        const float diffuseScale = detail::terminator(bsdf, ngWi, wi.z);
        if (!(wi.z > 0.0f)) { return {}; }
        return evaluate(sharesOf(bsdf), lobeOf(bsdf), wi, diffuseScale);
    }

    static GLINT_HD BsdfSample sample(const Bsdf<kMask>& bsdf, float uLobe, Vec2 u) {
        const detail::HighlightShares shares = sharesOf(bsdf);
        const Lobe lobe = lobeOf(bsdf);
        const Vec3 wi = uLobe < shares.highlightProbability ? lobe.sample(u) : sampleCosineHemisphere(u);
        if (!(wi.z > 0.0f)) { return {}; }
        const BsdfValue value = evaluate(shares, lobe, wi, detail::terminatorOf(bsdf, wi));
        if (!(value.pdfSolidAngle > 0.0f)) { return {}; }
        return detail::nonDeltaSample(wi, value.value / value.pdfSolidAngle, value.pdfSolidAngle);
    }

  private:
    static GLINT_HD detail::HighlightShares sharesOf(const Bsdf<kMask>& bsdf) {
        return {bsdf.color, bsdf.inputs().specularReflectance};
    }
    static GLINT_HD Lobe lobeOf(const Bsdf<kMask>& bsdf) {
        return {bsdf.inputs(), *bsdf.material, bsdf.woLocal};
    }

    /// diffuseScale: how much of diffuse reflection the shadow terminator leaves.
    static GLINT_HD BsdfValue evaluate(const detail::HighlightShares& shares, const Lobe& lobe,
                                       const Vec3& wi, float diffuseScale) {
        BsdfValue result = detail::evaluateLambert(shares.diffuse * diffuseScale, wi);
        result.pdfSolidAngle *= 1.0f - shares.highlightProbability;
        result.value += shares.specular * lobe.reflection(wi, shares.room);
        result.pdfSolidAngle += shares.highlightProbability * lobe.pdf(wi);
        return result;
    }
};

}  // namespace glint
