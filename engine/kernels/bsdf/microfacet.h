// The isotropic GGX microfacet distribution with Smith shadowing, in the local frame whose z is the normal.
// Host and device.
//
// Trowbridge and Reitz 1975; Walter et al. 2007; Heitz 2014 and 2018; Dupuy and Benyoub 2023. Every
// expression is arranged so that it stays finite at grazing directions. Other distributions: facets.h. Left
// out: light that bounces more than once between facets (a rough metal of alpha 1 loses up to a third of
// its energy).
#pragma once

#include "engine/math/warp.h"

namespace glint {

/// z + sqrt(z^2 + alpha^2 sin^2) is 2z / G1; this is the root. w has unit length.
GLINT_HD inline float ggxRoot(const Vec3& w, float alpha) {
    return std::sqrt(square(w.z) + square(alpha) * (square(w.x) + square(w.y)));
}

/// Density of facet normals by solid angle of h, times cos: integrates with cos to 1. h has unit length and
/// h.z > 0. Written with the sine of h, since 1 - cos^2 has no digits left for narrow lobes.
GLINT_HD inline float ggxDistribution(const Vec3& h, float alpha) {
    const float alpha2 = square(alpha);
    const float s = (square(h.x) + square(h.y)) + alpha2 * square(h.z);
    return alpha2 * kInvPi / maxf(square(s), 1e-30f);
}

/// A facet normal of GGX as seen from wo (wo.z >= 0): a reflection on a stretched hemisphere is uniform on a
/// spherical cap (Dupuy and Benyoub 2023, section 3).
GLINT_HD inline Vec3 sampleGgxNormal(const Vec3& wo, float alphaX, float alphaY, Vec2 u) {
    const Vec3 stretched = glm::normalize(Vec3(alphaX * wo.x, alphaY * wo.y, wo.z));
    const SinCos phi = sinCosTurns(u.x);
    const float z = (1.0f - u.y) * (1.0f + stretched.z) - stretched.z;
    const float r = safeSqrt((1.0f - z) * (1.0f + z));
    const Vec3 h(r * phi.cos + stretched.x, r * phi.sin + stretched.y, z + stretched.z);
    const float least = 1e-7f * minf(alphaX, alphaY);
    return glm::normalize(Vec3(alphaX * h.x, alphaY * h.y, maxf(h.z, least)));
}

/// Facets as the models ask for them; GeneralFacets (facets.h) has the same members. Directions away from the
/// surface with z >= 0; half vectors h of unit length with z > 0.
struct GgxFacets {
    float alpha = 1.0f;

    /// The part of facets seen from w that nothing hides (Smith's G1).
    GLINT_HD float visible(const Vec3& w) const { return 2.0f * w.z / maxf(w.z + ggxRoot(w, alpha), 1e-20f); }

    /// A facet normal as seen from wo.
    GLINT_HD Vec3 sampleNormal(const Vec3& wo, Vec2 u) const { return sampleGgxNormal(wo, alpha, alpha, u); }

    /// Its density by solid angle: G1(wo) D(h) (wo . h) / wo.z. 0 where wo . h <= 0.
    GLINT_HD float normalPdf(const Vec3& wo, const Vec3& h) const {
        const float cosine = maxf(glm::dot(wo, h), 0.0f);
        return 2.0f * ggxDistribution(h, alpha) * cosine / maxf(wo.z + ggxRoot(wo, alpha), 1e-20f);
    }

    /// Reflection from wo to wi, both with z > 0, half vector h: D G2 / (4 wo.z), which is f |cos| without
    /// Fresnel. G2 is height-correlated (Heitz 2014, eq. 99).
    GLINT_HD float reflection(const Vec3& wo, const Vec3& wi, const Vec3& h) const {
        const float shared = wo.z * ggxRoot(wi, alpha) + wi.z * ggxRoot(wo, alpha);
        return 0.5f * ggxDistribution(h, alpha) * wi.z / maxf(shared, 1e-20f);
    }

    /// Its density under sampleNormal(wo) and reflection: G1(wo) D / (4 wo.z).
    GLINT_HD float reflectionPdf(const Vec3& wo, const Vec3& h) const {
        return 0.5f * ggxDistribution(h, alpha) / maxf(wo.z + ggxRoot(wo, alpha), 1e-20f);
    }

    /// G2 / G1(wo): the weight, without Fresnel, of a reflection on a sampled normal.
    GLINT_HD float reflectionWeight(const Vec3& wo, const Vec3& wi) const {
        const float rootO = ggxRoot(wo, alpha);
        const float rootI = ggxRoot(wi, alpha);
        return wi.z * (wo.z + rootO) / maxf(wo.z * rootI + wi.z * rootO, 1e-20f);
    }
};

}  // namespace glint
