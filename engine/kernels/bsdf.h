// How a surface scatters light: one interface over all materials. Host and device. Called by the path and
// photon kernels.
//
// Directions are in world space, of unit length, and point away from the surface. Compiled for a feature
// mask: a scene of diffuse surfaces only leaves nothing here but Lambert's law. Opaque materials scatter
// alike on both sides. Emission is not looked at.
//
// Shading normals. Whether a direction reflects or passes is decided by the geometric normal ng: what ng and
// ns do not agree on carries nothing, so no light leaks through. So that no facet turns black at grazing
// angles, materials without a specular lobe bend ns where the perfect reflection about it would fall below
// the surface (Keller et al. 2017, "The Iray Light Transport Simulation and Rendering System", section 4.2);
// specular lobes fold directions at a plane instead, which a photon can undo: wo at that of ns before, and wi
// at that of ng after the lobe. Photons scatter by bsdf_importance.h.
#pragma once

#include "engine/kernels/bsdf_evaluate.h"
#include "engine/kernels/bsdf_point.h"
#include "engine/kernels/bsdf_sample.h"

namespace glint {

struct BsdfSample {
    Vec3 wiWorld{0.0f};
    Vec3 weight{0.0f};           ///< f |cos wi| / density, the lobe's probability included
    float pdfSolidAngle = 0.0f;  ///< density of wi over all lobes; 0 when isSpecular
    /// squared relative index that radiance was divided by; Russian roulette multiplies its throughput by
    /// this, or paths die inside glass for nothing
    float etaScale = 1.0f;
    bool isSpecular = false;  ///< wi is the only direction it could be: no light sampling could find it
    bool isTransmission = false;
    bool valid = false;  ///< false: absorbed; nothing else is set
};

/// f |cos wi| and the density of sample() for the same wi.
struct BsdfValue {
    Vec3 value{0.0f};
    float pdfSolidAngle = 0.0f;
};

/// True when light sampling is useless here: evaluate() is 0 for every direction.
template <FeatureMask kMask>
GLINT_HD bool isSpecularOnly(const Bsdf<kMask>& bsdf) {
    const MaterialData& material = *bsdf.material;
    switch (detail::kindOf<kMask>(material)) {
        case MaterialKind::Diffuse:
        case MaterialKind::Plastic:
            return false;
        case MaterialKind::Mirror:
            return true;
        case MaterialKind::Conductor:
            return detail::isSmooth(material);
        case MaterialKind::Dielectric:
            return detail::isSmooth(material) || (material.flags & kMaterialThin) != 0;
        case MaterialKind::Mixture:
            return material.mixtureProbability.x <= 0.0f;
    }
    return true;
}

/// The material's colour at the point for denoisers and previews: not an exact albedo (glass: its tint;
/// metal: its reflectance at normal incidence).
template <FeatureMask kMask>
GLINT_HD Vec3 displayAlbedo(const Bsdf<kMask>& bsdf) {
    if (detail::kindOf<kMask>(*bsdf.material) == MaterialKind::Conductor) {
        return bsdf.color * fresnelConductor(1.0f, bsdf.material->eta, bsdf.material->k);
    }
    return bsdf.color;
}

/// f |cos wi| towards wiWorld and the density with which sample() finds it. Specular lobes count for nothing.
template <FeatureMask kMask>
GLINT_HD BsdfValue evaluateWithPdf(const Bsdf<kMask>& bsdf, const Vec3& wiWorld) {
    const Vec3 wi = detail::toLocal(bsdf, wiWorld);
    const float ngWi = detail::geometricCosine(bsdf, wiWorld, wi.z);
    if (!(ngWi * wi.z > 0.0f)) { return {}; }
    const LobeValue lobe = detail::evaluateLocal(bsdf, wi, ngWi);
    return {lobe.value, lobe.pdfSolidAngle};
}

/// f |cos wi| alone.
template <FeatureMask kMask>
GLINT_HD Vec3 evaluate(const Bsdf<kMask>& bsdf, const Vec3& wiWorld) {
    return evaluateWithPdf(bsdf, wiWorld).value;
}

/// The density of sample() by solid angle; integrates to less than 1 where samples are absorbed, and to what
/// is left where lobes are specular.
template <FeatureMask kMask>
GLINT_HD float pdfSolidAngle(const Bsdf<kMask>& bsdf, const Vec3& wiWorld) {
    return evaluateWithPdf(bsdf, wiWorld).pdfSolidAngle;
}

/// A direction in which to go on. uLobe and u in [0, 1).
template <FeatureMask kMask>
GLINT_HD BsdfSample sample(const Bsdf<kMask>& bsdf, float uLobe, Vec2 u) {
    const LobeSample lobe = detail::sampleLocal(bsdf, uLobe, u);
    if (!lobe.valid) { return {}; }
    BsdfSample result;
    result.wiWorld = detail::frameOf(bsdf).toWorld(lobe.wiLocal);
    const float ngWi = detail::geometricCosine(bsdf, result.wiWorld, lobe.wiLocal.z);
    if (!(ngWi * lobe.wiLocal.z > 0.0f)) {
        if (!lobe.isSpecular || ngWi == 0.0f) { return {}; }
        result.wiWorld -= 2.0f * ngWi * bsdf.ngWorld;
    }
    result.weight = lobe.weight;
    result.pdfSolidAngle = lobe.pdfSolidAngle;
    result.etaScale = lobe.etaScale;
    result.isSpecular = lobe.isSpecular;
    result.isTransmission = lobe.isTransmission;
    result.valid = true;
    return result;
}

}  // namespace glint
