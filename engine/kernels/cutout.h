// Surfaces that are not there everywhere: by a material's opacity and by the alpha of its colour's image.
// Host and device; called for every hit of cut-out materials, so that rays of all kinds agree.
//
// A surface of opacity a meets a share a of all rays, whole, and lets the others pass. Which ones is a hash
// of the ray and of the place: no ray asks twice and gets two answers, neighbouring layers are independent,
// and a picture has the same bits on every device. Left out: refraction by what is half there.
#pragma once

#include <bit>

#include "engine/kernels/hit.h"
#include "engine/kernels/object_surface.h"
#include "engine/kernels/texture.h"
#include "engine/math/rng.h"

namespace glint {

/// The share of the surface that is there at texture coordinates uv, from 0 to 1. A texture with alpha gives
/// that, others their channel.
template <FeatureMask kMask>
GLINT_HD inline float opacityAt(const SceneView& view, const MaterialData& material, const Vec2& uv) {
    float opacity = material.opacity;
    if constexpr (hasFeature<kMask>(kFeatureCutouts)) {
        if (material.opacityTexture < view.textures.count) {
            const TextureView& texture = view.textures[material.opacityTexture];
            opacity = texture.alpha != nullptr
                          ? detail::adjusted<kMask>(texture, sampleAlpha<kMask>(texture, uv))
                          : sampleNumber<kMask>(texture, uv);
        }
        if (material.alphaTexture < view.textures.count) {
            opacity *= sampleAlpha<kMask>(view.textures[material.alphaTexture], uv);
        }
    }
    return clampf(opacity, 0.0f, 1.0f);
}

namespace detail {

/// A number in [0, 1) that only this hit of this ray has.
GLINT_HD inline float cutoutNumber(const Ray& ray, const Hit& hit, const Vec2& uv) {
    const auto join = [](float a, float b) {
        return static_cast<uint64_t>(std::bit_cast<uint32_t>(a)) << 32 | std::bit_cast<uint32_t>(b);
    };
    uint64_t hash = mixBits(join(ray.origin.x, ray.origin.y) + 1);
    hash = mixBits(hash ^ join(ray.origin.z, ray.direction.x));
    hash = mixBits(hash ^ join(ray.direction.y, ray.direction.z));
    hash = mixBits(hash ^ join(uv.x, uv.y));
    hash = mixBits(hash ^ (static_cast<uint64_t>(hit.instance) << 32 | hit.primitive));
    return uniformFloat(static_cast<uint32_t>(hash >> 32));
}

}  // namespace detail

/// Whether the surface may let rays pass that meet it.
GLINT_HD inline bool isCutOut(const SceneView& view, const Hit& hit) {
    return (materialFlagsOf(view, view.geometry.instances[hit.instance]) & kMaterialCutOut) != 0;
}

/// Whether the ray passes where it meets a cut-out surface.
template <FeatureMask kMask>
GLINT_HD inline bool passesCutout(const SceneView& view, const Ray& ray, const Hit& hit) {
    Vec3 unused;
    const Vec2 uv = objectPointAt<kMask>(view, ray, hit, &unused).uv;
    const MaterialData& material = view.materials[view.geometry.instances[hit.instance].material];
    return !(detail::cutoutNumber(ray, hit, uv) < opacityAt<kMask>(view, material, uv));
}

}  // namespace glint
