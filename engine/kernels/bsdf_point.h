// A material at one point, seen from one direction: what evaluating and sampling it start from. Host and
// device. Included by bsdf.h; nothing else should need it.
//
// What diffuse surfaces do without is not stored where the feature mask knows of no others. Every number is
// computed alike for all masks, so that their pictures have the same bits.
#pragma once

#include "engine/kernels/bsdf_lobes.h"
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

/// What lobes other than the diffuse one need; nothing where there are none.
template <bool kNeeded>
struct BsdfLocalFrame {
    Frame frame{};       ///< around nsWorld
    Vec3 woLocal{0.0f};  ///< z >= 0, except for importance that comes from behind ns (bsdf_importance.h)
    float eta = 1.0f;    ///< dielectric: index beyond the surface over index on wo's side
    TransportMode transport = TransportMode::Radiance;
};
template <>
struct BsdfLocalFrame<false> {};

/// A material at one point, seen from one direction.
template <FeatureMask kMask>
struct Bsdf : BsdfLocalFrame<!isDiffuseOnly<kMask>()> {
    const MaterialData* material = nullptr;
    Vec3 color{0.0f};    ///< texture and vertex colour included
    Vec3 ngWorld{0.0f};  ///< geometric normal on wo's side
    Vec3 nsWorld{0.0f};  ///< shading normal on wo's side
    float ngNs = 1.0f;   ///< cosine between the two; exactly 1 where they are the same
};

namespace detail {

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

GLINT_HD inline bool isSmooth(const MaterialData& material) { return material.alpha < kSmoothAlpha; }

template <FeatureMask kMask>
GLINT_HD MaterialKind kindOf(const MaterialData& material) {
    return isDiffuseOnly<kMask>() ? MaterialKind::Diffuse : material.kind;
}

/// Whether some lobe reflects or refracts in one direction only. Such materials keep ns as it is; sample()
/// folds what falls on the wrong side of the surface back instead.
template <FeatureMask kMask>
GLINT_HD bool hasSpecularLobe(const MaterialData& material) {
    switch (kindOf<kMask>(material)) {
        case MaterialKind::Diffuse:
            return false;
        case MaterialKind::Conductor:
        case MaterialKind::Plastic:
            return isSmooth(material);
        case MaterialKind::Dielectric:
            return isSmooth(material) || (material.flags & kMaterialThin) != 0;
        case MaterialKind::Mirror:
        case MaterialKind::Mixture:
            return true;
    }
    return false;
}

/// The shading normal that a BSDF uses; ng and ns on wo's side. Power that comes from wo leaves diffuse
/// surfaces in every direction above them, however a path that looks at them bends ns.
template <FeatureMask kMask>
GLINT_HD Vec3 usedShadingNormal(const MaterialData& material, const Vec3& wo, const Vec3& ng, const Vec3& ns,
                                TransportMode transport) {
    if (hasSpecularLobe<kMask>(material)) { return ns; }
    const bool anyDirection =
        transport == TransportMode::Importance && kindOf<kMask>(material) == MaterialKind::Diffuse;
    return anyDirection ? ng : bendShadingNormal(wo, ng, ns);
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

/// The axes that local directions of the BSDF refer to.
template <FeatureMask kMask>
GLINT_HD Frame frameOf(const Bsdf<kMask>& bsdf) {
    if constexpr (isDiffuseOnly<kMask>()) {
        return Frame::fromNormal(bsdf.nsWorld);
    } else {
        return bsdf.frame;
    }
}

/// A world direction in the local frame; x and y are left out where nothing looks at them.
template <FeatureMask kMask>
GLINT_HD Vec3 toLocal(const Bsdf<kMask>& bsdf, const Vec3& wiWorld) {
    if constexpr (isDiffuseOnly<kMask>()) {
        return {0.0f, 0.0f, glm::dot(wiWorld, bsdf.nsWorld)};
    } else {
        return bsdf.frame.toLocal(wiWorld);
    }
}

/// wi's cosine with the geometric normal; nsWi: its cosine with the shading normal.
template <FeatureMask kMask>
GLINT_HD float geometricCosine(const Bsdf<kMask>& bsdf, const Vec3& wiWorld, float nsWi) {
    if constexpr (hasFeature<kMask>(kFeatureMeshNormals)) {
        if (bsdf.ngNs < 1.0f) { return glm::dot(bsdf.ngWorld, wiWorld); }
    }
    return nsWi;
}

/// How much the shadow terminator leaves of diffuse reflection. Arguments: wi's cosines with both normals.
template <FeatureMask kMask>
GLINT_HD float terminator(const Bsdf<kMask>& bsdf, float ngWi, float nsWi) {
    return hasFeature<kMask>(kFeatureMeshNormals) ? shadowTerminator(ngWi, nsWi, bsdf.ngNs) : 1.0f;
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
        bsdf.nsWorld = detail::usedShadingNormal<kMask>(*bsdf.material, woWorld, bsdf.ngWorld,
                                                        outside ? surface.ns : -surface.ns, transport);
        bsdf.ngNs = bsdf.nsWorld == bsdf.ngWorld ? 1.0f : glm::dot(bsdf.ngWorld, bsdf.nsWorld);
    }
    if constexpr (!isDiffuseOnly<kMask>()) {
        bsdf.frame = Frame::fromNormal(bsdf.nsWorld);
        bsdf.woLocal = bsdf.frame.toLocal(woWorld);
        if (bsdf.ngNs < 1.0f && detail::hasSpecularLobe<kMask>(*bsdf.material)) {
            if (transport == TransportMode::Radiance) { bsdf.woLocal.z = std::fabs(bsdf.woLocal.z); }
        } else {
            bsdf.woLocal.z = maxf(bsdf.woLocal.z, 0.0f);
        }
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

}  // namespace glint
