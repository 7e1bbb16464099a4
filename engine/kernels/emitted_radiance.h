// Light that surfaces send out themselves.
#pragma once

#include "engine/kernels/cutout.h"
#include "engine/kernels/surface.h"

namespace glint {
namespace detail {

/// Whether the mask and the material say that the emission is a texture.
template <FeatureMask kMask>
GLINT_HD inline bool emitsTexture(const SceneView& view, const MaterialData& material) {
    return hasFeature<kMask>(kFeatureInputTextures) && material.emissionTexture < view.textures.count;
}

/// The texture coordinates that a hit at the point `p` of an emitter would have.
template <FeatureMask kMask>
GLINT_HD inline Vec2 emitterUv(const GeometryView& geometry, const EmitterData& e, const Vec3& p) {
    const InstanceData& instance = geometry.instances[e.instance];
    if (isMesh<kMask>(instance)) {
        return MeshShape::emitterUv(geometry.meshes[instance.mesh], e, e.original - instance.firstEmitter, p);
    }
    if (isRevolved<kMask>(instance)) {
        return RevolvedShape::emitterUv<kMask>(profileAt(geometry, instance.mesh),
                                               instance.worldToObject.point(p));
    }
    return visitShape<Vec2, kAnalyticOnly<kMask>>(instance.shape, [&](auto shape) {
        return decltype(shape)::template surface<kMask>(instance.worldToObject.point(p)).uv;
    });
}

}  // namespace detail

/// Radiance that an emissive material sends out at texture coordinates uv, on a side that emits. uvWidth:
/// what a pixel covers of them, 0 where that is not known.
template <FeatureMask kMask>
GLINT_HD inline Vec3 emissionAt(const SceneView& view, const MaterialData& material, const Vec2& uv,
                                float uvWidth = 0.0f) {
    if (!detail::emitsTexture<kMask>(view, material)) { return material.emission; }
    return material.emission *
           glm::max(sampleTexture<kMask>(view.textures[material.emissionTexture], uv, uvWidth), Vec3(0.0f));
}

/// Mean radiance of an area emitter at its point p, on a side that emits: nothing comes from where it is cut
/// out, which rays that find it by themselves pass.
template <FeatureMask kMask>
GLINT_HD inline Vec3 emitterRadiance(const SceneView& view, const EmitterData& e, const Vec3& p) {
    if constexpr (hasFeature<kMask>(kFeatureInputTextures | kFeatureCutouts)) {
        const InstanceData& instance = view.geometry.instances[e.instance];
        if ((materialFlagsOf(view, instance) & (kMaterialInputTextures | kMaterialCutOut)) != 0) {
            const MaterialData& material = view.materials[instance.material];
            const Vec2 uv = detail::emitterUv<kMask>(view.geometry, e, p);
            return emissionAt<kMask>(view, material, uv) * opacityAt<kMask>(view, material, uv);
        }
    }
    return e.radiance;
}

/// Radiance that leaves `surface` towards the unit direction woWorld; 0 from the back of a one-sided emitter.
/// uvWidth: as emissionAt() says.
template <FeatureMask kMask>
GLINT_HD inline Vec3 emittedRadiance(const SceneView& view, const SurfacePoint& surface, const Vec3& woWorld,
                                     float uvWidth = 0.0f) {
    const MaterialData& material = view.materials[surface.material];
    if ((material.flags & kMaterialEmissive) == 0) { return Vec3(0.0f); }
    const bool seen = (material.flags & kMaterialEmitsBothSides) != 0 || glm::dot(woWorld, surface.ng) > 0.0f;
    return seen ? emissionAt<kMask>(view, material, surface.uv, uvWidth) : Vec3(0.0f);
}

}  // namespace glint
