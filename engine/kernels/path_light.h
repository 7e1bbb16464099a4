// A path on its way, and the light that it gathers: what it runs into, and next-event estimation. Host and
// device. The path kernel and the camera half of SPPM follow paths.
#pragma once

#include "engine/kernels/bsdf/bsdf.h"
#include "engine/kernels/emitted_radiance.h"
#include "engine/kernels/glass_stack.h"
#include "engine/kernels/intersect.h"
#include "engine/kernels/light_sampling.h"
#include "engine/kernels/path_log.h"
#include "engine/kernels/ray_cone.h"
#include "engine/kernels/sampler.h"
#include "engine/kernels/spectrum.h"
#include "engine/kernels/surface.h"

namespace glint {

/// A path on its way. The context and the density belong to the vertex that the current ray left.
struct PathState {
    Ray ray;
    Vec3 throughput{1.0f};
    Vec3 radiance{0.0f};
    RayCone cone;        ///< looked at by masks with mip maps only
    GlassStack glasses;  ///< likewise, with attenuation
    LightContext context;
    Wavelength wavelength;
    float pdfBsdf = 0.0f;
    /// undoes refraction's squared index ratio for the roulette, which it says nothing about
    float etaScale = 1.0f;
    int depth = 0;  ///< scattering events so far
    /// light sampling could not find the ray: it left the camera or a specular vertex
    bool specularBounce = true;
    uint32_t rays = 0;
};

/// Power heuristic with exponent 2 (Veach and Guibas 1995), in a form that does not overflow.
GLINT_HD inline float powerHeuristic(float pdfUsed, float pdfOther) {
    const float ratio = pdfOther / pdfUsed;
    return 1.0f / (1.0f + ratio * ratio);
}

/// Weight of light that the path ran into and light sampling would have found with density pdfLight
/// (0: never).
GLINT_HD inline float hitLightWeight(const PassParams& params, const PathState& path, float pdfLight) {
    if (path.specularBounce || !(pdfLight > 0.0f) || params.directLight == DirectLightTag::BsdfOnly) {
        return 1.0f;
    }
    return params.directLight == DirectLightTag::LightOnly ? 0.0f : powerHeuristic(path.pdfBsdf, pdfLight);
}

template <class Log>
GLINT_HD inline void addHitLight(const PassParams& params, const Vec3& radiance, float pdfLight,
                                 PathEventKind kind, PathState* path, Log* log) {
    const float weight = hitLightWeight(params, *path, pdfLight);
    const Vec3 value = path->throughput * radiance * weight;
    path->radiance += value;
    if constexpr (Log::kEnabled) {
        PathEvent event;
        event.kind = kind;
        event.depth = path->depth;
        event.value = value;
        event.throughput = path->throughput;
        event.pdfLight = pdfLight;
        event.pdfBsdf = path->pdfBsdf;
        event.weight = weight;
        event.direction = path->ray.direction;
        log->add(event);
    }
}

/// What is lost on the way to the surface that the path has met; null: on a way without an end.
template <FeatureMask kMask>
GLINT_HD inline void attenuate(const SceneView& view, const SurfacePoint* surface, float distance,
                               PathState* path) {
    if constexpr (hasFeature<kMask>(kFeatureAttenuation)) {
        const Vec3 absorption = surface != nullptr
                                    ? absorptionBefore(view, path->glasses, *surface, -path->ray.direction)
                                    : absorptionIn(view, path->glasses);
        if (!isZero(absorption)) { path->throughput *= transmittance(absorption, distance); }
    }
}

/// The environment behind a ray that hit nothing.
template <FeatureMask kMask, class Log>
GLINT_HD inline void addEnvironment(const SceneView& view, const PassParams& params, PathState* path,
                                    Log* log) {
    if constexpr (hasFeature<kMask>(kFeatureEnvironmentConstant) ||
                  hasFeature<kMask>(kFeatureEnvironmentImage)) {
        const bool isHidden = view.lights.environmentIsSeenOnly && path->depth > 0;
        const Vec3 radiance =
            isHidden ? Vec3(0.0f) : environmentRadiance<kMask>(view, path->ray.origin, path->ray.direction);
        const float pdfLight = path->specularBounce
                                   ? 0.0f
                                   : pdfLightEnvironment<kMask>(view, path->context, path->ray.direction);
        addHitLight(params, radiance, pdfLight, PathEventKind::Escape, path, log);
    } else if constexpr (Log::kEnabled) {
        addHitLight(params, Vec3(0.0f), 0.0f, PathEventKind::Escape, path, log);
    }
}

/// What the surface that the path has met sends out by itself.
template <FeatureMask kMask, class Log>
GLINT_HD inline void addEmission(const SceneView& view, const PassParams& params, const SurfacePoint& surface,
                                 const Vec3& wo, PathState* path, Log* log) {
    // Where light sampling finds the same light, both see it alike.
    const float uvWidth = path->specularBounce ? surface.uvWidth : 0.0f;
    const Vec3 radiance = emittedRadiance<kMask>(view, surface, wo, uvWidth);
    if (isZero(radiance)) { return; }
    float pdfLight = 0.0f;
    if constexpr (hasFeature<kMask>(kFeatureAreaLights)) {
        if (!path->specularBounce) {
            const uint32_t emitter = emitterOf(view, surface.instance, surface.primitive);
            pdfLight = pdfLightSurface<kMask>(view, path->context, emitter, surface.p);
        }
    }
    addHitLight(params, radiance, pdfLight, PathEventKind::Emission, path, log);
}

/// Whether the light of a sample reaches the surface.
template <FeatureMask kMask>
GLINT_HD inline bool lightArrives(const SceneView& view, const SurfacePoint& surface,
                                  const LightSample& light) {
    const Ray ray = light.isInfinite
                        ? spawnRay(surface, light.wiWorld)
                        : spawnShadowRay(surface, light.point, light.pointError, light.pointNormal);
    return !occluded<kMask>(view, ray);
}

/// What glass leaves of a sample's light on its way to the surface, at which the path has arrived.
template <FeatureMask kMask>
GLINT_HD inline Vec3 lightLeft(const SceneView& view, const SurfacePoint& surface, const LightSample& light,
                               const PathState& path) {
    if constexpr (hasFeature<kMask>(kFeatureAttenuation)) {
        GlassStack glasses = path.glasses;
        const bool isBehind = glm::dot(light.wiWorld, surface.ng) < 0.0f;
        if (isBehind == (glm::dot(path.ray.direction, surface.ng) < 0.0f)) {
            passSurface(view, surface.material, isBehind, &glasses);
        }
        const Vec3 absorption = absorptionIn(view, glasses);
        if (isZero(absorption)) { return Vec3(1.0f); }
        return transmittance(absorption, light.isInfinite ? kInfinity : glm::length(light.point - surface.p));
    }
    return Vec3(1.0f);
}

/// Next-event estimation: one light, one point on it, one shadow ray.
template <FeatureMask kMask, class Log>
GLINT_HD inline void addSampledLight(const SceneView& view, const PassParams& params, const Sampler& sampler,
                                     const SurfacePoint& surface, const Bsdf<kMask>& bsdf, PathState* path,
                                     Log* log) {
    if (view.lights.emitters.empty()) { return; }
    const float uChoice = view.lights.emitters.count > 1
                              ? get1D<kMask>(sampler, dimension(BounceDimension::LightChoice, path->depth))
                              : 0.0f;
    const Vec2 uPoint = get2D<kMask>(sampler, dimension(BounceDimension::LightPoint, path->depth));
    const LightSample light = sampleLight<kMask>(view, path->context, uChoice, uPoint);
    if (!(light.pdfSolidAngle > 0.0f) || isZero(light.radiance)) { return; }
    if (params.directLight == DirectLightTag::BsdfOnly && !light.isDelta) { return; }
    const BsdfValue scattered = evaluateWithPdf(bsdf, light.wiWorld);
    if (isZero(scattered.value)) { return; }
    ++path->rays;
    const bool arrives = lightArrives<kMask>(view, surface, light);
    if (!arrives && !Log::kEnabled) { return; }

    const bool alone = light.isDelta || params.directLight == DirectLightTag::LightOnly;
    const float pdfBsdf = alone ? 0.0f : scattered.pdfSolidAngle;
    const float weight = alone ? 1.0f : powerHeuristic(light.pdfSolidAngle, pdfBsdf);
    Vec3 value(0.0f);
    if (arrives) {
        value = path->throughput * scattered.value * light.radiance * (weight / light.pdfSolidAngle);
        if constexpr (hasFeature<kMask>(kFeatureAttenuation)) {
            value *= lightLeft<kMask>(view, surface, light, *path);
        }
    }
    path->radiance += value;
    if constexpr (Log::kEnabled) {
        PathEvent event;
        event.kind = PathEventKind::Light;
        event.depth = path->depth;
        event.position = light.point;
        event.normal = light.pointNormal;
        event.direction = light.wiWorld;
        event.value = value;
        event.throughput = path->throughput;
        event.pdfLight = light.pdfSolidAngle;
        event.pdfBsdf = pdfBsdf;
        event.weight = weight;
        event.emitter = light.emitter;
        event.flag = !arrives;
        log->add(event);
    }
}

}  // namespace glint
