// The principled model of glTF 2.0 and of Burley: a clear coat over sheen over a base between plastic and
// metal. Host and device.
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
// under the boundary. Left out: transmission, a coat with a normal of its own, light that bounces more than
// once between facets.
#pragma once

#include "engine/kernels/bsdf/plastic.h"

namespace glint {
namespace detail {

/// At least the albedo of a coat of index 1.5, to 0.003: what a smooth one reflects at a less grazing angle.
/// A fit of ours to roughCoatAlbedo().
GLINT_HD inline float principledCoatAlbedo(float alpha, float mu) {
    const float width = alpha * std::sqrt(alpha);
    const float cosine = minf(mu + 0.488f * width / (width + 0.09f) * square(square(1.0f - mu)), 1.0f);
    float cosT = 0.0f;
    return fresnelDielectric(cosine, 1.5f, &cosT);
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

/// Schlick's metal of reflectance `color` and a dielectric under a tint, mixed.
GLINT_HD inline Vec3 principledFresnel(const ShadingInputs& in, const Vec3& color, float cosine) {
    float cosT = 0.0f;
    const float fresnel = fresnelDielectric(cosine, in.ior, &cosT);
    const float headOn = square((in.ior - 1.0f) / (in.ior + 1.0f));
    // The share that no tint colours: 0 head on, 1 at grazing incidence.
    const float grazing = maxf((fresnel - headOn) / (1.0f - headOn), 0.0f);
    const Vec3 dielectric = in.specular * (in.specularTint * (fresnel - grazing) + grazing);
    const float rest = 1.0f - cosine;
    const Vec3 metal = color + (Vec3(1.0f) - color) * (square(square(rest)) * rest);
    return (1.0f - in.metallic) * dielectric + in.metallic * metal;
}

/// The layers as seen from one wo, and the probabilities of their lobes, which sum to 1: by the light each
/// reflects. Smooth layers share one direction and so one lobe, the mirror.
template <FeatureMask kMask>
struct PrincipledLayers {
    const MaterialData& material;
    const ShadingInputs& in;
    const Vec3& color;
    const Vec3& wo;
    bool hasSmoothCoat, hasRoughCoat, hasSmoothBase;
    float sheenAlpha, sheen;  ///< sheen: its largest channel
    float enters;             ///< the share of light that the dielectric's boundary lets in
    Vec3 mirror{0.0f};        ///< what the smooth layers reflect
    float mirrorProbability = 0.0f, coatProbability = 0.0f, baseProbability = 0.0f;
    float diffuseProbability = 1.0f, sheenProbability = 0.0f;

    explicit GLINT_HD PrincipledLayers(const Bsdf<kMask>& bsdf)
        : material(*bsdf.material), in(bsdf.inputs()), color(bsdf.color), wo(bsdf.woLocal) {
        hasSmoothCoat = in.clearcoat > 0.0f && in.clearcoatRoughness < kSmoothAlpha;
        hasRoughCoat = in.clearcoat > 0.0f && !hasSmoothCoat;
        hasSmoothBase = isSmooth(in);
        sheen = maxComponent(in.sheenColor);
        sheenAlpha = maxf(in.sheenRoughness, kLeastSheenAlpha);
        enters = 1.0f - in.specular * coatAlbedo<kMask>(material, in, wo);
        setProbabilities(clampf(wo.z, 0.0f, 1.0f));
    }

    /// What the coat leaves to the layers below.
    GLINT_HD float belowCoat(float mu) const {
        return in.clearcoat > 0.0f ? 1.0f - in.clearcoat * principledCoatAlbedo(in.clearcoatRoughness, mu)
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
        float below = belowCoat(mu);
        if (hasRoughCoat) {
            float cosT = 0.0f;
            const float fresnel = in.clearcoat * fresnelDielectric(cosine, 1.5f, &cosT);
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
            result.value += principledFresnel(in, color, cosine) * lobe;
            result.pdfSolidAngle += baseProbability * base.reflectionPdf(wo, h);
        }
        if (in.metallic >= 1.0f) { return result; }
        const float leaves = (1.0f - in.specular * coatAlbedo<kMask>(material, in, wi)) /
                             maxf(1.0f - in.specular * in.coat.averageAlbedo, 1e-6f);
        const BsdfValue diffuse =
            evaluateLambert(color * ((1.0f - in.metallic) * below * enters * leaves * baseScale), wi);
        result.value += diffuse.value;
        result.pdfSolidAngle += diffuseProbability * diffuse.pdfSolidAngle;
        return result;
    }

    /// A direction of a lobe with a density; uLobe from mirrorProbability on.
    template <class Facets>
    GLINT_HD Vec3 sample(const Facets& base, float uLobe, Vec2 u) const {
        float u1 = uLobe - mirrorProbability;
        if (u1 < coatProbability) {
            return reflect(wo, GgxFacets{in.clearcoatRoughness}.sampleNormal(wo, u));
        }
        u1 -= coatProbability;
        if (u1 < baseProbability) { return reflect(wo, base.sampleNormal(wo, u)); }
        if (u1 - baseProbability < diffuseProbability) { return sampleCosineHemisphere(u); }
        const Vec3 wi = sampleSphere(u);
        return {wi.x, wi.y, std::fabs(wi.z)};
    }

  private:
    GLINT_HD void setProbabilities(float mu) {
        const float coatAlbedoHere = in.clearcoat > 0.0f ? 1.0f - belowCoat(mu) : 0.0f;
        const float sheenHere = sheen > 0.0f ? sheen * minf(sheenAlbedo(sheenAlpha, mu), 1.0f) : 0.0f;
        const float belowSheen = (1.0f - coatAlbedoHere) * (1.0f - sheenHere);
        const Vec3 reflected = belowSheen * principledFresnel(in, color, mu);
        if (hasSmoothCoat) { mirror += Vec3(coatAlbedoHere); }
        if (hasSmoothBase) { mirror += reflected; }
        const float ofMirror = maxComponent(mirror);
        const float ofCoat = hasRoughCoat ? coatAlbedoHere : 0.0f;
        const float ofBase = hasSmoothBase ? 0.0f : maxComponent(reflected);
        const float ofDiffuse = belowSheen * (1.0f - in.metallic) * enters * maxComponent(color);
        const float ofSheen = (1.0f - coatAlbedoHere) * sheenHere;
        const float sum = ofMirror + ofCoat + ofBase + ofDiffuse + ofSheen;
        if (!(sum > 0.0f)) { return; }
        mirrorProbability = ofMirror / sum;
        coatProbability = ofCoat / sum;
        baseProbability = ofBase / sum;
        diffuseProbability = ofDiffuse / sum;
        sheenProbability = ofSheen / sum;
    }
};

}  // namespace detail

template <FeatureMask kMask>
struct PrincipledModel : BsdfModelDefaults {
    static constexpr FeatureMask kFeatures = kFeaturePrincipled;

    static GLINT_HD void settle(const MaterialData& material, const View<CoatRow>& coats, ShadingInputs* in) {
        PlasticModel<kMask>::settle(material, coats, in);
    }

    static GLINT_HD FeatureMask featuresOf(const MaterialData&) { return kFeaturePrincipled; }

    static GLINT_HD bool isSpecularOnly(const Bsdf<kMask>& bsdf) {
        const ShadingInputs& in = bsdf.inputs();
        return detail::isSmooth(in) && in.metallic >= 1.0f && isZero(in.sheenColor) && !hasRoughCoat(in);
    }

    static GLINT_HD bool hasSpecularLobe(const Bsdf<kMask>& bsdf) {
        const ShadingInputs& in = bsdf.inputs();
        return detail::isSmooth(in) || (in.clearcoat > 0.0f && !hasRoughCoat(in));
    }

    /// Stores where there is sheen or more than a trace of a diffuse base; otherwise where no rough layer is
    /// too sharp.
    static GLINT_HD LobeRange visiblePointLobes(const Bsdf<kMask>& bsdf, float storeAlpha) {
        constexpr float kMostMetallic = 0.95f;
        const ShadingInputs& in = bsdf.inputs();
        if (isSpecularOnly(bsdf)) { return {}; }
        const bool isBroad = in.metallic < kMostMetallic || !isZero(in.sheenColor);
        const bool hasSharpBase =
            !detail::isSmooth(in) && detail::narrowestAlpha<kMask>(*bsdf.material, in) < storeAlpha;
        const bool hasSharpCoat = hasRoughCoat(in) && in.clearcoatRoughness < storeAlpha;
        if (!isBroad && (hasSharpBase || hasSharpCoat)) { return {}; }
        return {detail::PrincipledLayers<kMask>(bsdf).mirrorProbability, 1.0f};
    }

    static GLINT_HD BsdfValue evaluate(const Bsdf<kMask>& bsdf, const Vec3& wi, float ngWi) {
        const float baseScale = detail::terminator(bsdf, ngWi, wi.z);
        if (!(wi.z > 0.0f)) { return {}; }
        return detail::withFacets(bsdf, [&](const auto& base) {
            return detail::PrincipledLayers<kMask>(bsdf).evaluate(base, wi, baseScale);
        });
    }

    static GLINT_HD BsdfSample sample(const Bsdf<kMask>& bsdf, float uLobe, Vec2 u) {
        const detail::PrincipledLayers<kMask> layers(bsdf);
        if (uLobe < layers.mirrorProbability) {
            return detail::specularSample(detail::mirrored(layers.wo),
                                          layers.mirror / layers.mirrorProbability);
        }
        return detail::withFacets(bsdf, [&](const auto& base) -> BsdfSample {
            const Vec3 wi = layers.sample(base, uLobe, u);
            if (!(wi.z > 0.0f)) { return {}; }
            const BsdfValue value = layers.evaluate(base, wi, detail::terminatorOf(bsdf, wi));
            if (!(value.pdfSolidAngle > 0.0f)) { return {}; }
            return detail::nonDeltaSample(wi, value.value / value.pdfSolidAngle, value.pdfSolidAngle);
        });
    }

  private:
    static GLINT_HD bool hasRoughCoat(const ShadingInputs& in) {
        return in.clearcoat > 0.0f && in.clearcoatRoughness >= kSmoothAlpha;
    }
};

}  // namespace glint
