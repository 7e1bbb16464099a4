// Height maps and tangent-space normal maps: what they make of a shading normal. Host and device; called at
// the end of surfaceAt() (surface.h), so that every integrator sees the same.
//
// Heights: Blinn 1978, "Simulation of Wrinkled Surfaces", by the surface's gradient (Mikkelsen 2010, "Bump
// Mapping Unparametrized Surfaces on the GPU"), from central differences of half a texel to each side, in
// which the slope of a bilinear image is continuous. Normal maps: x is the image's right, y its top, 0.5
// stands for 0. Where both are given, heights are on top of the normal map. Neither moves the surface: its
// outline, its shadows and what hides in its valleys stay as they are.
//
// The result stays on the geometric normal's side, and how far that is from being so depends on the
// place alone: photons and camera paths see one normal. What each direction sees of it is the BSDF's
// matter (bsdf/bsdf.h).
#pragma once

#include "engine/kernels/object_surface.h"
#include "engine/kernels/texture.h"
#include "engine/math/frame.h"

namespace glint {
namespace detail {

/// The least cosine of a perturbed normal with the geometric one.
constexpr float kLeastBumpCosine = 0.02f;
/// No step along u or v is less than this part of the other, so that slopes stay bounded at a sphere's poles.
constexpr float kLeastStepRatio = 0.125f;

/// Half a texel, in u and in v.
GLINT_HD inline Vec2 halfTexel(const TextureView& texture) {
    const Vec2 size(static_cast<float>(texture.width), static_cast<float>(texture.height));
    return {0.5f / (std::fabs(texture.scale.x) * glm::length(texture.turn * size)),
            0.5f / (std::fabs(texture.scale.y) * glm::length(Vec2(texture.turn.y, texture.turn.x) * size))};
}

/// The height's slope along a unit tangent: `step` in uv is `length` of the way.
template <FeatureMask kMask>
GLINT_HD inline float heightSlope(const TextureView& texture, const Vec2& uv, float uvWidth, const Vec2& step,
                                  float length) {
    const float rise =
        sampleNumber<kMask>(texture, uv + step, uvWidth) - sampleNumber<kMask>(texture, uv - step, uvWidth);
    return length > 0.0f ? rise / (2.0f * length) : 0.0f;
}

/// `n` as a surface of the texture's heights has it. Lengths in world space.
template <FeatureMask kMask>
GLINT_HD inline Vec3 raisedNormal(const TextureView& texture, float heightScale, const Vec2& uv,
                                  float uvWidth, const Tangents& tangents, const Vec3& n) {
    const float perU = glm::length(tangents.dpdu), perV = glm::length(tangents.dpdv);
    Vec2 half = halfTexel(texture);
    if (hasFeature<kMask>(kFeatureMipmaps) && texture.mips != nullptr) {
        half = glm::max(half, Vec2(0.5f * uvWidth));
    }
    const float least = kLeastStepRatio * maxf(half.x * perU, half.y * perV);
    const auto slope = [&](float step, float per, const Vec2& axis) {
        const float wide = step * per < least ? minf(least / per, 0.25f) : step;
        return heightScale * heightSlope<kMask>(texture, uv, uvWidth, wide * axis, maxf(wide * per, least));
    };
    const Vec3 u = normalizeOr(tangents.dpdu, Vec3(0.0f));
    const Vec3 v = normalizeOr(tangents.dpdv, Vec3(0.0f));
    const Vec3 alongU = isZero(u) ? glm::cross(v, n) : u;
    const float determinant = glm::dot(n, glm::cross(alongU, v));
    if (!(std::fabs(determinant) > 1e-3f)) { return n; }
    const Vec3 gradient = (slope(half.x, perU, Vec2(1.0f, 0.0f)) * glm::cross(v, n) +
                           slope(half.y, perV, Vec2(0.0f, 1.0f)) * glm::cross(n, alongU)) /
                          determinant;
    return normalizeOr(n - gradient, n);
}

/// The image's right and top on the surface.
template <FeatureMask kMask>
GLINT_HD inline Tangents imageAxes(const TextureView& texture, const Vec2& uv, const Tangents& t) {
    const Vec2 c = texture.turn;
    Tangents axes{t.dpdu * (c.x / texture.scale.x) - t.dpdv * (c.y / texture.scale.y),
                  t.dpdu * (c.y / texture.scale.x) + t.dpdv * (c.x / texture.scale.y)};
    const Vec2 place = placedUv<kMask>(texture, uv);
    const auto isTurnedOver = [](WrapMode wrap, float x) {
        return wrap == WrapMode::Mirror && 0.5f * std::floor(x) != std::floor(0.5f * std::floor(x));
    };
    if (isTurnedOver(texture.wrapU, place.x)) { axes.dpdu = -axes.dpdu; }
    if (isTurnedOver(texture.wrapV, place.y) != texture.flipV) { axes.dpdv = -axes.dpdv; }
    return axes;
}

/// The same where a mesh says itself how u and v run: the image's placement does not turn them.
GLINT_HD inline Tangents ownImageAxes(const TextureView& texture, const Tangents& own) {
    return {own.dpdu, texture.flipV ? -own.dpdv : own.dpdv};
}

/// `n` turned as a coded normal says, x and y of which are multiplied by `strength`.
GLINT_HD inline Vec3 mappedNormal(const Vec3& code, float strength, const Tangents& axes, const Vec3& n) {
    const Vec3 local = 2.0f * code - Vec3(1.0f);
    const Vec3 right = normalizeOr(axes.dpdu - glm::dot(axes.dpdu, n) * n, Frame::fromNormal(n).s);
    Vec3 top = glm::cross(n, right);
    if (glm::dot(top, axes.dpdv) < 0.0f) { top = -top; }
    return normalizeOr(strength * (local.x * right + local.y * top) + maxf(local.z, kLeastBumpCosine) * n, n);
}

}  // namespace detail

/// The shading normal that the material makes of `ns` at uv; ng on its side, all in world space. uvWidth:
/// what a pixel covers of u and v, 0 where that is not known. own: ownTangentsAt() the place, which normal
/// maps lie by, where heights need derivatives.
template <FeatureMask kMask>
GLINT_HD inline Vec3 perturbedNormal(const SceneView& view, const MaterialData& material, const Vec2& uv,
                                     float uvWidth, const Tangents& tangents, const Tangents& own,
                                     const Vec3& ng, const Vec3& ns) {
    const bool isCoded = material.normalTexture < view.textures.count, isOwn = !isZero(own.dpdu);
    Vec3 code = material.normalCode;
    Tangents axes = isOwn ? own : tangents;
    if (isCoded) {
        const TextureView& texture = view.textures[material.normalTexture];
        code = sampleNumbers<kMask>(texture, uv, uvWidth);
        axes = isOwn ? detail::ownImageAxes(texture, own) : detail::imageAxes<kMask>(texture, uv, tangents);
    }
    Vec3 n = isFinite(code) ? detail::mappedNormal(code, material.normalStrength, axes, ns) : ns;
    if (material.heightTexture < view.textures.count) {
        n = detail::raisedNormal<kMask>(view.textures[material.heightTexture], material.bumpHeight, uv,
                                        uvWidth, tangents, n);
    }
    const float above = glm::dot(n, ng);
    if (above >= detail::kLeastBumpCosine) { return n; }
    return normalizeOr(n + (detail::kLeastBumpCosine - above) * ng, ng);
}

}  // namespace glint
