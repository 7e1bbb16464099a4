// A metal under a dielectric coat, each smooth or with facets, between which the coat absorbs. Host
// and device.
//
// Weidlich and Wilkie 2007, "Arbitrarily Layered Micro-Facet Surfaces", as Mitsuba's coatings compute it:
// light is refracted into the coat by its normal, reflected by the metal there, and refracted out again. With
// E, the share that the coat reflects, w' = refracted w, index n, and a, the optical depth straight through
// the coat,
//     f = coat + metal(wo', wi') (1 - E(wo)) (1 - E(wi)) / n^2 exp(-a / cos wo' - a / cos wi').
// What the coat's underside reflects is lost: a few per cent, and more where the metal is rough. The coat's
// facets are GGX; light that enters through them is not broadened.
#pragma once

#include <glm/exponential.hpp>

#include "engine/kernels/bsdf/conductor.h"
#include "engine/kernels/bsdf/principled_layers.h"

namespace glint {
namespace detail {

/// Both layers as seen from one wo, and the probabilities of their lobes, by the light each reflects. What
/// both reflect sharply shares one direction and so one lobe.
template <FeatureMask kMask>
struct CoatedLayers {
    const ShadingInputs& in;
    const Vec3& color;
    const Vec3& wo;
    bool hasSmoothCoat, hasSmoothMetal;
    Vec3 woInside;
    float enters;  ///< 1 - E(wo)
    Vec3 mirror{0.0f};
    float mirrorProbability = 0.0f, coatProbability = 0.0f, metalProbability = 0.0f;

    explicit GLINT_HD CoatedLayers(const Bsdf<kMask>& bsdf)
        : in(bsdf.inputs()), color(bsdf.color), wo(bsdf.woLocal) {
        hasSmoothCoat = in.clearcoatRoughness < kSmoothAlpha;
        hasSmoothMetal = isSmooth(in);
        woInside = inside(wo);
        enters = 1.0f - coatReflectance(wo.z);
        const Vec3 metal =
            enters * enters * metalFresnel(woInside.z) * color * leftInside(woInside, woInside);
        if (hasSmoothCoat) { mirror += Vec3(1.0f - enters); }
        if (hasSmoothMetal) { mirror += metal; }
        const float ofMirror = maxComponent(mirror);
        const float ofCoat = hasSmoothCoat ? 0.0f : 1.0f - enters;
        const float ofMetal = hasSmoothMetal ? 0.0f : maxComponent(metal);
        const float sum = ofMirror + ofCoat + ofMetal;
        if (!(sum > 0.0f)) { return; }
        mirrorProbability = ofMirror / sum;
        coatProbability = ofCoat / sum;
        metalProbability = ofMetal / sum;
    }

    /// Of the lobes with a density. `facets`: the metal's.
    template <class Facets>
    GLINT_HD BsdfValue evaluate(const Facets& facets, const Vec3& wi) const {
        BsdfValue result;
        if (!hasSmoothCoat) {
            const Vec3 h = glm::normalize(wo + wi);
            float cosT = 0.0f;
            const float fresnel = fresnelDielectric(clampf(glm::dot(wo, h), 0.0f, 1.0f), in.ior, &cosT);
            const GgxFacets coat{in.clearcoatRoughness};
            result.value += Vec3(fresnel * coat.reflection(wo, wi, h));
            result.pdfSolidAngle += coatProbability * coat.reflectionPdf(wo, h);
        }
        if (!hasSmoothMetal) {
            const Vec3 wiInside = inside(wi);
            const Vec3 h = glm::normalize(woInside + wiInside);
            const Vec3 fresnel = metalFresnel(clampf(glm::dot(woInside, h), 0.0f, 1.0f));
            // Per solid angle outside.
            const float wider = wi.z / (square(in.ior) * wiInside.z);
            const float passes = enters * (1.0f - coatReflectance(wi.z)) * wider;
            result.value += color * fresnel * leftInside(woInside, wiInside) *
                            (passes * facets.reflection(woInside, wiInside, h));
            result.pdfSolidAngle += metalProbability * wider * facets.reflectionPdf(woInside, h);
        }
        return result;
    }

    /// A direction of a lobe with a density; uLobe from mirrorProbability on. wi.z is not positive where the
    /// coat lets nothing out.
    template <class Facets>
    GLINT_HD Vec3 sample(const Facets& facets, float uLobe, Vec2 u) const {
        if (uLobe < mirrorProbability + coatProbability) {
            return reflect(wo, GgxFacets{in.clearcoatRoughness}.sampleNormal(wo, u));
        }
        const Vec3 wiInside = reflect(woInside, facets.sampleNormal(woInside, u));
        const Vec3 out = wiInside * in.ior;
        const float cosine2 = 1.0f - square(in.ior) + square(out.z);
        return {out.x, out.y, wiInside.z > 0.0f ? safeSqrt(cosine2) : 0.0f};
    }

  private:
    GLINT_HD Vec3 inside(const Vec3& w) const {
        // By z and not by x and y, which leave no digits of it at grazing incidence.
        const float cosine2 = (square(in.ior) - 1.0f + square(w.z)) / square(in.ior);
        constexpr float kLeast = 1e-8f;
        return {w.x / in.ior, w.y / in.ior, std::sqrt(maxf(cosine2, kLeast))};
    }

    GLINT_HD float coatReflectance(float cosine) const {
        return coatAlbedoFit(in.clearcoatRoughness, clampf(cosine, 0.0f, 1.0f), in.ior);
    }

    GLINT_HD Vec3 metalFresnel(float cosine) const {
        return fresnelConductor(minf(cosine, 1.0f), in.eta, in.k);
    }

    /// Of light along both directions inside.
    GLINT_HD Vec3 leftInside(const Vec3& a, const Vec3& b) const {
        return isZero(in.coatAbsorption) ? Vec3(1.0f)
                                         : glm::exp(-in.coatAbsorption * (1.0f / a.z + 1.0f / b.z));
    }
};

}  // namespace detail

template <FeatureMask kMask>
struct CoatedModel : BsdfModelDefaults {
    static constexpr FeatureMask kFeatures = kFeatureCoated;

    static GLINT_HD FeatureMask featuresOf(const MaterialData&) { return kFeatureCoated; }
    static GLINT_HD bool isSpecularOnly(const Bsdf<kMask>& bsdf) {
        return detail::isSmooth(bsdf.inputs()) && bsdf.inputs().clearcoatRoughness < kSmoothAlpha;
    }
    static GLINT_HD bool hasSpecularLobe(const Bsdf<kMask>& bsdf) {
        return detail::isSmooth(bsdf.inputs()) || bsdf.inputs().clearcoatRoughness < kSmoothAlpha;
    }

    /// Stores where no rough layer is too sharp.
    static GLINT_HD LobeRange visiblePointLobes(const Bsdf<kMask>& bsdf, float storeAlpha) {
        const ShadingInputs& in = bsdf.inputs();
        const bool isSharpMetal =
            !detail::isSmooth(in) && detail::narrowestAlpha<kMask>(*bsdf.material, in) < storeAlpha;
        const bool isSharpCoat = in.clearcoatRoughness >= kSmoothAlpha && in.clearcoatRoughness < storeAlpha;
        if (isSpecularOnly(bsdf) || isSharpMetal || isSharpCoat) { return {}; }
        return {detail::CoatedLayers<kMask>(bsdf).mirrorProbability, 1.0f};
    }

    /// The metal's reflectance at normal incidence.
    static GLINT_HD Vec3 displayAlbedo(const Bsdf<kMask>& bsdf) {
        return ConductorModel<kMask>::displayAlbedo(bsdf);
    }

    static GLINT_HD BsdfValue evaluate(const Bsdf<kMask>& bsdf, const Vec3& wi, float) {
        if (!(wi.z > 0.0f)) { return {}; }
        return detail::withFacets(
            bsdf, [&](const auto& facets) { return detail::CoatedLayers<kMask>(bsdf).evaluate(facets, wi); });
    }

    static GLINT_HD BsdfSample sample(const Bsdf<kMask>& bsdf, float uLobe, Vec2 u) {
        const detail::CoatedLayers<kMask> layers(bsdf);
        if (uLobe < layers.mirrorProbability) {
            return detail::specularSample(detail::mirrored(layers.wo),
                                          layers.mirror / layers.mirrorProbability);
        }
        return detail::withFacets(bsdf, [&](const auto& facets) -> BsdfSample {
            const Vec3 wi = layers.sample(facets, uLobe, u);
            if (!(wi.z > 0.0f)) { return {}; }
            const BsdfValue value = layers.evaluate(facets, wi);
            if (!(value.pdfSolidAngle > 0.0f)) { return {}; }
            return detail::nonDeltaSample(wi, value.value / value.pdfSolidAngle, value.pdfSolidAngle);
        });
    }
};

}  // namespace glint
