// The layers of the principled model of glTF 2.0 and of Burley: a clear coat over sheen over a base between
// plastic and metal. Host and device.
//
// Burley 2012, "Physically-Based Shading at Disney"; Khronos Group 2021, "glTF 2.0 Specification",
// appendix B, with KHR_materials_specular, _clearcoat and _sheen. The base mixes, by `metallic`, a metal
// whose reflectance is the colour (Schlick 1994) and a dielectric, which scatters diffusely what its boundary
// does not reflect; both share one lobe of facets. Sheen has the distribution of Estevez and Kulla 2017,
// "Production Friendly Microfacet Sheen BRDF", and glTF's visibility. The coat is a GGX boundary of
// index 1.5.
//
// What lies under a layer gets what the layer's directional albedo leaves, at the more grazing of both
// directions: it is reciprocal, and no angle gains more light than 0.4 % (0.8 % where the base is
// anisotropic: plastic.h). The diffuse part is coupled as plastic.h's, but light does not go back and forth
// under the boundary. What lets light pass is in principled_transmission.h. Left out: a coat with a normal of
// its own, light that bounces more than once between facets.
#pragma once

#include <glm/common.hpp>

#include "engine/kernels/bsdf/plastic.h"
#include "engine/kernels/bsdf/principled_transmission.h"

namespace glint {
namespace detail {

constexpr float kClearCoatIor = 1.5f;

/// At least the albedo of a coat of index 1.5, to 0.003: what a smooth one reflects at a less grazing
/// angle. A fit of ours to roughCoatAlbedo(). Of other indices it is right for smooth coats, and near for
/// rough ones.
GLINT_HD inline float coatAlbedoFit(float alpha, float mu, float ior) {
    const float width = alpha * std::sqrt(alpha);
    const float cosine = minf(mu + 0.488f * width / (width + 0.09f) * square(square(1.0f - mu)), 1.0f);
    float cosT = 0.0f;
    return fresnelDielectric(cosine, ior, &cosT);
}

/// Narrower sheen is as this one.
constexpr float kLeastSheenAlpha = 0.05f;

/// At least the albedo of white sheen, to 0.003, alpha from kLeastSheenAlpha on; above 1 where glTF's sheen
/// gains light. A fit of ours.
GLINT_HD inline float sheenAlbedo(float alpha, float mu) {
    const float s = 1.0f / std::sqrt(alpha);
    return (0.32f + 0.345f * s) * std::exp((0.63f - 1.25f * s) * mu - 0.75f * std::sqrt(mu));
}

/// White sheen, f |cos wi|, where `albedo` is that at the more grazing of both directions.
GLINT_HD inline float evaluateSheen(float alpha, float albedo, const Vec3& wo, const Vec3& wi,
                                    const Vec3& h) {
    const float sine2 = minf(square(h.x) + square(h.y), 1.0f);
    const float distribution = (2.0f + 1.0f / alpha) * (0.5f * kInvPi) * std::pow(sine2, 0.5f / alpha);
    const float visible = wi.z / (4.0f * maxf(wo.z + wi.z - wo.z * wi.z, 1e-20f));
    return distribution * visible / maxf(albedo, 1.0f);
}

/// A dielectric under a tint, of index `eta` behind over before the boundary.
GLINT_HD inline Vec3 tintedFresnel(const ShadingInputs& in, float cosine, float eta) {
    float cosT = 0.0f;
    const float fresnel = fresnelDielectric(cosine, eta, &cosT);
    const float headOn = square((in.ior - 1.0f) / (in.ior + 1.0f));
    // The share that no tint colours: 0 head on, 1 at grazing incidence.
    const float grazing = maxf((fresnel - headOn) / (1.0f - headOn), 0.0f);
    return in.specular * (in.specularTint * (fresnel - grazing) + grazing);
}

/// Schlick's metal of reflectance `color` and a dielectric under a tint, mixed.
GLINT_HD inline Vec3 principledFresnel(const ShadingInputs& in, const Vec3& color, float cosine,
                                       const PrincipledPassage& passage) {
    Vec3 dielectric = tintedFresnel(in, cosine, in.ior);
    if (passage.isInside) {
        dielectric = glm::mix(dielectric, tintedFresnel(in, cosine, passage.eta), in.specularTransmission);
    }
    const float rest = 1.0f - cosine;
    const Vec3 metal = color + (Vec3(1.0f) - color) * (square(square(rest)) * rest);
    return (1.0f - in.metallic) * dielectric + in.metallic * metal;
}

/// The layers as seen from one wo, and the probabilities of their lobes, which sum to 1: by the light each
/// reflects. Smooth layers share one direction and so one lobe, the mirror; what passes sharply is another.
/// What passes facets shares the base's lobe: a facet is chosen first, and then what it does.
template <FeatureMask kMask>
struct PrincipledLayers {
    const MaterialData& material;
    const ShadingInputs& in;
    const Vec3& color;
    const Vec3& wo;
    PrincipledPassage passage;
    bool hasSmoothCoat, hasRoughCoat, hasSmoothBase;
    float sheenAlpha, sheen;  ///< sheen: its largest channel
    float enters;             ///< the share of light that the dielectric's boundary lets in
    float scatters;           ///< the share of that which is scattered diffusely
    Vec3 mirror{0.0f};        ///< what the smooth layers reflect
    Vec3 sharp{0.0f};         ///< what passes sharply
    float mirrorProbability = 0.0f, sharpProbability = 0.0f;
    float coatProbability = 0.0f, baseProbability = 0.0f;
    float diffuseProbability = 1.0f, sheenProbability = 0.0f;

    explicit GLINT_HD PrincipledLayers(const Bsdf<kMask>& bsdf)
        : material(*bsdf.material),
          in(bsdf.inputs()),
          color(bsdf.color),
          wo(bsdf.woLocal),
          passage(PrincipledPassage::of(bsdf)) {
        const bool hasCoat = in.clearcoat > 0.0f && !passage.isInside;
        hasSmoothCoat = hasCoat && in.clearcoatRoughness < kSmoothAlpha;
        hasRoughCoat = hasCoat && !hasSmoothCoat;
        hasSmoothBase = isSmooth(in);
        sheen = passage.isInside ? 0.0f : maxComponent(in.sheenColor);
        scatters = 1.0f - in.metallic;
        if (letsLightPass<kMask>(material)) { scatters *= 1.0f - in.specularTransmission; }
        sheenAlpha = maxf(in.sheenRoughness, kLeastSheenAlpha);
        enters = 1.0f - in.specular * coatAlbedo<kMask>(material, in, wo);
        setProbabilities(clampf(wo.z, 0.0f, 1.0f));
    }

    /// What the coat leaves to the layers below.
    GLINT_HD float belowCoat(float mu) const {
        return in.clearcoat > 0.0f
                   ? 1.0f - in.clearcoat * coatAlbedoFit(in.clearcoatRoughness, mu, kClearCoatIor)
                   : 1.0f;
    }

    /// Of all lobes with a density. `base`: the base's facets. baseScale multiplies sheen and diffuse
    /// reflection: how much of them the shadow terminator leaves.
    template <class Facets>
    GLINT_HD BsdfValue evaluate(const Facets& base, const Vec3& wi, float baseScale) const {
        const Vec3 h = glm::normalize(wo + wi);
        const float cosine = clampf(glm::dot(wo, h), 0.0f, 1.0f);
        const float mu = clampf(minf(wo.z, wi.z), 0.0f, 1.0f);
        BsdfValue result;
        float below = passage.isInside ? 1.0f : belowCoat(mu);
        if (hasRoughCoat) {
            float cosT = 0.0f;
            const float fresnel = in.clearcoat * fresnelDielectric(cosine, kClearCoatIor, &cosT);
            const GgxFacets coat{in.clearcoatRoughness};
            result.value += Vec3(fresnel * coat.reflection(wo, wi, h));
            result.pdfSolidAngle += coatProbability * coat.reflectionPdf(wo, h);
        }
        if (sheen > 0.0f) {
            const float albedo = sheenAlbedo(sheenAlpha, mu);
            const float lobe = evaluateSheen(sheenAlpha, albedo, wo, wi, h);
            result.value += in.sheenColor * (below * baseScale * lobe);
            result.pdfSolidAngle += sheenProbability * (0.5f * kInvPi);
            below *= 1.0f - sheen * minf(albedo, 1.0f);
        }
        if (!hasSmoothBase) {
            const float lobe = below * base.reflection(wo, wi, h);
            result.value += principledFresnel(in, color, cosine, passage) * lobe;
            result.pdfSolidAngle += baseProbability * reflectProbability(cosine) * base.reflectionPdf(wo, h);
        }
        if (!(scatters > 0.0f)) { return result; }
        const float leaves = (1.0f - in.specular * coatAlbedo<kMask>(material, in, wi)) /
                             maxf(1.0f - in.specular * in.coat.averageAlbedo, 1e-6f);
        const BsdfValue diffuse =
            evaluateLambert(color * (scatters * below * enters * leaves * baseScale), wi);
        result.value += diffuse.value;
        result.pdfSolidAngle += diffuseProbability * diffuse.pdfSolidAngle;
        return result;
    }

    /// Of what passes to wi, wi.z < 0.
    template <class Facets>
    GLINT_HD BsdfValue evaluatePassing(const Facets& base, const Vec3& wi) const {
        if (!(passage.share > 0.0f) || passage.isSharp) { return {}; }
        const Vec3 h = passage.facetTowards(wo, wi);
        if (isZero(h)) { return {}; }
        const float cosine = clampf(glm::dot(wo, h), 0.0f, 1.0f);
        const BsdfValue all = passage.through(base, wo, wi, h);
        const float left =
            passage.enters(in, cosine) * passage.share * leftBelow(passage.layerCosine(wo, wi));
        return {all.value * passage.tint * left,
                baseProbability * (1.0f - reflectProbability(cosine)) * all.pdfSolidAngle};
    }

    /// A direction of a lobe with a density; uLobe from sharpEnd() on. Zero: facets sent it to the
    /// other side.
    template <class Facets>
    GLINT_HD Vec3 sample(const Facets& base, float uLobe, Vec2 u) const {
        const Vec3 nowhere(0.0f);
        float u1 = uLobe - sharpEnd();
        if (u1 < coatProbability) {
            const Vec3 wi = reflect(wo, GgxFacets{in.clearcoatRoughness}.sampleNormal(wo, u));
            return wi.z > 0.0f ? wi : nowhere;
        }
        u1 -= coatProbability;
        if (u1 < baseProbability) {
            const Vec3 h = base.sampleNormal(wo, u);
            const float cosine = clampf(glm::dot(wo, h), 0.0f, 1.0f);
            const bool reflects = u1 < baseProbability * reflectProbability(cosine);
            const Vec3 wi = reflects ? reflect(wo, h) : passage.past(wo, h);
            return (reflects ? wi.z > 0.0f : wi.z < 0.0f) ? wi : nowhere;
        }
        if (u1 - baseProbability < diffuseProbability) { return sampleCosineHemisphere(u); }
        const Vec3 wi = sampleSphere(u);
        return {wi.x, wi.y, std::fabs(wi.z)};
    }

    /// Values of uLobe below choose what has no density.
    GLINT_HD float sharpEnd() const { return mirrorProbability + sharpProbability; }

  private:
    /// What coat and sheen leave of light that passes.
    GLINT_HD float leftBelow(float mu) const {
        return belowCoat(mu) * (1.0f - maxComponent(in.sheenColor) * minf(sheenAlbedo(sheenAlpha, mu), 1.0f));
    }

    /// Of a facet of the base that was chosen, at which wo has this cosine.
    GLINT_HD float reflectProbability(float cosine) const {
        if (!(passage.share > 0.0f) || passage.isSharp) { return 1.0f; }
        const float reflected = maxComponent(principledFresnel(in, color, cosine, passage));
        const float passes = passage.share * passage.enters(in, cosine) * maxComponent(passage.tint);
        return reflected + passes > 0.0f ? reflected / (reflected + passes) : 1.0f;
    }

    GLINT_HD void setProbabilities(float mu) {
        const bool hasCoat = hasSmoothCoat || hasRoughCoat;
        const float coatAlbedoHere = hasCoat ? 1.0f - belowCoat(mu) : 0.0f;
        const float sheenHere = sheen > 0.0f ? sheen * minf(sheenAlbedo(sheenAlpha, mu), 1.0f) : 0.0f;
        const float belowSheen = (1.0f - coatAlbedoHere) * (1.0f - sheenHere);
        const Vec3 reflected = belowSheen * principledFresnel(in, color, mu, passage);
        if (hasSmoothCoat) { mirror += Vec3(coatAlbedoHere); }
        if (hasSmoothBase) { mirror += reflected; }
        const float ofMirror = maxComponent(mirror);
        const float ofCoat = hasRoughCoat ? coatAlbedoHere : 0.0f;
        const float ofPassing = setSharp(mu);
        const float ofSharp = passage.isSharp ? ofPassing : 0.0f;
        const float ofBase =
            (hasSmoothBase ? 0.0f : maxComponent(reflected)) + (passage.isSharp ? 0.0f : ofPassing);
        const float ofDiffuse = belowSheen * scatters * enters * maxComponent(color);
        const float ofSheen = (1.0f - coatAlbedoHere) * sheenHere;
        const float sum = ofMirror + ofCoat + ofBase + ofDiffuse + ofSheen + ofSharp;
        if (!(sum > 0.0f)) { return; }
        mirrorProbability = ofMirror / sum;
        sharpProbability = ofSharp / sum;
        coatProbability = ofCoat / sum;
        baseProbability = ofBase / sum;
        diffuseProbability = ofDiffuse / sum;
        sheenProbability = ofSheen / sum;
    }

    /// How much passes, as power; sets what passes sharply.
    GLINT_HD float setSharp(float mu) {
        if (!(passage.share > 0.0f)) { return 0.0f; }
        if (!passage.isSharp) {
            // Facets lean: some let light pass where the surface would not.
            constexpr float kLeast = 0.1f;
            const float cosine = passage.isInside ? maxf(mu, kLeast) : mu;
            return passage.share * maxf(passage.enters(in, cosine), kLeast) * maxComponent(passage.tint);
        }
        const Vec3 wi = passage.straight(wo);
        if (isZero(wi)) { return 0.0f; }
        const float left = passage.share * passage.enters(in, mu) * leftBelow(passage.layerCosine(wo, wi));
        sharp = passage.tint * left;
        return maxComponent(sharp);
    }
};

}  // namespace detail
}  // namespace glint
