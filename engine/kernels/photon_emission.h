// Photons leaving lights: one light by its power, one point on it, one direction.
//
// Every light kind emits: area lights by area and cosine, spheres over their whole surface, point and spot
// lights from their place, directional lights and the environment from a disc that covers the scene, or from
// its portal. Infinite emissive planes do not emit photons: their power has no bound. What they light is
// found by the camera path's own sampling.
#pragma once

#include "engine/kernels/environment.h"
#include "engine/kernels/intersect.h"
#include "engine/kernels/light_sampling.h"
#include "engine/kernels/scene_view.h"
#include "engine/kernels/surface.h"
#include "engine/math/warp.h"

namespace glint {

/// How photons are shared out among the lights: builders/power_distribution.h.
struct PowerDistributionView {
    /// emitterCount + 1 entries from 0 to 1, in the order of LightView::emitters
    const float* cdf = nullptr;
    uint32_t emitterCount = 0;  ///< 0: nothing emits photons
    float totalPower = 0.0f;    ///< luminance, W
};

/// A photon on its way: where it goes and what it carries if it stood for all emitted light alone.
struct EmittedPhoton {
    Ray ray;
    Vec3 flux{0.0f};  ///< W per channel; zero: nothing was emitted
    uint32_t emitter = 0;
};

namespace detail {

/// Cosine-distributed from a point uniform by area: radiance * pi / pdfArea, whatever was sampled. A
/// two-sided emitter picks its side by stretching u.
template <FeatureMask kMask>
GLINT_HD inline EmittedPhoton emitFromArea(const SceneView& view, const EmitterData& e, const Vec2& uPoint,
                                           const Vec2& uDirection) {
    EmittedPhoton photon;
    const EmitterPoint point = visitShape<EmitterPoint, kMask>(
        e.shape, [&](auto shape) { return decltype(shape)::sampleArea(view.geometry, e, uPoint); });
    if (!(point.pdf > 0.0f) || !std::isfinite(point.pdf)) { return photon; }
    SurfacePoint surface{};
    surface.p = point.p;
    surface.pError = point.pError;
    surface.ng = point.normal;
    Vec2 u = uDirection;
    float side = 1.0f;
    if (e.emitsBothSides) {
        side = u.x < 0.5f ? 1.0f : -1.0f;
        u.x = u.x < 0.5f ? 2.0f * u.x : 2.0f * u.x - 1.0f;
    }
    const Vec3 direction = Frame::fromNormal(side * surface.ng).toWorld(sampleCosineHemisphere(u));
    photon.ray = spawnRay(surface, direction);
    photon.flux =
        emitterRadiance<kMask>(view, e, point.p) * (kPi / point.pdf * (e.emitsBothSides ? 2.0f : 1.0f));
    return photon;
}

GLINT_HD inline EmittedPhoton emitFromPoint(const EmitterData& e, const Vec2& uDirection) {
    EmittedPhoton photon;
    photon.ray.origin = e.position;
    if (e.kind == EmitterKind::Spot) {
        const Vec3 local = sampleCone(uDirection, e.oneMinusCosOuter);
        photon.ray.direction = Frame::fromNormal(e.direction).toWorld(local);
        photon.flux =
            e.radiance * (spotFalloff(e, uDirection.x * e.oneMinusCosOuter) * kTwoPi * e.oneMinusCosOuter);
    } else {
        photon.ray.direction = sampleSphere(uDirection);
        photon.flux = e.radiance * (2.0f * kTwoPi);
    }
    return photon;
}

/// Uniform over the picture on the plane at a distance of 1.
template <FeatureMask kMask>
GLINT_HD inline EmittedPhoton emitFromProjector(const SceneView& view, const EmitterData& e,
                                                const Vec2& uDirection) {
    EmittedPhoton photon;
    const Vec2 place = 2.0f * uDirection - Vec2(1.0f);
    photon.ray.origin = e.position;
    photon.ray.direction = glm::normalize(e.direction + place.x * e.axisU + place.y * e.axisV);
    const float area = 4.0f * std::sqrt(lengthSquared(e.axisU) * lengthSquared(e.axisV));
    float cosine;
    const Vec3 intensity = projectedIntensity<kMask>(view, e, photon.ray.direction, &cosine);
    photon.flux = intensity * (area * cosine * cosine * cosine);
    return photon;
}

/// Uniform over all directions.
template <FeatureMask kMask>
GLINT_HD inline EmittedPhoton emitFromGoniometric(const SceneView& view, const EmitterData& e,
                                                  const Vec2& uDirection) {
    EmittedPhoton photon;
    photon.ray.origin = e.position;
    photon.ray.direction = sampleSphere(uDirection);
    photon.flux = goniometricIntensity<kMask>(view, e, photon.ray.direction) * (2.0f * kTwoPi);
    return photon;
}

/// From outside the scene's bounding sphere, along `direction`, uniform over the sphere's shadow.
GLINT_HD inline Ray rayFromFarAway(const SceneView& view, const Vec3& direction, const Vec2& uPoint) {
    const Vec2 d = sampleDisc(uPoint);
    const Frame frame = Frame::fromNormal(direction);
    Ray ray;
    ray.origin = view.sceneCenter + view.sceneRadius * (d.x * frame.s + d.y * frame.t - direction);
    ray.direction = direction;
    return ray;
}

/// Uniform over the portal. What stands before it, outside, keeps light from what is inside, as it does from
/// shadow rays, and is not lit itself.
template <FeatureMask kMask>
GLINT_HD inline EmittedPhoton emitFromPortal(const SceneView& view, const Vec2& uPoint,
                                             const Vec2& uDirection) {
    EmittedPhoton photon;
    const PortalView& portal = view.lights.portal;
    const EmitterData& e = portal.opening;
    const DirectionSample towards = samplePortalDirection(portal, uDirection);
    if (!(towards.pdfSolidAngle > 0.0f)) { return photon; }
    Ray outwards;
    outwards.origin = e.position + (2.0f * uPoint.x - 1.0f) * e.axisU + (2.0f * uPoint.y - 1.0f) * e.axisV;
    outwards.direction = towards.wiWorld;
    if (occluded<kMask>(view, outwards)) { return photon; }
    photon.ray.origin = outwards.origin;
    photon.ray.direction = -towards.wiWorld;
    photon.flux = environmentRadiance<kMask>(view, towards.wiWorld) *
                  (e.area * -glm::dot(towards.wiWorld, e.direction) / towards.pdfSolidAngle);
    return photon;
}

template <FeatureMask kMask>
GLINT_HD inline EmittedPhoton emitFromEnvironment(const SceneView& view, const Vec2& uPoint,
                                                  const Vec2& uDirection) {
    if constexpr (hasFeature<kMask>(kFeaturePortal)) {
        if (hasPortal(view.lights.portal)) { return emitFromPortal<kMask>(view, uPoint, uDirection); }
    }
    EmittedPhoton photon;
    LightContext everywhere;
    everywhere.bothSides = true;
    const DirectionSample towards = sampleEnvironment<kMask>(view.lights, everywhere, uDirection);
    if (!(towards.pdfSolidAngle > 0.0f)) { return photon; }
    photon.ray = rayFromFarAway(view, -towards.wiWorld, uPoint);
    photon.flux = environmentRadiance<kMask>(view, towards.wiWorld) *
                  (kPi * square(view.sceneRadius) / towards.pdfSolidAngle);
    return photon;
}

}  // namespace detail

/// One photon from the whole scene: its expected flux is the power of all lights. uChoice, uPoint, uDirection
/// in [0, 1).
template <FeatureMask kMask>
GLINT_HD inline EmittedPhoton emitPhoton(const SceneView& view, const PowerDistributionView& power,
                                         float uChoice, const Vec2& uPoint, const Vec2& uDirection) {
    if (power.emitterCount == 0) { return {}; }
    const int chosen = findInterval(power.cdf, static_cast<int>(power.emitterCount), uChoice);
    const float probability = power.cdf[chosen + 1] - power.cdf[chosen];
    if (!(probability > 0.0f)) { return {}; }
    const EmitterData& e = view.lights.emitters[static_cast<uint32_t>(chosen)];
    EmittedPhoton photon;
    switch (e.kind) {
        case EmitterKind::Environment:
            photon = detail::emitFromEnvironment<kMask>(view, uPoint, uDirection);
            break;
        case EmitterKind::Point:
        case EmitterKind::Spot:
            photon = detail::emitFromPoint(e, uDirection);
            break;
        case EmitterKind::Projector:
        case EmitterKind::Goniometric:
            if constexpr (hasFeature<kMask>(kFeatureProjectors)) {
                photon = e.kind == EmitterKind::Projector
                             ? detail::emitFromProjector<kMask>(view, e, uDirection)
                             : detail::emitFromGoniometric<kMask>(view, e, uDirection);
            }
            break;
        case EmitterKind::Directional:
            photon.ray = detail::rayFromFarAway(view, e.direction, uPoint);
            photon.flux = e.radiance * (kPi * square(view.sceneRadius));
            break;
        case EmitterKind::Shape:
            photon = detail::emitFromArea<kMask>(view, e, uPoint, uDirection);
            break;
    }
    photon.emitter = static_cast<uint32_t>(chosen);
    photon.flux *= 1.0f / probability;
    return photon;
}

}  // namespace glint
