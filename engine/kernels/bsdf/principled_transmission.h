// Light that passes a principled material: the boundary of a body, where it is refracted, or a sheet of no
// thickness, which it passes straight. Host and device.
//
// Burley 2015, "Extending the Disney BRDF to a BSDF with Integrated Subsurface Scattering", and glTF's
// KHR_materials_transmission and _volume: of what the dielectric's boundary does not reflect, the share
// `specularTransmission` passes, and the rest is scattered diffusely. What passes a facet is tinted by the
// colour, as glTF has it, or by its root, as Burley has it, so that a way in and out makes the colour. Facets
// of a body refract as Walter et al. 2007 have it (dielectric.h); what passes a rough sheet is what its
// facets would reflect, mirrored at its plane. Where nothing passes, both sides of the surface scatter alike;
// sheen and coat of a body lie on its front alone, and take their share of what passes there.
#pragma once

#include <glm/exponential.hpp>

#include "engine/kernels/bsdf/dielectric.h"

namespace glint {
namespace detail {

/// Whether some light passes the material somewhere.
template <FeatureMask kMask>
GLINT_HD bool letsLightPass(const MaterialData& material) {
    return hasFeature<kMask>(kFeatureTransmission) && (material.flags & kMaterialTransmits) != 0;
}

/// What passes at a point, seen from one direction.
struct PrincipledPassage {
    float share = 0.0f;  ///< of what the boundary lets in
    float eta = 1.5f;    ///< index behind the boundary over that before it; of sheets: its own
    bool isSheet = false, isInside = false;
    bool isSharp = false;  ///< one direction alone
    Vec3 tint{0.0f};
    float radianceScale = 1.0f;

    template <FeatureMask kMask>
    static GLINT_HD PrincipledPassage of(const Bsdf<kMask>& bsdf) {
        PrincipledPassage passage;
        const MaterialData& material = *bsdf.material;
        if (!letsLightPass<kMask>(material)) { return passage; }
        const ShadingInputs& in = bsdf.inputs();
        passage.share = (1.0f - in.metallic) * in.specularTransmission;
        passage.isSheet = (material.flags & kMaterialThin) != 0;
        passage.isInside = !passage.isSheet && bsdf.eta < 1.0f;
        passage.eta = passage.isSheet ? in.ior : bsdf.eta;
        passage.isSharp =
            isSmooth(in) || (!passage.isSheet && std::fabs(in.ior - 1.0f) < kLeastIndexDifference);
        const bool isRoot = (material.flags & kMaterialRootTint) != 0;
        passage.tint = isRoot ? glm::sqrt(bsdf.color) : bsdf.color;
        passage.radianceScale = passage.isSheet ? 1.0f : detail::radianceScale(bsdf.eta, bsdf.transport);
        return passage;
    }

    /// The share of light that a facet lets in; cosine: with the facet.
    GLINT_HD float enters(const ShadingInputs& in, float cosine) const {
        float cosT = 0.0f;
        return 1.0f - in.specular * fresnelDielectric(cosine, eta, &cosT);
    }

    /// The sharp direction; zero where all is reflected.
    GLINT_HD Vec3 straight(const Vec3& wo) const {
        if (isSheet) { return -wo; }
        float cosT = 0.0f;
        fresnelDielectric(minf(wo.z, 1.0f), eta, &cosT);
        return cosT > 0.0f ? Vec3(-wo.x / eta, -wo.y / eta, -cosT) : Vec3(0.0f);
    }

    /// The normal of the facets by which light passes to wi, wi.z < 0; zero: none do.
    GLINT_HD Vec3 facetTowards(const Vec3& wo, const Vec3& wi) const {
        Vec3 h = glm::normalize(isSheet ? wo + Vec3(wi.x, wi.y, -wi.z) : wo + eta * wi);
        h = h.z < 0.0f ? -h : h;
        if (isSheet) { return h; }
        return glm::dot(wo, h) > 0.0f && glm::dot(wi, h) < 0.0f ? h : Vec3(0.0f);
    }

    /// What the facets of normal h send to wi of all light that enters, and the density of wi if h was
    /// sampled and all enter.
    template <class Facets>
    GLINT_HD BsdfValue through(const Facets& facets, const Vec3& wo, const Vec3& wi, const Vec3& h) const {
        if (isSheet) {
            return {Vec3(facets.reflection(wo, Vec3(wi.x, wi.y, -wi.z), h)), facets.reflectionPdf(wo, h)};
        }
        const float cosO = glm::dot(wo, h), cosI = glm::dot(wi, h);
        const float jacobian = square(eta) * -cosI / maxf(square(cosO + eta * cosI), 1e-20f);
        const float pdf = facets.normalPdf(wo, h) * jacobian;
        return {Vec3(pdf * facets.visible(-wi) * radianceScale), pdf};
    }

    /// Where a facet of normal h sends light; zero where it reflects all.
    GLINT_HD Vec3 past(const Vec3& wo, const Vec3& h) const {
        if (isSheet) {
            const Vec3 wi = reflect(wo, h);
            return {wi.x, wi.y, -wi.z};
        }
        const float cosO = clampf(glm::dot(wo, h), 0.0f, 1.0f);
        float cosT = 0.0f;
        fresnelDielectric(cosO, eta, &cosT);
        return cosT > 0.0f ? glm::normalize(refract(wo, h, eta, cosO, cosT)) : Vec3(0.0f);
    }

    /// The cosine at which light from wo to wi meets what lies on the surface.
    GLINT_HD float layerCosine(const Vec3& wo, const Vec3& wi) const {
        const float cosine = isSheet ? minf(wo.z, -wi.z) : isInside ? -wi.z : wo.z;
        return clampf(cosine, 0.0f, 1.0f);
    }

    GLINT_HD void mark(BsdfSample* sample, TransportMode transport) const {
        if (isSheet) {
            sample->isTransmission = true;
        } else {
            markTransmission(sample, eta, transport);
        }
    }
};

}  // namespace detail
}  // namespace glint
