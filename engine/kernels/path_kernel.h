// One camera path: next-event estimation and BSDF sampling at every vertex, combined by multiple importance
// sampling (Veach and Guibas 1995), and Russian roulette. Host and device.
//
// Unbiased up to the maximum depth. Left out: volumes that scatter. Nothing is clamped unless
// fireflyClamp asks for it.
#pragma once

#include "engine/kernels/camera_path.h"
#include "engine/kernels/path_light.h"

namespace glint {

/// Russian roulette on the throughput. False: the path ends.
template <FeatureMask kMask, class Log>
GLINT_HD inline bool survivesRoulette(const PassParams& params, const Sampler& sampler, PathState* path,
                                      Log* log) {
    if (path->depth < params.rouletteStartDepth) { return true; }
    const float chance = minf(maxComponent(path->throughput) * path->etaScale, 1.0f);
    bool survives = true;
    if (chance < 1.0f) {
        survives = get1D<kMask>(sampler, dimension(BounceDimension::Roulette, path->depth)) < chance;
    }
    if constexpr (Log::kEnabled) {
        PathEvent event;
        event.kind = PathEventKind::Roulette;
        event.depth = path->depth;
        event.throughput = path->throughput;
        event.weight = chance;
        event.flag = survives;
        log->add(event);
    }
    if (survives && chance < 1.0f) { path->throughput *= 1.0f / chance; }
    return survives;
}

/// Samples the next direction, its lobe chosen by uLobe, and sets out along it. False: the path ends.
template <FeatureMask kMask, class Log>
GLINT_HD inline bool scatterBy(const SceneView& view, const PassParams& params, const Sampler& sampler,
                               const SurfacePoint& surface, const Bsdf<kMask>& bsdf, float uLobe,
                               PathState* path, Log* log) {
    const Vec2 u = get2D<kMask>(sampler, dimension(BounceDimension::Direction, path->depth));
    const BsdfSample next = sample(bsdf, uLobe, u);
    if constexpr (Log::kEnabled) {
        PathEvent event;
        event.kind = PathEventKind::Scatter;
        event.depth = path->depth;
        const BsdfSample known = next.valid ? next : BsdfSample{};
        event.direction = known.wi;
        event.value = known.weight;
        event.throughput = path->throughput;
        event.pdfBsdf = known.pdfSolidAngle;
        event.flag = known.isSpecular;
        log->add(event);
    }
    if (!next.valid) { return false; }
    path->throughput *= next.weight;
    path->pdfBsdf = next.pdfSolidAngle;
    path->specularBounce = next.isSpecular;
    path->etaScale *= next.etaScale;
    leaveSurface(surface, next.wi, &path->ray);
    if (hasFeature<kMask>(kFeatureAttenuation) && next.isTransmission) {
        passSurface(view, surface.material, glm::dot(next.wi, surface.ng) < 0.0f, &path->glasses);
    }
    if (hasFeature<kMask>(kFeatureMipmaps) && !next.isSpecular) { path->cone.scatter(next.pdfSolidAngle); }
    const bool goesOn = survivesRoulette<kMask>(params, sampler, path, log);
    ++path->depth;
    return goesOn;
}

/// The same with a lobe drawn here.
template <FeatureMask kMask, class Log>
GLINT_HD inline bool scatter(const SceneView& view, const PassParams& params, const Sampler& sampler,
                             const SurfacePoint& surface, const Bsdf<kMask>& bsdf, PathState* path,
                             Log* log) {
    float uLobe = 0.0f;
    if constexpr (usesLobeChoice<kMask>()) {
        uLobe = get1D<kMask>(sampler, dimension(BounceDimension::Lobe, path->depth));
    }
    return scatterBy<kMask>(view, params, sampler, surface, bsdf, uLobe, path, log);
}

template <class Log>
GLINT_HD inline void logVertex(const PathState& path, const SurfacePoint& surface, Log* log) {
    if constexpr (Log::kEnabled) {
        PathEvent event;
        event.kind = PathEventKind::Vertex;
        event.depth = path.depth;
        event.position = surface.p;
        event.normal = surface.ns;
        event.direction = path.ray.direction;
        event.throughput = path.throughput;
        event.instance = surface.instance;
        event.primitive = surface.primitive;
        event.material = surface.material;
        log->add(event);
    }
}

/// Sets what light sampling needs to know of a vertex. In its place: a copy would read at once what was
/// written in pieces of another width, for which processors wait.
template <FeatureMask kMask>
GLINT_HD inline void setLightContext(const SurfacePoint& surface, const Bsdf<kMask>& bsdf,
                                     LightContext* context) {
    context->p = surface.p;
    context->n = bsdf.ngWorld;
    context->bothSides = transmitsSampledLight(bsdf);
}

/// The surface that the path has met.
template <FeatureMask kMask>
GLINT_HD inline SurfacePoint surfaceOf(const SceneView& view, const Hit& hit, PathState* path) {
    if constexpr (hasFeature<kMask>(kFeatureMipmaps)) { path->cone.travel(hit.t); }
    return surfaceAt<kMask>(view, path->ray, hit, path->cone.width);
}

/// Follows the path to its end and leaves what it gathered in path->radiance.
template <FeatureMask kMask, class Log>
GLINT_HD inline void followPath(const SceneView& view, const PassParams& params, const Sampler& sampler,
                                PathState* path, Log* log) {
    while (true) {
        Hit hit;
        ++path->rays;
        if (!intersect<kMask>(view, path->ray, &hit)) {
            attenuate<kMask>(view, nullptr, kInfinity, path);
            addEnvironment<kMask>(view, params, path, log);
            return;
        }
        const SurfacePoint surface = surfaceOf<kMask>(view, hit, path);
        const Vec3 wo = -path->ray.direction;
        attenuate<kMask>(view, &surface, hit.t, path);
        logVertex(*path, surface, log);
        addEmission<kMask>(view, params, surface, wo, path, log);
        if (path->depth >= params.maxDepth) { return; }

        disperse<kMask>(view, sampler, surface.material, &path->wavelength, &path->throughput);
        const Bsdf<kMask> bsdf =
            makeBsdf<kMask>(view, surface, wo, TransportMode::Radiance, path->wavelength.nm);
        setLightContext(surface, bsdf, &path->context);
        if (!isSpecularOnly(bsdf)) {
            addSampledLight<kMask>(view, params, sampler, surface, bsdf, path, log);
        }
        if (!scatter<kMask>(view, params, sampler, surface, bsdf, path, log)) { return; }
    }
}

/// Why a radiance must not enter the film.
GLINT_HD inline SampleFault findFault(const Vec3& radiance) {
    if (std::isnan(radiance.x) || std::isnan(radiance.y) || std::isnan(radiance.z)) {
        return SampleFault::NotANumber;
    }
    if (!isFinite(radiance)) { return SampleFault::Infinite; }
    return minComponent(radiance) < 0.0f ? SampleFault::Negative : SampleFault::None;
}

/// What the path gathered as a sample of its pixel: faults found, clamped where asked for.
GLINT_HD inline PixelSample finishSample(const PassParams& params, const PathState& path) {
    PixelSample result;
    result.radiance = path.radiance;
    result.rays = path.rays;
    result.fault = findFault(path.radiance);
    if (result.fault != SampleFault::None) {
        result.radiance = Vec3(0.0f);
    } else if (params.fireflyClamp > 0.0f && maxComponent(result.radiance) > params.fireflyClamp) {
        result.radiance *= params.fireflyClamp / maxComponent(result.radiance);
    }
    return result;
}

/// Traces the path that sets out along `cameraRay`. The log sees every event; the result does not depend
/// on it.
template <FeatureMask kMask, class Log>
GLINT_HD PixelSample tracePathLogged(const SceneView& view, const PassParams& params, const Sampler& sampler,
                                     const Ray& cameraRay, Log* log) {
    PathState path;
    path.ray = cameraRay;
    path.cone = pixelCone(view.camera, params.height);
    if constexpr (Log::kEnabled) {
        PathEvent event;
        event.kind = PathEventKind::Camera;
        event.position = path.ray.origin;
        event.direction = path.ray.direction;
        log->add(event);
    }
    followPath<kMask>(view, params, sampler, &path, log);

    const PixelSample result = finishSample(params, path);
    if constexpr (Log::kEnabled) {
        PathEvent event;
        event.depth = path.depth;
        event.value = path.radiance;
        event.throughput = path.throughput;
        event.fault = result.fault;
        log->add(event);
    }
    return result;
}

/// Traces the path of pixel (x, y) in params.pass.
template <FeatureMask kMask, class Log>
GLINT_HD PixelSample tracePixelLogged(const SceneView& view, const PassParams& params, int x, int y,
                                      Log* log) {
    const Sampler sampler = makeSampler(params, x, y);
    return tracePathLogged<kMask>(view, params, sampler, pixelRay<kMask>(view.camera, params, sampler, x, y),
                                  log);
}

template <FeatureMask kMask>
GLINT_HD PixelSample tracePixel(const SceneView& view, const PassParams& params, int x, int y) {
    NoPathLog log;
    return tracePixelLogged<kMask>(view, params, x, y, &log);
}

}  // namespace glint
