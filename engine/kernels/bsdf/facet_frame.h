// The local frame of a material at a point: which way its facets lie. Host and device.
#pragma once

#include "engine/kernels/bsdf/facets.h"
#include "engine/kernels/bump.h"

namespace glint {
namespace detail {

/// v in the plane of unit normal n, of unit length; zero where there is nothing of it.
GLINT_HD inline Vec3 directionInPlane(const Vec3& v, const Vec3& n) {
    return normalizeOr(v - glm::dot(v, n) * n, Vec3(0.0f));
}

/// Which way a quarter turn about n goes that leads from t.dpdu towards t.dpdv.
GLINT_HD inline float turnSign(const Tangents& t, const Vec3& n) {
    return glm::dot(glm::cross(n, t.dpdu), t.dpdv) < 0.0f ? -1.0f : 1.0f;
}

/// The direction of the first roughness; zero where the surface has none. A texture's is as a normal map's: x
/// to the image's right, y to its top.
template <FeatureMask kMask, class Scene, class Surface>
GLINT_HD Vec3 facetAxis(const Bsdf<kMask>& bsdf, const Scene& scene, const Surface& surface) {
    if constexpr (requires { surface.facetAxis; }) {
        return surface.facetAxis;
    } else {
        const Vec3& n = bsdf.nsWorld;
        const Tangents tangents{surface.dpdu, surface.dpdv};
        Tangents axes = tangents;
        const uint32_t texture = bsdf.material->textures.anisotropyDirection.index;
        if (texture < scene.textures.count) {
            axes = imageAxes<kMask>(scene.textures[texture], surface.uv, tangents);
            if constexpr (requires { hasOwnTangents<kMask>(scene, surface.instance); }) {
                if (hasOwnTangents<kMask>(scene, surface.instance)) {
                    axes = ownImageAxes(scene.textures[texture], tangents);
                }
            }
        }
        const Vec3& code = bsdf.inputs().anisotropyDirection;
        const Vec3 right = directionInPlane(axes.dpdu, n);
        const Vec3 along = (2.0f * code.x - 1.0f) * right +
                           ((2.0f * code.y - 1.0f) * turnSign(axes, n)) * glm::cross(n, right);
        const Vec2& turn = bsdf.material->facetTurn;
        return turn.x * along + (turn.y * turnSign(tangents, n)) * glm::cross(n, along);
    }
}

/// Turns the frame around the shading normal along the facets, where these have a direction. Others do
/// without dpdu, since uvs that nothing looks at may not have been read.
template <FeatureMask kMask, class Scene, class Surface>
GLINT_HD void turnAlongFacets(const Scene& scene, const Surface& surface, Bsdf<kMask>* bsdf) {
    const ShadingInputs& in = bsdf->inputs();
    if (!hasGeneralFacets<kMask>(*bsdf->material) || in.roughness == in.crossRoughness) { return; }
    const Vec3 s = directionInPlane(facetAxis(*bsdf, scene, surface), bsdf->frame.n);
    if (isZero(s)) { return; }
    bsdf->frame.s = s;
    bsdf->frame.t = glm::cross(bsdf->frame.n, s);
}

}  // namespace detail
}  // namespace glint
