// Phong's model at the first hit (Phong 1975, "Illumination for Computer Generated Pictures"): the scene's
// lights without a shape one by one, an ambient term, and no bounce. Host and device.
//
// A preview: mirrors and glass show their colours, lamps their emission and light nothing. No random number
// decides about light, so one sample has no noise but the edges'. Where the scene has no light without a
// shape, one shines from the camera.
#pragma once

#include "engine/kernels/bsdf/bsdf.h"
#include "engine/kernels/camera_path.h"
#include "engine/kernels/emitted_radiance.h"
#include "engine/kernels/intersect.h"
#include "engine/kernels/light_sampling.h"
#include "engine/kernels/surface.h"

namespace glint {

/// A material's highlight.
struct PhongMaterial {
    Vec3 specular{0.0f};
    float exponent = 0.0f;
};

struct RayCastView {
    View<PhongMaterial> materials;  ///< same indices as SceneView::materials
    Vec3 ambient{0.0f};             ///< radiance from all around
    bool shadows = true;
    bool falloff = true;  ///< otherwise lights shine everywhere as at the middle of what has an end
};

/// Radiance that Phong's model sends to the viewer: of light from the unit direction wi, with the irradiance
/// that it has on a surface that faces it. A white surface that faces light of irradiance pi has radiance 1.
GLINT_HD inline Vec3 phongRadiance(const Vec3& albedo, const PhongMaterial& material, const Vec3& normal,
                                   const Vec3& toViewer, const Vec3& wi, const Vec3& irradiance) {
    const float cosine = glm::dot(normal, wi);
    if (!(cosine > 0.0f)) { return Vec3(0.0f); }
    const float along = glm::dot(2.0f * cosine * normal - wi, toViewer);
    const float highlight = along > 0.0f ? std::pow(minf(along, 1.0f), material.exponent) : 0.0f;
    return (albedo * cosine + material.specular * highlight) * irradiance * (1.0f / kPi);
}

/// The light as it falls on `p`, without shadows.
template <FeatureMask kMask>
GLINT_HD inline LightSample lightForPhong(const SceneView& view, const RayCastView& settings,
                                          const EmitterData& emitter, const Vec3& p) {
    LightSample light = sampleDeltaLight<kMask>(view, emitter, p);
    if (settings.falloff || light.isInfinite) { return light; }
    const float atMiddle = lengthSquared(emitter.position - view.geometry.bounds.center());
    if (atMiddle > 0.0f) { light.radiance *= lengthSquared(emitter.position - p) / atMiddle; }
    return light;
}

/// What the lights without a shape send by way of the surface to the viewer. Adds shadow rays to *rays.
template <FeatureMask kMask>
GLINT_HD Vec3 phongOfLights(const SceneView& view, const RayCastView& settings, const SurfacePoint& surface,
                            const Vec3& albedo, const Vec3& toViewer, uint32_t* rays) {
    const PhongMaterial& material = settings.materials[surface.material];
    const Vec3 normal = glm::dot(surface.ng, toViewer) < 0.0f ? -surface.ns : surface.ns;
    Vec3 sum(0.0f);
    for (uint32_t i = view.lights.castLights.count; i-- > 0;) {
        const LightSample light = lightForPhong<kMask>(view, settings, view.lights.castLights[i], surface.p);
        if (!(light.pdfSolidAngle > 0.0f)) { continue; }
        const Vec3 radiance =
            phongRadiance(albedo, material, normal, toViewer, light.wiWorld, light.radiance);
        if (isZero(radiance)) { continue; }
        if (settings.shadows) {
            ++*rays;
            const Ray shadow = light.isInfinite
                                   ? spawnRay(surface, light.wiWorld)
                                   : spawnShadowRay(surface, light.point, Vec3(0.0f), Vec3(0.0f));
            if (occluded<kMask>(view, shadow)) { continue; }
        }
        sum += radiance;
    }
    return view.lights.castLights.count > 0
               ? sum
               : phongRadiance(albedo, material, normal, toViewer, toViewer, Vec3(kPi));
}

/// One sample of pixel (x, y) in params.pass: the environment where nothing is hit.
template <FeatureMask kMask>
GLINT_HD PixelSample traceRayCast(const SceneView& view, const RayCastView& settings,
                                  const PassParams& params, int x, int y) {
    const Sampler sampler = makeSampler(params, x, y);
    const Ray ray = pixelRay<kMask>(view.camera, params, sampler, x, y);
    PixelSample sample;
    sample.rays = 1;
    Hit hit;
    if (!intersect<kMask>(view, ray, &hit)) {
        sample.radiance = environmentRadiance<kMask>(view, ray.origin, ray.direction);
        return sample;
    }
    const SurfacePoint surface = surfaceAt<kMask>(view, ray, hit);
    const Vec3 toViewer = -ray.direction;
    const Vec3 albedo = displayAlbedo(makeBsdf<kMask>(view, surface, toViewer));
    sample.radiance = emittedRadiance<kMask>(view, surface, toViewer, surface.uvWidth) +
                      albedo * settings.ambient +
                      phongOfLights<kMask>(view, settings, surface, albedo, toViewer, &sample.rays);
    return sample;
}

}  // namespace glint
