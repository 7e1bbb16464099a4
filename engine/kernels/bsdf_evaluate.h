// Evaluating a BSDF in its local frame: which lobe a material has, and what it scatters towards one
// direction. Host and device. Included by bsdf.h only.
#pragma once

#include "engine/kernels/bsdf_dielectric.h"
#include "engine/kernels/bsdf_plastic.h"
#include "engine/kernels/bsdf_point.h"

namespace glint {
namespace detail {

/// All lobes but the specular ones. ngWi: wi's cosine with the geometric normal.
template <FeatureMask kMask>
GLINT_HD LobeValue evaluateLocal(const Bsdf<kMask>& bsdf, const Vec3& wi, float ngWi) {
    const MaterialData& material = *bsdf.material;
    switch (kindOf<kMask>(material)) {
        case MaterialKind::Diffuse:
            return evaluateDiffuse(bsdf.color * terminator(bsdf, ngWi, wi.z), wi);
        case MaterialKind::Mirror:
            break;
        case MaterialKind::Conductor:
            if constexpr (hasFeature<kMask>(kFeatureGlossy)) {
                return isSmooth(material) ? LobeValue{}
                                          : evaluateRoughConductor(material, bsdf.color, bsdf.woLocal, wi);
            }
            break;
        case MaterialKind::Dielectric:
            if constexpr (hasFeature<kMask>(kFeatureGlossy) && hasFeature<kMask>(kFeatureDielectric)) {
                return !isSmooth(material) && (material.flags & kMaterialThin) == 0
                           ? evaluateRoughDielectric(bsdf.color, material.alpha, bsdf.eta, bsdf.woLocal, wi,
                                                     bsdf.transport)
                           : LobeValue{};
            }
            break;
        case MaterialKind::Plastic:
            if constexpr (hasFeature<kMask>(kFeaturePlastic)) {
                return evaluatePlastic(material, bsdf.color, bsdf.woLocal, wi, terminator(bsdf, ngWi, wi.z));
            }
            break;
        case MaterialKind::Mixture:
            if constexpr (hasFeature<kMask>(kFeatureMixture)) {
                const float diffuse = material.mixtureProbability.x;
                const LobeValue lobe =
                    evaluateDiffuse(bsdf.color * (diffuse * terminator(bsdf, ngWi, wi.z)), wi);
                return {lobe.value, lobe.pdfSolidAngle * diffuse};
            }
            break;
    }
    return {};
}

}  // namespace detail
}  // namespace glint
