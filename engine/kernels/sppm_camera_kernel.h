// The camera half of an SPPM pass: one path a pixel to its visible point. Host and device.
//
// It is the path tracer's path up to the first lobe that is neither specular nor sharply glossy. There it
// rests: photons bring what is scattered further. Emission on the way and, where it is sampled, direct light
// are the path's own result.
#pragma once

#include "engine/kernels/path_kernel.h"
#include "engine/kernels/sppm_view.h"
#include "engine/math/octahedral.h"

namespace glint {

namespace detail {

/// What the visible point remembers of the frame's direction about the normal that it will have then.
GLINT_HD inline float halfTurnOf(const Vec3& axis, uint32_t nsPacked) {
    const Frame frame = Frame::fromNormal(unpackUnitVector<16>(nsPacked));
    const float turns = std::atan2(glm::dot(axis, frame.t), glm::dot(axis, frame.s)) * kInvPi;
    return turns < 0.0f ? turns + 1.0f : turns;
}

template <FeatureMask kMask>
GLINT_HD VisiblePoint makeVisiblePoint(const SurfacePoint& surface, const Bsdf<kMask>& bsdf, const Vec3& wo,
                                       const PathState& path, float lobeProbability) {
    VisiblePoint point;
    point.p = surface.p;
    point.throughput = path.throughput * (1.0f / lobeProbability);
    point.woWorld = wo;
    point.vertexColor = surface.vertexColor;
    point.uv = surface.uv;
    point.nsPacked = packUnitVector<16>(surface.ns);
    point.ngPacked = packUnitVector<16>(surface.ng);
    point.instance = surface.instance;
    point.hasWavelength = path.wavelength.nm > 0.0f;
    point.depth = static_cast<uint32_t>(path.depth);
    if constexpr (hasFeature<kMask>(kFeatureFacets)) {
        if (hasGeneralFacets<kMask>(*bsdf.material)) {
            point.vertexColor = withHalfTurn(point.vertexColor, halfTurnOf(bsdf.frame.s, point.nsPacked));
        }
    }
    return point;
}

/// Follows the path; true when it came to rest at *point.
template <FeatureMask kMask>
GLINT_HD bool followToVisiblePoint(const SceneView& view, const SppmParams& params, const Sampler& sampler,
                                   PathState* path, VisiblePoint* point) {
    NoPathLog log;
    const PassParams& pass = params.pass;
    bool rests = false;
    float distance = 0.0f;
    while (true) {
        Hit hit;
        ++path->rays;
        if (!intersect<kMask>(view, path->ray, &hit)) {
            attenuate<kMask>(view, nullptr, kInfinity, path);
            addEnvironment<kMask>(view, pass, path, &log);
            return rests;
        }
        const SurfacePoint surface = surfaceOf<kMask>(view, hit, path);
        const Vec3 wo = -path->ray.direction;
        attenuate<kMask>(view, &surface, hit.t, path);
        addEmission<kMask>(view, pass, surface, wo, path, &log);
        if (rests || path->depth >= pass.maxDepth) { return rests; }
        distance += hit.t;

        disperse<kMask>(view, sampler, surface.material, &path->wavelength, &path->throughput);
        const Bsdf<kMask> bsdf =
            makeBsdf<kMask>(view, surface, wo, TransportMode::Radiance, path->wavelength.nm);
        const LobeRange stored = visiblePointLobes(bsdf, params.storeAlpha);
        const bool sampleLight =
            stored.probability() > 0.0f ? params.sampleDirectLight : !isSpecularOnly(bsdf);
        setLightContext(surface, bsdf, &path->context);
        if (sampleLight) { addSampledLight<kMask>(view, pass, sampler, surface, bsdf, path, &log); }

        const float uLobe = get1D<kMask>(sampler, dimension(BounceDimension::Lobe, path->depth));
        if (stored.contains(uLobe)) {
            *point = makeVisiblePoint(surface, bsdf, wo, *path, stored.probability());
            const float reach = view.camera.isOrthographic ? 1.0f : distance;
            point->footprint = reach * 2.0f * view.camera.halfHeight / static_cast<float>(pass.height);
            if (hasFeature<kMask>(kFeatureMipmaps) && surface.uvWidth > 0.0f) {
                point->footprint = withUvWidth(point->footprint, surface.uvWidth);
            }
            rests = true;
            if (!sampleLight) { return true; }
            // One more ray, for light that the sampled direction finds: the other half of multiple
            // importance sampling.
        }
        if (!scatterBy<kMask>(view, pass, sampler, surface, bsdf, uLobe, path, &log)) { return rests; }
    }
}

}  // namespace detail

/// Traces the path that sets out along `cameraRay`. Returns its emission and sampled direct light; *point is
/// where it rests (throughput 0: nowhere).
template <FeatureMask kMask>
GLINT_HD PixelSample traceVisiblePoint(const SceneView& view, const SppmParams& params,
                                       const Sampler& sampler, const Ray& cameraRay, VisiblePoint* point) {
    PathState path;
    path.ray = cameraRay;
    path.cone = pixelCone(view.camera, params.pass.height);
    *point = VisiblePoint{};
    if (!detail::followToVisiblePoint<kMask>(view, params, sampler, &path, point) ||
        !isFinite(point->throughput) || !isFinite(point->p)) {
        point->throughput = Vec3(0.0f);
    }
    return finishSample(params.pass, path);
}

/// The same for pixel (x, y) of params.pass.
template <FeatureMask kMask>
GLINT_HD PixelSample traceVisiblePoint(const SceneView& view, const SppmParams& params, int x, int y,
                                       VisiblePoint* point) {
    const Sampler sampler = makeSampler(params.pass, x, y);
    const Ray ray = pixelRay<kMask>(view.camera, params.pass, sampler, x, y);
    return traceVisiblePoint<kMask>(view, params, sampler, ray, point);
}

}  // namespace glint
