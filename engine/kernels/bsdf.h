// How a surface scatters light: one interface over all materials. Host and device. Called by the path and
// photon kernels.
//
// Directions are in world space, of unit length, and point away from the surface. Compiled for a feature
// mask: a scene of diffuse surfaces only leaves nothing here but Lambert's law. Opaque materials scatter
// alike on both sides. Emission is not looked at.
//
// Shading normals. ns is bent where the perfect reflection about it would fall below the surface (Keller et
// al. 2017, "The Iray Light Transport Simulation and Rendering System", section 4.2), so that no facet turns
// black at grazing angles. Whether a direction reflects or passes is decided by the geometric normal ng: what
// ng and ns do not agree on carries nothing, so no light leaks through. Left out: the correction that
// importance needs where ns differs from ng (Veach 1997, section 5.3).
#pragma once

#include "engine/kernels/bsdf_dielectric.h"
#include "engine/kernels/bsdf_lobes.h"
#include "engine/kernels/bsdf_plastic.h"
#include "engine/kernels/features.h"
#include "engine/kernels/texture.h"

namespace glint {

constexpr FeatureMask kBsdfFeatures = kFeatureDiffuse | kFeatureSpecular | kFeatureDielectric |
                                      kFeatureGlossy | kFeaturePlastic | kFeatureMixture;

/// True for masks whose surfaces are all diffuse: sample() then ignores uLobe and the BSDF needs no frame.
template <FeatureMask kMask>
GLINT_HD constexpr bool isDiffuseOnly() {
    return (kMask & kBsdfFeatures & ~kFeatureDiffuse) == 0;
}

/// Whether sample() looks at its uLobe for any material of such scenes; if not, none need be drawn.
template <FeatureMask kMask>
GLINT_HD constexpr bool usesLobeChoice() {
    return (kMask & (kFeatureDielectric | kFeaturePlastic | kFeatureMixture)) != 0;
}

/// A material at one point, seen from one direction.
template <FeatureMask kMask>
struct Bsdf {
    const MaterialData* material = nullptr;
    Vec3 color{0.0f};    ///< texture and vertex colour included
    Vec3 ngWorld{0.0f};  ///< geometric normal on wo's side
    Vec3 nsWorld{0.0f};  ///< shading normal on wo's side
    Frame frame{};       ///< around nsWorld; not set when isDiffuseOnly()
    Vec3 woLocal{0.0f};  ///< not set when isDiffuseOnly()
    Vec3 ngLocal{0.0f};  ///< not set when isDiffuseOnly()
    float eta = 1.0f;    ///< dielectric: index beyond the surface over index on wo's side
    TransportMode transport = TransportMode::Radiance;
};

struct BsdfSample {
    Vec3 wiWorld{0.0f};
    Vec3 weight{0.0f};           ///< f |cos wi| / density, the lobe's probability included
    float pdfSolidAngle = 0.0f;  ///< density of wi over all lobes; 0 when isSpecular
    float etaScale = 1.0f;       ///< squared relative index that radiance was divided by; Russian roulette
                                 ///< multiplies its throughput by this, or paths die inside glass for nothing
    bool isSpecular = false;     ///< wi is the only direction it could be: no light sampling could find it
    bool isTransmission = false;
    bool valid = false;  ///< false: absorbed; nothing else is set
};

/// f |cos wi| and the density of sample() for the same wi.
struct BsdfValue {
    Vec3 value{0.0f};
    float pdfSolidAngle = 0.0f;
};

namespace detail {

/// ns, or the nearest normal about which wo's mirror direction stays above the surface. All on one side of
/// the surface.
GLINT_HD inline Vec3 bendShadingNormal(const Vec3& wo, const Vec3& ng, const Vec3& ns) {
    const Vec3 mirror = reflect(wo, ns);
    const float above = glm::dot(mirror, ng);
    const float least = minf(0.9f * glm::dot(wo, ng), 0.01f);
    if (above >= least) {
        return ns;
    }
    const Vec3 half = wo + glm::normalize(mirror + (least - above) * ng);
    const float squared = lengthSquared(half);
    return squared > 1e-12f ? half / std::sqrt(squared) : ng;
}

GLINT_HD inline bool isSmooth(const MaterialData& material) { return material.alpha < kSmoothAlpha; }

template <FeatureMask kMask>
GLINT_HD MaterialTag kindOf(const MaterialData& material) {
    return isDiffuseOnly<kMask>() ? MaterialTag::Diffuse : material.kind;
}

/// The colour at a point: the texture or else the material's, times the vertex colour.
template <FeatureMask kMask, class Surface>
GLINT_HD Vec3 surfaceColor(const MaterialData& material, const View<TextureView>& textures,
                           const Surface& surface) {
    Vec3 color = material.color;
    if constexpr (hasFeature<kMask>(kFeatureTextures)) {
        if (material.colorTexture < textures.count) {
            color = glm::clamp(sampleTexture(textures[material.colorTexture], surface.uv), Vec3(0.0f),
                               Vec3(1.0f));
        }
    }
    if constexpr (hasFeature<kMask>(kFeatureMeshColors)) {
        color *= glm::clamp(surface.vertexColor, Vec3(0.0f), Vec3(1.0f));
    }
    return color;
}

}  // namespace detail

/// Surface: surface.h's SurfacePoint, or anything with its ng, ns, uv, vertexColor and material.
template <FeatureMask kMask, class Surface>
GLINT_HD Bsdf<kMask> makeBsdf(const View<MaterialData>& materials, const View<TextureView>& textures,
                              const Surface& surface, const Vec3& woWorld,
                              TransportMode transport = TransportMode::Radiance) {
    Bsdf<kMask> bsdf;
    bsdf.material = &materials[surface.material];
    bsdf.color = detail::surfaceColor<kMask>(*bsdf.material, textures, surface);
    const bool outside = glm::dot(surface.ng, woWorld) >= 0.0f;
    bsdf.ngWorld = outside ? surface.ng : -surface.ng;
    bsdf.nsWorld = bsdf.ngWorld;
    if constexpr (hasFeature<kMask>(kFeatureMeshNormals)) {
        bsdf.nsWorld = detail::bendShadingNormal(woWorld, bsdf.ngWorld, outside ? surface.ns : -surface.ns);
    }
    if constexpr (!isDiffuseOnly<kMask>()) {
        bsdf.frame = Frame::fromNormal(bsdf.nsWorld);
        bsdf.woLocal = bsdf.frame.toLocal(woWorld);
        bsdf.woLocal.z = maxf(bsdf.woLocal.z, 0.0f);
        bsdf.ngLocal =
            hasFeature<kMask>(kFeatureMeshNormals) ? bsdf.frame.toLocal(bsdf.ngWorld) : Vec3(0, 0, 1);
        bsdf.eta = outside ? bsdf.material->ior : 1.0f / bsdf.material->ior;
        bsdf.transport = transport;
    }
    return bsdf;
}

/// View: scene_view.h's SceneView.
template <FeatureMask kMask, class SceneLike, class Surface>
GLINT_HD Bsdf<kMask> makeBsdf(const SceneLike& view, const Surface& surface, const Vec3& woWorld,
                              TransportMode transport = TransportMode::Radiance) {
    return makeBsdf<kMask>(view.materials, view.textures, surface, woWorld, transport);
}

/// True when light sampling is useless here: evaluate() is 0 for every direction.
template <FeatureMask kMask>
GLINT_HD bool isSpecularOnly(const Bsdf<kMask>& bsdf) {
    const MaterialData& material = *bsdf.material;
    switch (detail::kindOf<kMask>(material)) {
        case MaterialTag::Diffuse:
        case MaterialTag::Plastic:
            return false;
        case MaterialTag::Mirror:
            return true;
        case MaterialTag::Conductor:
            return detail::isSmooth(material);
        case MaterialTag::Dielectric:
            return detail::isSmooth(material) || (material.flags & kMaterialThin) != 0;
        case MaterialTag::Mixture:
            return material.mixtureProbability.x <= 0.0f;
    }
    return true;
}

/// The material's colour at the point for denoisers and previews: not an exact albedo (glass: its tint;
/// metal: its reflectance at normal incidence).
template <FeatureMask kMask>
GLINT_HD Vec3 displayAlbedo(const Bsdf<kMask>& bsdf) {
    if (detail::kindOf<kMask>(*bsdf.material) == MaterialTag::Conductor) {
        return bsdf.color * fresnelConductor(1.0f, bsdf.material->eta, bsdf.material->k);
    }
    return bsdf.color;
}

namespace detail {

GLINT_HD inline bool isRoughGlass(const MaterialData& material) {
    return !isSmooth(material) && (material.flags & kMaterialThin) == 0;
}

template <FeatureMask kMask>
GLINT_HD float terminator(const Bsdf<kMask>& bsdf, const Vec3& wiLocal) {
    if constexpr (hasFeature<kMask>(kFeatureMeshNormals)) {
        return shadowTerminator(glm::dot(bsdf.ngLocal, wiLocal), wiLocal.z, bsdf.ngLocal.z);
    }
    return 1.0f;
}

/// Lambert's law without a frame.
template <FeatureMask kMask>
GLINT_HD BsdfValue evaluateDiffuseOnly(const Bsdf<kMask>& bsdf, const Vec3& wiWorld) {
    const float cosine = glm::dot(bsdf.nsWorld, wiWorld);
    const float pdf = cosine * kInvPi;
    if (!(cosine > 0.0f)) {
        return {};
    }
    if constexpr (hasFeature<kMask>(kFeatureMeshNormals)) {
        const float ngWi = glm::dot(bsdf.ngWorld, wiWorld);
        if (!(ngWi > 0.0f)) {
            return {};
        }
        return {bsdf.color * (pdf * shadowTerminator(ngWi, cosine, glm::dot(bsdf.ngWorld, bsdf.nsWorld))),
                pdf};
    }
    return {bsdf.color * pdf, pdf};
}

/// All lobes but the specular ones.
template <FeatureMask kMask>
GLINT_HD LobeValue evaluateLocal(const Bsdf<kMask>& bsdf, const Vec3& wi) {
    const MaterialData& material = *bsdf.material;
    const Vec3& wo = bsdf.woLocal;
    switch (material.kind) {
        case MaterialTag::Diffuse:
            return evaluateDiffuse(bsdf.color * terminator(bsdf, wi), wi);
        case MaterialTag::Mirror:
            break;
        case MaterialTag::Conductor:
            if constexpr (hasFeature<kMask>(kFeatureGlossy)) {
                return isSmooth(material) ? LobeValue{}
                                          : evaluateRoughConductor(material, bsdf.color, wo, wi);
            }
            break;
        case MaterialTag::Dielectric:
            if constexpr (hasFeature<kMask>(kFeatureGlossy) && hasFeature<kMask>(kFeatureDielectric)) {
                return isRoughGlass(material) ? evaluateRoughDielectric(bsdf.color, material.alpha, bsdf.eta,
                                                                        wo, wi, bsdf.transport)
                                              : LobeValue{};
            }
            break;
        case MaterialTag::Plastic:
            if constexpr (hasFeature<kMask>(kFeaturePlastic)) {
                return evaluatePlastic(material, bsdf.color, wo, wi, bsdf.ngLocal);
            }
            break;
        case MaterialTag::Mixture:
            if constexpr (hasFeature<kMask>(kFeatureMixture)) {
                const float diffuse = material.mixtureProbability.x;
                const LobeValue lobe = evaluateDiffuse(bsdf.color * (diffuse * terminator(bsdf, wi)), wi);
                return {lobe.value, lobe.pdfSolidAngle * diffuse};
            }
            break;
    }
    return {};
}

template <FeatureMask kMask>
GLINT_HD LobeSample sampleLambert(const Bsdf<kMask>& bsdf, Vec2 u) {
    LobeSample sample = sampleDiffuse(bsdf.color, u);
    sample.weight *= terminator(bsdf, sample.wiLocal);
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
        case MaterialTag::Diffuse:
            return sampleLambert(bsdf, u);
        case MaterialTag::Mirror:
            if constexpr (hasFeature<kMask>(kFeatureSpecular)) {
                return specularSample(mirrored(bsdf.woLocal), bsdf.color);
            }
            break;
        case MaterialTag::Conductor:
            if constexpr (hasFeature<kMask>(kFeatureGlossy)) {
                if (!isSmooth(material)) {
                    return sampleRoughConductor(material, bsdf.color, bsdf.woLocal, u);
                }
            }
            if constexpr (hasFeature<kMask>(kFeatureSpecular)) {
                return sampleSmoothConductor(material, bsdf.color, bsdf.woLocal);
            }
            break;
        case MaterialTag::Dielectric:
            if constexpr (hasFeature<kMask>(kFeatureDielectric)) {
                return sampleGlass(bsdf, uLobe, u);
            }
            break;
        case MaterialTag::Plastic:
            if constexpr (hasFeature<kMask>(kFeaturePlastic)) {
                return samplePlastic(material, bsdf.color, bsdf.woLocal, bsdf.ngLocal, uLobe, u);
            }
            break;
        case MaterialTag::Mixture:
            if constexpr (hasFeature<kMask>(kFeatureMixture)) {
                return sampleMixture(bsdf, uLobe, u);
            }
            break;
    }
    return {};
}

template <FeatureMask kMask>
GLINT_HD BsdfSample sampleDiffuseOnly(const Bsdf<kMask>& bsdf, Vec2 u) {
    const Vec3 wiLocal = sampleCosineHemisphere(u);
    BsdfSample sample;
    sample.wiWorld = Frame::fromNormal(bsdf.nsWorld).toWorld(wiLocal);
    sample.weight = bsdf.color;
    sample.pdfSolidAngle = wiLocal.z * kInvPi;
    sample.valid = true;
    if constexpr (hasFeature<kMask>(kFeatureMeshNormals)) {
        const float ngWi = glm::dot(bsdf.ngWorld, sample.wiWorld);
        sample.weight *= shadowTerminator(ngWi, wiLocal.z, glm::dot(bsdf.ngWorld, bsdf.nsWorld));
        sample.valid = ngWi > 0.0f;
    }
    return sample;
}

}  // namespace detail

/// f |cos wi| towards wiWorld and the density with which sample() finds it. Specular lobes count for nothing.
template <FeatureMask kMask>
GLINT_HD BsdfValue evaluateWithPdf(const Bsdf<kMask>& bsdf, const Vec3& wiWorld) {
    if constexpr (isDiffuseOnly<kMask>()) {
        return detail::evaluateDiffuseOnly(bsdf, wiWorld);
    } else {
        const Vec3 wi = bsdf.frame.toLocal(wiWorld);
        if (!(glm::dot(bsdf.ngLocal, wi) * wi.z > 0.0f)) {
            return {};
        }
        const LobeValue lobe = detail::evaluateLocal(bsdf, wi);
        return {lobe.value, lobe.pdfSolidAngle};
    }
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
    if constexpr (isDiffuseOnly<kMask>()) {
        return detail::sampleDiffuseOnly(bsdf, u);
    } else {
        const LobeSample lobe = detail::sampleLocal(bsdf, uLobe, u);
        if (!lobe.valid || !(glm::dot(bsdf.ngLocal, lobe.wiLocal) * lobe.wiLocal.z > 0.0f)) {
            return {};
        }
        BsdfSample result;
        result.wiWorld = bsdf.frame.toWorld(lobe.wiLocal);
        result.weight = lobe.weight;
        result.pdfSolidAngle = lobe.pdfSolidAngle;
        result.etaScale = lobe.etaScale;
        result.isSpecular = lobe.isSpecular;
        result.isTransmission = lobe.isTransmission;
        result.valid = true;
        return result;
    }
}

}  // namespace glint
