// Microfacets whose roughness differs in two directions, and the Beckmann distribution, in the local frame
// whose z is the normal and whose x is the direction of the first roughness. Host and device.
//
// GGX: Heitz 2014 and 2018, "Sampling the GGX Distribution of Visible Normals". Beckmann: Beckmann and
// Spizzichino 1963; Smith's masking of it as Walter et al. 2007 and Heitz 2014, "Understanding the
// Masking-Shadowing Function in Microfacet-Based BRDFs", have it; visible normals by Heitz and d'Eon 2014,
// "Importance Sampling Microfacet-Based BSDFs using the Distribution of Visible Normals", whose distribution
// function is inverted by Newton's method in the error function of the slope, as Jakob 2014, "An Improved
// Visible Normal Sampling Routine for the Beckmann Distribution", does.
//
// All of Smith's terms are written with the area that the facets show to w, w.z (1 + Lambda(w)), which is
// w.z / G1(w): unlike either factor it is finite and has all its digits at grazing directions.
#pragma once

#include "engine/base/kinds.h"
#include "engine/kernels/bsdf/bsdf_point.h"
#include "engine/kernels/bsdf/microfacet.h"
#include "engine/math/inverse_erf.h"

namespace glint {
namespace detail {

constexpr float kInvTwoSqrtPi = 0.28209479177f;

/// The area that facets of a normal distribution of slopes with alpha 1 show to a direction at this angle, up
/// to the slope erf^-1(b) away from it. The whole: b = erf(cosine / sine).
GLINT_HD inline float beckmannShownArea(float cosine, float sine, float b, float slope) {
    return 0.5f * cosine * (1.0f + b) + kInvTwoSqrtPi * sine * std::exp(-square(slope));
}

/// A slope of alpha 1 towards a viewer at this angle from the normal, with the density of visible facets:
/// (cosine + slope sine) exp(-slope^2) where that is positive.
GLINT_HD inline float sampleBeckmannSlope(float cosine, float sine, float u) {
    // The error function of slopes away from the viewer, up to the steepest that is visible. The area is
    // concave in it: from the left, Newton's method does not overshoot, and from the right once at most.
    constexpr float kMost = 1.0f - 0x1p-24f;
    float low = -kMost;
    float high = sine > 0.0f ? minf(std::erf(cosine / sine), kMost) : kMost;
    const float whole = beckmannShownArea(cosine, sine, high, inverseErf(high));
    const float wanted = u * whole;
    // The first guess is Jakob's fit, by the angle; all of its digits do not matter.
    const float angle = std::acos(minf(cosine, 1.0f));
    const float power = 1.0f + angle * (-0.876f + angle * (0.4265f - 0.0594f * angle));
    float b = high - (1.0f + high) * std::pow(1.0f - u, power);
    float slope = 0.0f;
    for (int step = 0; step < 12; ++step) {
        b = clampf(b, low, high);
        slope = inverseErf(b);
        const float error = beckmannShownArea(cosine, sine, b, slope) - wanted;
        if (std::fabs(error) < 1e-6f * whole) { break; }
        (error > 0.0f ? high : low) = b;
        b -= error / maxf(0.5f * (cosine - slope * sine), 1e-6f);
    }
    return -slope;
}

/// A facet normal of Beckmann's distribution as seen from wo.
GLINT_HD inline Vec3 sampleBeckmannNormal(const Vec3& wo, float alphaX, float alphaY, Vec2 u) {
    const Vec3 stretched = glm::normalize(Vec3(alphaX * wo.x, alphaY * wo.y, wo.z));
    const float sine = std::sqrt(square(stretched.x) + square(stretched.y));
    const Vec2 towards = sine > 0.0f ? Vec2(stretched.x, stretched.y) / sine : Vec2(1.0f, 0.0f);
    const float slope = sampleBeckmannSlope(stretched.z, sine, u.x);
    const float aside = inverseErf(2.0f * u.y - 1.0f);
    return glm::normalize(Vec3(alphaX * (towards.x * slope - towards.y * aside),
                               alphaY * (towards.y * slope + towards.x * aside), 1.0f));
}

}  // namespace detail

/// GgxFacets (microfacet.h) with two alphas, or Beckmann's. All members mean the same.
struct GeneralFacets {
    float alphaX = 1.0f, alphaY = 1.0f;  ///< at least kSmoothAlpha
    FacetDistribution kind = FacetDistribution::Ggx;

    /// Density of facet normals by solid angle; integrates with cos to 1.
    GLINT_HD float distribution(const Vec3& h) const {
        const float slope2 = square(h.x / alphaX) + square(h.y / alphaY);
        const float z2 = square(h.z);
        const float peak = kInvPi / (alphaX * alphaY);
        if (kind == FacetDistribution::Ggx) { return peak / maxf(square(slope2 + z2), 1e-30f); }
        return peak * std::exp(-slope2 / maxf(z2, 1e-20f)) / maxf(square(z2), 1e-30f);
    }

    /// w.z (1 + Lambda(w)): the area that facets show to w, per area of the surface.
    GLINT_HD float shownArea(const Vec3& w) const {
        const float across2 = square(alphaX * w.x) + square(alphaY * w.y);
        if (kind == FacetDistribution::Ggx) { return 0.5f * (w.z + std::sqrt(square(w.z) + across2)); }
        const float across = std::sqrt(across2);
        if (!(across > 0.0f)) { return w.z; }
        const float a = w.z / across;
        return 0.5f * w.z * (1.0f + std::erf(a)) + detail::kInvTwoSqrtPi * across * std::exp(-square(a));
    }

    GLINT_HD float visible(const Vec3& w) const { return w.z / maxf(shownArea(w), 1e-20f); }

    GLINT_HD Vec3 sampleNormal(const Vec3& wo, Vec2 u) const {
        return kind == FacetDistribution::Ggx ? sampleGgxNormal(wo, alphaX, alphaY, u)
                                              : detail::sampleBeckmannNormal(wo, alphaX, alphaY, u);
    }

    GLINT_HD float normalPdf(const Vec3& wo, const Vec3& h) const {
        return distribution(h) * maxf(glm::dot(wo, h), 0.0f) / maxf(shownArea(wo), 1e-20f);
    }

    GLINT_HD float reflection(const Vec3& wo, const Vec3& wi, const Vec3& h) const {
        return 0.25f * distribution(h) * wi.z / maxf(sharedArea(wo, wi), 1e-20f);
    }

    GLINT_HD float reflectionPdf(const Vec3& wo, const Vec3& h) const {
        return 0.25f * distribution(h) / maxf(shownArea(wo), 1e-20f);
    }

    GLINT_HD float reflectionWeight(const Vec3& wo, const Vec3& wi) const {
        return wi.z * shownArea(wo) / maxf(sharedArea(wo, wi), 1e-20f);
    }

  private:
    /// wo.z wi.z / G2, which is wo.z wi.z (1 + Lambda(wo) + Lambda(wi)).
    GLINT_HD float sharedArea(const Vec3& wo, const Vec3& wi) const {
        return wi.z * shownArea(wo) + wo.z * (shownArea(wi) - wi.z);
    }
};

namespace detail {

/// Whether a point's facets are other than GGX with one alpha.
template <FeatureMask kMask>
GLINT_HD bool hasGeneralFacets(const MaterialData& material) {
    return hasFeature<kMask>(kFeatureFacets) && (material.flags & kMaterialFacets) != 0;
}

/// visit(facets) with those of a point that is not smooth.
template <FeatureMask kMask, class Visit>
GLINT_HD auto withFacets(const Bsdf<kMask>& bsdf, Visit&& visit) {
    const ShadingInputs& in = bsdf.inputs();
    if constexpr (hasFeature<kMask>(kFeatureFacets)) {
        if (hasGeneralFacets<kMask>(*bsdf.material)) {
            return visit(GeneralFacets{in.roughness, in.crossRoughness, bsdf.material->distribution});
        }
    }
    return visit(GgxFacets{in.roughness});
}

/// Makes the two alphas such that both are smooth or neither is.
GLINT_HD inline void settleFacets(ShadingInputs* in) {
    if (in->crossRoughness < 0.0f) { in->crossRoughness = in->roughness; }
    if (maxf(in->roughness, in->crossRoughness) >= kSmoothAlpha) {
        in->roughness = maxf(in->roughness, kSmoothAlpha);
        in->crossRoughness = maxf(in->crossRoughness, kSmoothAlpha);
    }
}

/// The alpha of the direction in which a lobe is narrowest.
template <FeatureMask kMask>
GLINT_HD float narrowestAlpha(const MaterialData& material, const ShadingInputs& in) {
    return hasGeneralFacets<kMask>(material) ? minf(in.roughness, in.crossRoughness) : in.roughness;
}

}  // namespace detail
}  // namespace glint
