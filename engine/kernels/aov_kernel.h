// First-hit pictures with the path kernel's own camera rays. Host and device.
#pragma once

#include "engine/kernels/bsdf/bsdf.h"
#include "engine/kernels/camera_path.h"
#include "engine/kernels/intersect.h"
#include "engine/kernels/ray_cone.h"
#include "engine/kernels/surface.h"

namespace glint {

/// The first hit of pixel (x, y) in params.pass. Albedo is the material's colour (bsdf.h, displayAlbedo), so
/// that mirrors and glass show their tint instead of black.
template <FeatureMask kMask>
GLINT_HD AovSample traceAovPixel(const SceneView& view, const PassParams& params, int x, int y) {
    const Sampler sampler = makeSampler(params, x, y);
    const Ray ray = pixelRay<kMask>(view.camera, params, sampler, x, y);
    AovSample result;
    Hit hit;
    TestCounts tests;
    const bool found = intersect<kMask>(view, ray, &hit, CountTests{&tests});
    result.boxesTested = static_cast<float>(tests.boxes);
    result.primitivesTested = static_cast<float>(tests.primitives);
    result.newtonSteps = static_cast<float>(tests.newtonSteps);
    if (!found) { return result; }
    RayCone cone = pixelCone(view.camera, params.height);
    cone.travel(hit.t);
    const SurfacePoint surface = surfaceAt<kMask>(view, ray, hit, cone.width);
    const Vec3 wo = -ray.direction;
    result.albedo = displayAlbedo(makeBsdf<kMask>(view, surface, wo));
    result.shadingNormal = surface.ns;
    result.geometricNormal = surface.ng;
    result.depth = -glm::dot(surface.p - view.camera.position, view.camera.frame.n);
    result.objectId = surface.instance + 1;
    result.materialId = surface.material + 1;
    return result;
}

}  // namespace glint
