// How a surface scatters light: one interface over all materials. Host and device.
//
// bsdf/<model>.h holds what one kind of material does, withModel() the choice among them. A model is a struct
// template on the feature mask with
//   kFeatures                            the bits of which any compiles it in
//   featuresOf(material)                 those that kernels for such a material need
//   isSpecularOnly(bsdf)                 whether no lobe has a density; looks at the inputs alone
//   hasSpecularLobe(bsdf)                whether some lobe has none; likewise
//   visiblePointLobes(bsdf, storeAlpha)  as below
//   evaluate(bsdf, wi, ngWi)             all lobes with a density; wi is local, ngWi its cosine with ng
//   sample(bsdf, uLobe, u)               a local direction
// and what it changes of BsdfModelDefaults.
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
// at that of ng after the lobe. Photons scatter by bsdf/importance.h.
#pragma once

#include "engine/kernels/bsdf/coated.h"
#include "engine/kernels/bsdf/conductor.h"
#include "engine/kernels/bsdf/dielectric.h"
#include "engine/kernels/bsdf/diffuse.h"
#include "engine/kernels/bsdf/facet_frame.h"
#include "engine/kernels/bsdf/inputs_at.h"
#include "engine/kernels/bsdf/mirror.h"
#include "engine/kernels/bsdf/mixture.h"
#include "engine/kernels/bsdf/phong.h"
#include "engine/kernels/bsdf/plastic.h"
#include "engine/kernels/bsdf/principled.h"
#include "engine/kernels/bsdf/translucent.h"
#include "engine/kernels/bsdf/ward.h"

namespace glint {
namespace detail {

template <class Model, FeatureMask kMask, class Visit>
GLINT_HD auto visitIfCompiled(Visit&& visit) {
    if constexpr ((kMask & Model::kFeatures) != 0) {
        return visit(Model{});
    } else {
        return decltype(visit(Model{})){};
    }
}

/// visit(model) for the model of a kind; models that the mask leaves out are not compiled, and kinds it does
/// not have give a value of zeros.
template <FeatureMask kMask, class Visit>
GLINT_HD auto withModel(const MaterialData& material, Visit&& visit) {
    if constexpr (isDiffuseOnly<kMask>()) {
        return visit(DiffuseModel<kMask>{});
    } else {
        switch (material.kind) {
            case MaterialKind::Diffuse:
                return visitIfCompiled<DiffuseModel<kMask>, kMask>(visit);
            case MaterialKind::Mirror:
                return visitIfCompiled<MirrorModel<kMask>, kMask>(visit);
            case MaterialKind::Conductor:
                return visitIfCompiled<ConductorModel<kMask>, kMask>(visit);
            case MaterialKind::Dielectric:
                return visitIfCompiled<DielectricModel<kMask>, kMask>(visit);
            case MaterialKind::Plastic:
                return visitIfCompiled<PlasticModel<kMask>, kMask>(visit);
            case MaterialKind::Mixture:
                return visitIfCompiled<MixtureModel<kMask>, kMask>(visit);
            case MaterialKind::Translucent:
                return visitIfCompiled<TranslucentModel<kMask>, kMask>(visit);
            case MaterialKind::Principled:
                return visitIfCompiled<PrincipledModel<kMask>, kMask>(visit);
            case MaterialKind::Phong:
                return visitIfCompiled<PhongModel<kMask>, kMask>(visit);
            case MaterialKind::Ward:
                return visitIfCompiled<WardModel<kMask>, kMask>(visit);
            case MaterialKind::Coated:
                return visitIfCompiled<CoatedModel<kMask>, kMask>(visit);
        }
        return decltype(visit(DiffuseModel<kMask>{})){};
    }
}

/// ns, or the nearest normal about which wo's mirror direction stays above the surface. All on one side of
/// the surface.
GLINT_HD inline Vec3 bendShadingNormal(const Vec3& wo, const Vec3& ng, const Vec3& ns) {
    if (ns == ng) { return ns; }
    const Vec3 mirror = reflect(wo, ns);
    const float above = glm::dot(mirror, ng);
    const float least = minf(0.9f * glm::dot(wo, ng), 0.01f);
    if (above >= least) { return ns; }
    const Vec3 half = wo + glm::normalize(mirror + (least - above) * ng);
    const float squared = lengthSquared(half);
    return squared > 1e-12f ? half / std::sqrt(squared) : ng;
}

/// Whether some lobe reflects or refracts in one direction only. Such materials keep ns as it is; sample()
/// folds what falls on the wrong side of the surface back instead.
template <FeatureMask kMask>
GLINT_HD bool hasSpecularLobe(const Bsdf<kMask>& bsdf) {
    return withModel<kMask>(*bsdf.material, [&](auto model) { return model.hasSpecularLobe(bsdf); });
}

/// The shading normal that a BSDF uses; ng and ns on wo's side. Power that comes from wo leaves diffuse
/// surfaces in every direction above them, however a path that looks at them bends ns.
template <FeatureMask kMask>
GLINT_HD Vec3 usedShadingNormal(const Bsdf<kMask>& bsdf, const Vec3& wo, const Vec3& ng, const Vec3& ns,
                                TransportMode transport) {
    return withModel<kMask>(*bsdf.material, [&](auto model) {
        if (model.hasSpecularLobe(bsdf)) { return ns; }
        const bool anyDirection = model.kPhotonsLeaveAboutNg && transport == TransportMode::Importance;
        return anyDirection ? ng : bendShadingNormal(wo, ng, ns);
    });
}

/// Makes inputs what the material's model computes with.
template <FeatureMask kMask>
GLINT_HD void settle(const MaterialData& material, const View<CoatRow>& coats, ShadingInputs* inputs) {
    if (hasGeneralFacets<kMask>(material)) { settleFacets(inputs); }
    withModel<kMask>(material, [&](auto model) {
        model.settle(material, coats, inputs);
        return true;
    });
}

/// Inside over outside, for the light's wavelength.
template <FeatureMask kMask>
GLINT_HD float indexOfRefraction(const Bsdf<kMask>& bsdf) {
    const float ior = bsdf.inputs().ior;
    if constexpr (hasFeature<kMask>(kFeatureDispersion)) {
        constexpr float kLeast = 1e-3f;
        if (bsdf.wavelengthNm > 0.0f && (bsdf.material->flags & kMaterialDisperses) != 0) {
            return maxf(ior + indexShift(bsdf.material->dispersion, bsdf.wavelengthNm), kLeast);
        }
    }
    return ior;
}

template <FeatureMask kMask>
GLINT_HD BsdfValue evaluateLocal(const Bsdf<kMask>& bsdf, const Vec3& wi, float ngWi) {
    return withModel<kMask>(*bsdf.material, [&](auto model) { return model.evaluate(bsdf, wi, ngWi); });
}

template <FeatureMask kMask>
GLINT_HD BsdfSample sampleLocal(const Bsdf<kMask>& bsdf, float uLobe, Vec2 u) {
    return withModel<kMask>(*bsdf.material, [&](auto model) { return model.sample(bsdf, uLobe, u); });
}

}  // namespace detail

/// Scene: a SceneView, or anything with its materials, textures and coats. Surface: surface.h's SurfacePoint,
/// or anything with its ng, ns, uv, vertexColor and material, and with dpdu and dpdv or facetAxis; uvWidth
/// may be missing. `wavelengthNm`: 0, all of the spectrum.
template <FeatureMask kMask, class Scene, class Surface>
GLINT_HD Bsdf<kMask> makeBsdf(const Scene& scene, const Surface& surface, const Vec3& woWorld,
                              TransportMode transport = TransportMode::Radiance, float wavelengthNm = 0.0f) {
    Bsdf<kMask> bsdf;
    bsdf.material = &scene.materials[surface.material];
    bsdf.color = detail::surfaceColor<kMask>(*bsdf.material, scene.textures, surface);
    if constexpr (hasFeature<kMask>(kFeatureInputTextures)) {
        if ((bsdf.material->flags & kMaterialInputTextures) != 0) {
            detail::readInputs<kMask>(scene, *bsdf.material, surface.uv, detail::uvWidthOf(surface),
                                      &bsdf.textured);
            detail::settle<kMask>(*bsdf.material, scene.coats, &bsdf.textured);
        }
    }
    const bool outside = glm::dot(surface.ng, woWorld) >= 0.0f;
    bsdf.ngWorld = outside ? surface.ng : -surface.ng;
    bsdf.nsWorld = bsdf.ngWorld;
    if constexpr (hasFeature<kMask>(kFeatureShadingNormals)) {
        bsdf.nsWorld = detail::usedShadingNormal(bsdf, woWorld, bsdf.ngWorld,
                                                 outside ? surface.ns : -surface.ns, transport);
        bsdf.ngNs = bsdf.nsWorld == bsdf.ngWorld ? 1.0f : glm::dot(bsdf.ngWorld, bsdf.nsWorld);
    }
    if constexpr (!isDiffuseOnly<kMask>()) {
        bsdf.frame = Frame::fromNormal(bsdf.nsWorld);
        if constexpr (hasFeature<kMask>(kFeatureFacets)) { detail::turnAlongFacets(scene, surface, &bsdf); }
        bsdf.woLocal = bsdf.frame.toLocal(woWorld);
        if (bsdf.ngNs < 1.0f && detail::hasSpecularLobe(bsdf)) {
            if (transport == TransportMode::Radiance) { bsdf.woLocal.z = std::fabs(bsdf.woLocal.z); }
        } else {
            bsdf.woLocal.z = maxf(bsdf.woLocal.z, 0.0f);
        }
        if constexpr (hasFeature<kMask>(kFeatureDispersion)) { bsdf.wavelengthNm = wavelengthNm; }
        const float ior = detail::indexOfRefraction(bsdf);
        bsdf.eta = outside ? ior : 1.0f / ior;
        bsdf.transport = transport;
    }
    return bsdf;
}

/// What a scene needs of the kernels for the sake of this material.
GLINT_HD inline FeatureMask materialFeatures(const MaterialData& material) {
    FeatureMask textures = material.colorTexture != TextureSlot::kNone ? kFeatureTextures : FeatureMask{0};
    if ((material.flags & kMaterialInputTextures) != 0) {
        textures |= kFeatureTextures | kFeatureInputTextures;
    }
    if ((material.flags & kMaterialBump) != 0) { textures |= kFeatureTextures | kFeatureBumps; }
    if ((material.flags & kMaterialCutOut) != 0) { textures |= kFeatureTextures | kFeatureCutouts; }
    if ((material.flags & kMaterialMipmaps) != 0) { textures |= kFeatureTextures | kFeatureMipmaps; }
    const FeatureMask dispersion =
        (material.flags & kMaterialDisperses) != 0 ? kFeatureDispersion : FeatureMask{0};
    const FeatureMask attenuation = isZero(material.absorption) ? FeatureMask{0} : kFeatureAttenuation;
    const FeatureMask facets = (material.flags & kMaterialFacets) != 0 ? kFeatureFacets : FeatureMask{0};
    return textures | dispersion | attenuation | facets |
           detail::withModel<kAllFeatures>(material, [&](auto model) { return model.featuresOf(material); });
}

/// Makes a new material's constants what its model computes with.
GLINT_HD inline void settleConstants(MaterialData* material) {
    detail::settle<kAllFeatures>(*material, {}, &material->inputs);
}

/// True when light sampling is useless here: evaluate() is 0 for every direction.
template <FeatureMask kMask>
GLINT_HD bool isSpecularOnly(const Bsdf<kMask>& bsdf) {
    return detail::withModel<kMask>(*bsdf.material, [&](auto model) { return model.isSpecularOnly(bsdf); });
}

/// Whether light that sampling finds behind the surface may pass it. Asked of materials that are not
/// specular only.
template <FeatureMask kMask>
GLINT_HD bool transmitsSampledLight(const Bsdf<kMask>& bsdf) {
    return detail::withModel<kMask>(*bsdf.material,
                                    [&](auto model) { return model.transmitsSampledLight(*bsdf.material); });
}

/// The values of sample()'s uLobe that choose a lobe in which visible points and photons are stored (SPPM):
/// none for surfaces that only reflect or refract sharply. The other values choose specular lobes, which a
/// path follows. Metal and glass store from an alpha of storeAlpha on (the smaller one of two); everything
/// with a diffuse base stores always. One rule for camera paths and photons: what a photon leaves out, the
/// camera path has to find, and nothing may be counted twice.
template <FeatureMask kMask>
GLINT_HD LobeRange visiblePointLobes(const Bsdf<kMask>& bsdf, float storeAlpha) {
    return detail::withModel<kMask>(*bsdf.material,
                                    [&](auto model) { return model.visiblePointLobes(bsdf, storeAlpha); });
}

/// Whether photons that are stored on such a surface may go on behind it, where they are stored again.
template <FeatureMask kMask>
GLINT_HD bool letsStoredPhotonsThrough(const MaterialData& material, float storeAlpha) {
    return detail::withModel<kMask>(
        material, [&](auto model) { return model.letsStoredPhotonsThrough(material, storeAlpha); });
}

/// The material's colour at the point for denoisers and previews: not an exact albedo (glass: its tint;
/// metal: its reflectance at normal incidence).
template <FeatureMask kMask>
GLINT_HD Vec3 displayAlbedo(const Bsdf<kMask>& bsdf) {
    return detail::withModel<kMask>(*bsdf.material, [&](auto model) { return model.displayAlbedo(bsdf); });
}

/// f |cos wi| towards wiWorld and the density with which sample() finds it. Specular lobes count for nothing.
template <FeatureMask kMask>
GLINT_HD BsdfValue evaluateWithPdf(const Bsdf<kMask>& bsdf, const Vec3& wiWorld) {
    const Vec3 wi = detail::toLocal(bsdf, wiWorld);
    const float ngWi = detail::geometricCosine(bsdf, wiWorld, wi.z);
    if (!(ngWi * wi.z > 0.0f)) { return {}; }
    return detail::evaluateLocal(bsdf, wi, ngWi);
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
    BsdfSample result = detail::sampleLocal(bsdf, uLobe, u);
    if (!result.valid) { return result; }
    const float nsWi = result.wi.z;
    result.wi = detail::frameOf(bsdf).toWorld(result.wi);
    const float ngWi = detail::geometricCosine(bsdf, result.wi, nsWi);
    if (!(ngWi * nsWi > 0.0f)) {
        result.valid = result.isSpecular && ngWi != 0.0f;
        result.wi -= 2.0f * ngWi * bsdf.ngWorld;
    }
    return result;
}

}  // namespace glint
