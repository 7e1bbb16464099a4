// Light from infinitely far away: the radiance of a direction, and choosing directions by it.
//
// The mapping is described at EnvironmentView.
#pragma once

#include "engine/kernels/environment_portal.h"
#include "engine/kernels/features.h"
#include "engine/kernels/light_tree.h"
#include "engine/kernels/scene_view.h"
#include "engine/math/frame.h"
#include "engine/math/warp.h"

namespace glint {

/// World direction into the image's own directions, and back.
GLINT_HD inline Vec3 toEnvironment(const EnvironmentView& e, const Vec3& w) {
    return {e.cosRotation * w.x - e.sinRotation * w.z, w.y, e.sinRotation * w.x + e.cosRotation * w.z};
}
GLINT_HD inline Vec3 fromEnvironment(const EnvironmentView& e, const Vec3& w) {
    return {e.cosRotation * w.x + e.sinRotation * w.z, w.y, -e.sinRotation * w.x + e.cosRotation * w.z};
}

/// Image coordinates in [0, 1] of a unit direction (image space), (0, 0) at the top left corner.
GLINT_HD inline Vec2 environmentUv(const Vec3& w) {
    const float u = 0.5f + std::atan2(w.x, -w.z) * (0.5f * kInvPi);
    const float v =
        std::atan2(std::sqrt(w.x * w.x + w.z * w.z), w.y) * kInvPi;  // accurate near the poles, unlike acos
    return {u, v};
}

GLINT_HD inline Vec3 environmentTexel(const EnvironmentView& e, int x, int y) {
    const int column = x < 0 ? x + e.width : (x >= e.width ? x - e.width : x);
    const int row = y < 0 ? 0 : (y >= e.height ? e.height - 1 : y);
    const size_t index =
        3 * (static_cast<size_t>(row) * static_cast<size_t>(e.width) + static_cast<size_t>(column));
    if (e.texels == nullptr) {
        const uint8_t* bytes = e.bytes + index;
        return {e.decoded[bytes[0]], e.decoded[bytes[1]], e.decoded[bytes[2]]};
    }
    const float* texel = e.texels + index;
    return {texel[0], texel[1], texel[2]};
}

/// Bilinear; wraps around horizontally, and the outermost rows reach to the poles.
GLINT_HD inline Vec3 environmentLookup(const EnvironmentView& e, const Vec2& uv) {
    const float x = uv.x * static_cast<float>(e.width) - 0.5f;
    const float y = uv.y * static_cast<float>(e.height) - 0.5f;
    const float x0 = std::floor(x), y0 = std::floor(y);
    const float fx = x - x0, fy = y - y0;
    const int ix = static_cast<int>(x0), iy = static_cast<int>(y0);
    const Vec3 top = (1.0f - fx) * environmentTexel(e, ix, iy) + fx * environmentTexel(e, ix + 1, iy);
    const Vec3 bottom =
        (1.0f - fx) * environmentTexel(e, ix, iy + 1) + fx * environmentTexel(e, ix + 1, iy + 1);
    return (1.0f - fy) * top + fy * bottom;
}

/// Radiance that arrives from the unit direction `w` where no portal is in its way; 0 without an environment.
template <FeatureMask kMask>
GLINT_HD inline Vec3 environmentRadiance(const SceneView& view, const Vec3& w) {
    const LightView& lights = view.lights;
    if constexpr (hasFeature<kMask>(kFeatureEnvironmentImage)) {
        if (lights.environment.width > 0) {
            const Vec2 uv = environmentUv(toEnvironment(lights.environment, w));
            return lights.environmentRadiance * environmentLookup(lights.environment, uv);
        }
    }
    if constexpr (hasFeature<kMask>(kFeatureEnvironmentConstant)) { return lights.environmentRadiance; }
    return Vec3(0.0f);
}

/// What arrives at the place `p`.
template <FeatureMask kMask>
GLINT_HD inline Vec3 environmentRadiance(const SceneView& view, const Vec3& p, const Vec3& w) {
    if constexpr (hasFeature<kMask>(kFeaturePortal)) {
        const PortalView& portal = view.lights.portal;
        if (hasPortal(portal) && !seesThroughPortal(portal, p, w)) { return Vec3(0.0f); }
    }
    return environmentRadiance<kMask>(view, w);
}

/// The last entry of an increasing table (of count + 1 entries from 0 to 1) that is at most `u` and has a
/// successor above it; `u` in [0, 1).
GLINT_HD inline int findInterval(const float* cdf, int count, float u) {
    int lo = 0, hi = count;
    while (hi - lo > 1) {
        const int middle = (lo + hi) / 2;
        if (cdf[middle] <= u) {
            lo = middle;
        } else {
            hi = middle;
        }
    }
    return lo;
}

GLINT_HD inline float environmentCellPdf(const EnvironmentView& e, int x, int y, float sinTheta) {
    const float* columns = e.columnCdf + static_cast<size_t>(y) * static_cast<size_t>(e.width + 1);
    const float pdfUv = (e.rowCdf[y + 1] - e.rowCdf[y]) * static_cast<float>(e.height) *
                        (columns[x + 1] - columns[x]) * static_cast<float>(e.width);
    return sinTheta > 0.0f ? pdfUv / (2.0f * kPi * kPi * sinTheta) : 0.0f;
}

/// A direction by the image's brightness, piecewise uniform in image coordinates over each texel's cell.
GLINT_HD inline DirectionSample sampleEnvironmentImage(const EnvironmentView& e, const Vec2& u) {
    const int y = findInterval(e.rowCdf, e.height, u.y);
    const float* columns = e.columnCdf + static_cast<size_t>(y) * static_cast<size_t>(e.width + 1);
    const int x = findInterval(columns, e.width, u.x);
    const float rowWidth = e.rowCdf[y + 1] - e.rowCdf[y];
    const float columnWidth = columns[x + 1] - columns[x];
    if (!(rowWidth > 0.0f && columnWidth > 0.0f)) { return {}; }
    const float fy = (u.y - e.rowCdf[y]) / rowWidth;
    const float fx = (u.x - columns[x]) / columnWidth;
    const float theta = (static_cast<float>(y) + fy) / static_cast<float>(e.height) * kPi;
    const float phi = ((static_cast<float>(x) + fx) / static_cast<float>(e.width) - 0.5f) * kTwoPi;
    const float sinTheta = std::sin(theta);
    const Vec3 w(sinTheta * std::sin(phi), std::cos(theta), -sinTheta * std::cos(phi));
    return {fromEnvironment(e, w), environmentCellPdf(e, x, y, sinTheta)};
}

GLINT_HD inline float pdfEnvironmentImage(const EnvironmentView& e, const Vec3& wiWorld) {
    const Vec3 w = toEnvironment(e, wiWorld);
    const Vec2 uv = environmentUv(w);
    const int x =
        static_cast<int>(clampf(uv.x * static_cast<float>(e.width), 0.0f, static_cast<float>(e.width - 1)));
    const int y =
        static_cast<int>(clampf(uv.y * static_cast<float>(e.height), 0.0f, static_cast<float>(e.height - 1)));
    return environmentCellPdf(e, x, y, std::sqrt(w.x * w.x + w.z * w.z));
}

/// A constant environment: by the cosine where only one side counts, otherwise uniformly.
GLINT_HD inline DirectionSample sampleEnvironmentConstant(const LightContext& at, const Vec2& u) {
    if (at.bothSides) { return {sampleSphere(u), 0.25f * kInvPi}; }
    const Vec3 local = sampleCosineHemisphere(u);
    return {Frame::fromNormal(at.n).toWorld(local), local.z * kInvPi};
}

GLINT_HD inline float pdfEnvironmentConstant(const LightContext& at, const Vec3& wiWorld) {
    return at.bothSides ? 0.25f * kInvPi : maxf(glm::dot(at.n, wiWorld), 0.0f) * kInvPi;
}

template <FeatureMask kMask>
GLINT_HD inline DirectionSample sampleEnvironment(const LightView& lights, const LightContext& at,
                                                  const Vec2& u) {
    if constexpr (hasFeature<kMask>(kFeaturePortal)) {
        if (hasPortal(lights.portal)) { return samplePortal(lights.portal, at.p, u); }
    }
    if constexpr (hasFeature<kMask>(kFeatureEnvironmentImage)) {
        if (lights.environment.width > 0) { return sampleEnvironmentImage(lights.environment, u); }
    }
    return sampleEnvironmentConstant(at, u);
}

/// Density of sampleEnvironment() for a unit direction.
template <FeatureMask kMask>
GLINT_HD inline float pdfEnvironment(const LightView& lights, const LightContext& at, const Vec3& wiWorld) {
    if constexpr (hasFeature<kMask>(kFeaturePortal)) {
        if (hasPortal(lights.portal)) { return pdfPortal(lights.portal, at.p, wiWorld); }
    }
    if constexpr (hasFeature<kMask>(kFeatureEnvironmentImage)) {
        if (lights.environment.width > 0) { return pdfEnvironmentImage(lights.environment, wiWorld); }
    }
    return pdfEnvironmentConstant(at, wiWorld);
}

}  // namespace glint
