// Sampling a BSDF in its local frame: which lobe is chosen, and a direction of it. Host and device. Included
// by bsdf.h only.
#pragma once

#include "engine/kernels/bsdf_dielectric.h"
#include "engine/kernels/bsdf_plastic.h"
#include "engine/kernels/bsdf_point.h"

namespace glint {
namespace detail {

template <FeatureMask kMask>
GLINT_HD float terminatorOf(const Bsdf<kMask>& bsdf, const Vec3& wiLocal) {
    const float ngWi = geometricCosine(bsdf, frameOf(bsdf).toWorld(wiLocal), wiLocal.z);
    return terminator(bsdf, ngWi, wiLocal.z);
}

template <FeatureMask kMask>
GLINT_HD LobeSample sampleLambert(const Bsdf<kMask>& bsdf, Vec2 u) {
    LobeSample sample = sampleDiffuse(bsdf.color, u);
    sample.weight *= terminatorOf(bsdf, sample.wiLocal);
    return sample;
}

/// Diffuse, mirror or refraction by the given probabilities, one colour for all.
template <FeatureMask kMask>
GLINT_HD LobeSample sampleMixture(const Bsdf<kMask>& bsdf, float uLobe, Vec2 u) {
    const Vec3& probability = bsdf.material->mixtureProbability;
    if (uLobe < probability.x) {
        LobeSample sample = sampleLambert(bsdf, u);
        sample.pdfSolidAngle *= probability.x;
        return sample;
    }
    if (uLobe < probability.x + probability.y || !(probability.z > 0.0f)) {
        return specularSample(mirrored(bsdf.woLocal), bsdf.color);
    }
    const float rest = (uLobe - probability.x - probability.y) / probability.z;
    return sampleSmoothDielectric(bsdf.color, bsdf.eta, bsdf.woLocal, clampf(rest, 0.0f, kOneMinusEpsilon),
                                  bsdf.transport);
}

template <FeatureMask kMask>
GLINT_HD LobeSample sampleGlass(const Bsdf<kMask>& bsdf, float uLobe, Vec2 u) {
    const MaterialData& material = *bsdf.material;
    if ((material.flags & kMaterialThin) != 0) {
        return sampleThinDielectric(bsdf.color, material.ior, bsdf.woLocal, uLobe);
    }
    if constexpr (hasFeature<kMask>(kFeatureGlossy)) {
        if (!isSmooth(material)) {
            return sampleRoughDielectric(bsdf.color, material.alpha, bsdf.eta, bsdf.woLocal, uLobe, u,
                                         bsdf.transport);
        }
    }
    return sampleSmoothDielectric(bsdf.color, bsdf.eta, bsdf.woLocal, uLobe, bsdf.transport);
}

template <FeatureMask kMask>
GLINT_HD LobeSample sampleLocal(const Bsdf<kMask>& bsdf, float uLobe, Vec2 u) {
    const MaterialData& material = *bsdf.material;
    switch (kindOf<kMask>(material)) {
        case MaterialKind::Diffuse:
            return sampleLambert(bsdf, u);
        case MaterialKind::Mirror:
            if constexpr (hasFeature<kMask>(kFeatureSpecular)) {
                return specularSample(mirrored(bsdf.woLocal), bsdf.color);
            }
            break;
        case MaterialKind::Conductor:
            if constexpr (hasFeature<kMask>(kFeatureGlossy)) {
                if (!isSmooth(material)) {
                    return sampleRoughConductor(material, bsdf.color, bsdf.woLocal, u);
                }
            }
            if constexpr (hasFeature<kMask>(kFeatureSpecular)) {
                return sampleSmoothConductor(material, bsdf.color, bsdf.woLocal);
            }
            break;
        case MaterialKind::Dielectric:
            if constexpr (hasFeature<kMask>(kFeatureDielectric)) { return sampleGlass(bsdf, uLobe, u); }
            break;
        case MaterialKind::Plastic:
            if constexpr (hasFeature<kMask>(kFeaturePlastic)) {
                return samplePlastic(material, bsdf.color, bsdf.woLocal, uLobe, u,
                                     [&](const Vec3& wi) { return terminatorOf(bsdf, wi); });
            }
            break;
        case MaterialKind::Mixture:
            if constexpr (hasFeature<kMask>(kFeatureMixture)) { return sampleMixture(bsdf, uLobe, u); }
            break;
    }
    return {};
}

}  // namespace detail
}  // namespace glint
