// How open the surface is that a pixel shows: the share of the cosine-weighted hemisphere over it from which
// nothing is met within a radius (Zhukov, Iones and Kronin 1998). Host and device.
//
// A picture of shapes alone: no materials, no light. Left out: a falloff with distance.
#pragma once

#include "engine/kernels/camera_path.h"
#include "engine/kernels/intersect.h"
#include "engine/kernels/surface.h"
#include "engine/math/frame.h"
#include "engine/math/warp.h"

namespace glint {

/// One sample of pixel (x, y) in params.pass: 1 where a ray over the seen side of the surface, of length
/// radiusWorld, meets nothing, and 0 where it meets something or the pixel shows no surface.
template <FeatureMask kMask>
GLINT_HD PixelSample traceAmbientOcclusion(const SceneView& view, const PassParams& params, float radiusWorld,
                                           int x, int y) {
    const Sampler sampler = makeSampler(params, x, y);
    const Ray ray = pixelRay<kMask>(view.camera, params, sampler, x, y);
    PixelSample sample;
    sample.rays = 1;
    Hit hit;
    if (!intersect<kMask>(view, ray, &hit)) { return sample; }
    const SurfacePoint surface = surfaceAt<kMask>(view, ray, hit);
    const Vec3 seen = glm::dot(surface.ng, ray.direction) > 0.0f ? -surface.ng : surface.ng;
    const Vec2 u = get2D<kMask>(sampler, dimension(BounceDimension::Direction, 0));
    Ray open = spawnRay(surface, Frame::fromNormal(seen).toWorld(sampleCosineHemisphere(u)));
    open.tMax = radiusWorld;
    ++sample.rays;
    if (!occluded<kMask>(view, open)) { sample.radiance = Vec3(1.0f); }
    return sample;
}

}  // namespace glint
