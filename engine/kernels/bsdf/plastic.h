// Plastic: a diffuse base under a clear dielectric coat, smooth or with facets. Host and device.
//
// What the coat does not reflect, 1 - E(wo), enters; inside, it goes back and forth between the diffuse base
// and the coat's underside, which reflects the share Fi of diffuse light; what leaves is shaped by 1 - E(wi):
//     f = base (1 - E(wo)) (1 - E(wi)) / pi * (1 - Fi) / ((1 - Eavg) (1 - base Fi)),
// which is reciprocal and, for base = 1, reflects exactly what enters. E is the coat's directional albedo:
// Fresnel for a smooth coat, a table for a rough one. For a smooth coat 1 - Fi = (1 - Eavg) / ior^2, and
// this is the usual model (Pharr, Jakob and Humphreys 2023, section 14.3, discuss it; Kelemen and
// Szirmay-Kalos 2001 for the coupling). Left out: absorption in the coat; the broadening of what enters
// through a rough coat.
#pragma once

#include "engine/kernels/bsdf/diffuse.h"
#include "engine/kernels/bsdf/facets.h"
#include "engine/kernels/bsdf/fresnel.h"

namespace glint {
namespace detail {

/// E at cosine mu by a row. The table holds E over the smooth boundary's Fresnel reflectance, which hardly
/// varies, at mu = (i / (n-1))^2.
GLINT_HD inline float coatAlbedo(const ShadingInputs& in, const CoatRow& row, float mu) {
    const float cosine = clampf(mu, 0.0f, 1.0f);
    float cosT = 0.0f;
    const float fresnel = fresnelDielectric(cosine, in.ior, &cosT);
    if (isSmooth(in)) { return fresnel; }
    const float position = std::sqrt(cosine) * static_cast<float>(kCoatSamples - 1);
    const int index =
        position < static_cast<float>(kCoatSamples - 2) ? static_cast<int>(position) : kCoatSamples - 2;
    const float weight = position - static_cast<float>(index);
    const float ratio = (1.0f - weight) * row.ratio[index] + weight * row.ratio[index + 1];
    return minf(fresnel * ratio, 1.0f);
}

/// E towards w. Where roughness has two directions, by the albedos in both of their planes: up to 10 in ratio
/// this is within 0.01 of the most that is true, and down to 0.3 above it near grazing incidence alone.
template <FeatureMask kMask>
GLINT_HD float coatAlbedo(const MaterialData& material, const ShadingInputs& in, const Vec3& w) {
    const float along = coatAlbedo(in, in.coat, w.z);
    if constexpr (hasFeature<kMask>(kFeatureFacets)) {
        const float sine2 = square(w.x) + square(w.y);
        if (hasGeneralFacets<kMask>(material) && sine2 > 0.0f) {
            return along + (coatAlbedo(in, in.crossCoat, w.z) - along) * (square(w.y) / sine2);
        }
    }
    return along;
}

/// Where a coat's table has a row: what is asked for lies between `first` and the next.
struct CoatPlace {
    int first = 0;
    float weight = 0.0f;  ///< of the next row
};

/// x in [0, 1] over `count` rows.
GLINT_HD inline CoatPlace coatPlace(float x, int count) {
    if (count == 1) { return {}; }
    const float position = x * static_cast<float>(count - 1);
    const int first = position < static_cast<float>(count - 2) ? static_cast<int>(position) : count - 2;
    return {first, position - static_cast<float>(first)};
}

GLINT_HD inline CoatRow mixRows(const CoatRow& a, const CoatRow& b, float weight) {
    CoatRow row;
    row.internalAlbedo = (1.0f - weight) * a.internalAlbedo + weight * b.internalAlbedo;
    row.averageAlbedo = (1.0f - weight) * a.averageAlbedo + weight * b.averageAlbedo;
    for (int i = 0; i < kCoatSamples; ++i) {
        row.ratio[i] = (1.0f - weight) * a.ratio[i] + weight * b.ratio[i];
    }
    return row;
}

/// The base's reflectance of light that has entered, summed over all orders.
GLINT_HD inline Vec3 coatedBase(const ShadingInputs& in, const Vec3& base) {
    const float inside = in.coat.internalAlbedo;
    return base * ((1.0f - inside) / (Vec3(1.0f) - base * inside));
}

/// How the lobes are chosen for one wo: by the light each reflects.
struct PlasticChoice {
    Vec3 base;     ///< coatedBase
    float enters;  ///< 1 - E(wo)
    float coatProbability;
};

template <FeatureMask kMask>
GLINT_HD PlasticChoice plasticChoice(const Bsdf<kMask>& bsdf) {
    PlasticChoice choice;
    const float reflected = coatAlbedo<kMask>(*bsdf.material, bsdf.inputs(), bsdf.woLocal);
    choice.base = coatedBase(bsdf.inputs(), bsdf.color);
    choice.enters = 1.0f - reflected;
    const float diffuse = choice.enters * maxComponent(choice.base);
    const float sum = reflected + diffuse;
    choice.coatProbability = sum > 0.0f ? reflected / sum : 0.0f;
    return choice;
}

/// baseScale multiplies the base: how much of it the shadow terminator leaves.
template <FeatureMask kMask>
GLINT_HD BsdfValue evaluatePlastic(const Bsdf<kMask>& bsdf, const PlasticChoice& choice, const Vec3& wi,
                                   float baseScale) {
    const ShadingInputs& in = bsdf.inputs();
    const Vec3& wo = bsdf.woLocal;
    const float leaves =
        (1.0f - coatAlbedo<kMask>(*bsdf.material, in, wi)) / maxf(1.0f - in.coat.averageAlbedo, 1e-6f);
    BsdfValue result = evaluateLambert(choice.base * (choice.enters * leaves * baseScale), wi);
    result.pdfSolidAngle *= 1.0f - choice.coatProbability;
    if (!isSmooth(in)) {
        const Vec3 h = glm::normalize(wo + wi);
        float cosT = 0.0f;
        const float fresnel = fresnelDielectric(clampf(glm::dot(wo, h), 0.0f, 1.0f), in.ior, &cosT);
        const BsdfValue coat = withFacets(bsdf, [&](const auto& facets) {
            return BsdfValue{Vec3(fresnel * facets.reflection(wo, wi, h)),
                             choice.coatProbability * facets.reflectionPdf(wo, h)};
        });
        result.value += coat.value;
        result.pdfSolidAngle += coat.pdfSolidAngle;
    }
    return result;
}

}  // namespace detail

/// The rows of a plastic whose roughness or index is a texture: one for each pair of these where both are,
/// one for each of one of them otherwise. Denser where the coat's albedo changes faster.
struct CoatTableLayout {
    int alphas = 1;
    int iors = 1;

    static GLINT_HD CoatTableLayout of(const MaterialData& material) {
        return {detail::hasRoughnessTexture(material) ? 24 : 1,
                material.textures.ior.index != TextureSlot::kNone ? 16 : 1};
    }

    GLINT_HD int rows() const { return alphas * iors; }
    GLINT_HD float alpha(int index) const {
        return square(static_cast<float>(index) / static_cast<float>(alphas - 1));
    }
    /// From almost 1, where nothing is reflected that a row could be a ratio to, to 999; even in the root of
    /// (ior - 1) / (ior + 1).
    GLINT_HD float ior(int index) const {
        const float x = static_cast<float>(index) / static_cast<float>(iors - 1);
        const float t = maxf(kMostReflection * square(x), 1e-3f);
        return (1.0f + t) / (1.0f - t);
    }

    GLINT_HD CoatRow at(const CoatRow* table, float alphaHere, float iorHere) const {
        const detail::CoatPlace a = detail::coatPlace(std::sqrt(alphaHere), alphas);
        const float t = minf((iorHere - 1.0f) / (iorHere + 1.0f) / kMostReflection, 1.0f);
        const detail::CoatPlace i = detail::coatPlace(std::sqrt(t), iors);
        const auto along = [&](int iorIndex) {
            const CoatRow* row = table + iorIndex * alphas + a.first;
            return alphas > 1 ? detail::mixRows(row[0], row[1], a.weight) : row[0];
        };
        return iors > 1 ? detail::mixRows(along(i.first), along(i.first + 1), i.weight) : along(0);
    }

  private:
    static constexpr float kMostReflection = 0.998f;
};

template <FeatureMask kMask>
struct PlasticModel : BsdfModelDefaults {
    static constexpr FeatureMask kFeatures = kFeaturePlastic;

    static GLINT_HD void settle(const MaterialData& material, const View<CoatRow>& coats, ShadingInputs* in) {
        in->ior = maxf(in->ior, 1.0f);
        if (material.coatTable == TextureSlot::kNone) {
            in->coat = material.inputs.coat;
            if constexpr (hasFeature<kMask>(kFeatureFacets)) { in->crossCoat = material.inputs.crossCoat; }
            return;
        }
        const CoatTableLayout layout = CoatTableLayout::of(material);
        const CoatRow* table = coats.data + material.coatTable;
        in->coat = layout.at(table, in->roughness, in->ior);
        if constexpr (hasFeature<kMask>(kFeatureFacets)) {
            if (!detail::hasGeneralFacets<kMask>(material)) { return; }
            in->crossCoat = layout.at(table, in->crossRoughness, in->ior);
            in->coat.averageAlbedo = 0.5f * (in->coat.averageAlbedo + in->crossCoat.averageAlbedo);
        }
    }

    static GLINT_HD FeatureMask featuresOf(const MaterialData& material) {
        return kFeaturePlastic | (detail::canBeRough(material) ? kFeatureGlossy : FeatureMask{0});
    }

    static GLINT_HD bool isSpecularOnly(const Bsdf<kMask>&) { return false; }
    static GLINT_HD bool hasSpecularLobe(const Bsdf<kMask>& bsdf) { return detail::isSmooth(bsdf.inputs()); }

    static GLINT_HD LobeRange visiblePointLobes(const Bsdf<kMask>& bsdf, float) {
        if (!detail::isSmooth(bsdf.inputs())) { return {0.0f, 1.0f}; }
        return {choice(bsdf).coatProbability, 1.0f};
    }

    static GLINT_HD BsdfValue evaluate(const Bsdf<kMask>& bsdf, const Vec3& wi, float ngWi) {
        const float baseScale = detail::terminator(bsdf, ngWi, wi.z);
        if (!(wi.z > 0.0f)) { return {}; }
        return detail::evaluatePlastic(bsdf, choice(bsdf), wi, baseScale);
    }

    static GLINT_HD BsdfSample sample(const Bsdf<kMask>& bsdf, float uLobe, Vec2 u) {
        const ShadingInputs& in = bsdf.inputs();
        const Vec3& wo = bsdf.woLocal;
        const detail::PlasticChoice chosen = choice(bsdf);
        Vec3 wi;
        if (uLobe < chosen.coatProbability) {
            if (detail::isSmooth(in)) {
                // E(wo) / coatProbability, which is 0 / 0 where the coat reflects nothing.
                const float weight = (1.0f - chosen.enters) / chosen.coatProbability;
                return detail::specularSample(detail::mirrored(wo), Vec3(weight));
            }
            wi = reflect(
                wo, detail::withFacets(bsdf, [&](const auto& facets) { return facets.sampleNormal(wo, u); }));
        } else {
            wi = sampleCosineHemisphere(u);
        }
        if (!(wi.z > 0.0f)) { return {}; }
        const BsdfValue value = detail::evaluatePlastic(bsdf, chosen, wi, detail::terminatorOf(bsdf, wi));
        if (!(value.pdfSolidAngle > 0.0f)) { return {}; }
        return detail::nonDeltaSample(wi, value.value / value.pdfSolidAngle, value.pdfSolidAngle);
    }

  private:
    static GLINT_HD detail::PlasticChoice choice(const Bsdf<kMask>& bsdf) {
        return detail::plasticChoice(bsdf);
    }
};

}  // namespace glint
