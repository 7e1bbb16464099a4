#include "engine/render/first_hits.h"

#include <cmath>

#include "engine/kernels/camera_ray.h"
#include "engine/kernels/intersect.h"
#include "engine/kernels/surface.h"

namespace glint {
namespace {

/// Not from a camera so far away, or on a way so long, that float cannot tell where it leads.
bool isTraceable(const Ray& ray) {
    return isFinite(ray.origin) && isFinite(ray.direction) && !isZero(ray.direction);
}

FirstHit hitOf(const SceneView& view, int width, int height, int x, int y) {
    const Vec2 ndc = pixelToNdc(width, height, x, y, Vec2(0.0f));
    CameraData camera = view.camera;
    camera.lensRadius = 0.0f;
    const Ray ray = cameraRay<kFeatureCameraArea>(camera, ndc, Vec2(0.0f));
    Hit hit;
    if (!isTraceable(ray) || !intersect<kAllFeatures>(view, ray, &hit)) { return {}; }
    const SurfacePoint surface = surfaceAt<kAllFeatures>(view, ray, hit);
    return {-glm::dot(surface.p - view.camera.position, view.camera.frame.n), surface.instance + 1,
            static_cast<uint32_t>(surface.material) + 1};
}

}  // namespace

FirstHit firstHit(const BuiltScene& scene, int width, int height, int x, int y) {
    return hitOf(scene.view(), width, height, x, y);
}

FirstHit firstHitBetween(const BuiltScene& scene, const Vec3& from, const Vec3& to) {
    constexpr float kLeftOut = 1e-4f;  // of the way, at either end: surfaces that the points lie on
    const SceneView view = scene.view();
    const float length = glm::length(to - from);
    const Ray ray{from - scene.origin(), (to - from) / length, kLeftOut * length, (1.0f - kLeftOut) * length};
    Hit hit;
    if (!std::isfinite(length) || !isTraceable(ray) || !intersect<kAllFeatures>(view, ray, &hit)) {
        return {};
    }
    const SurfacePoint surface = surfaceAt<kAllFeatures>(view, ray, hit);
    return {glm::length(surface.p - ray.origin), surface.instance + 1,
            static_cast<uint32_t>(surface.material) + 1};
}

std::vector<float> firstDepths(const BuiltScene& scene, int width, int height,
                               const std::atomic<bool>& stop) {
    const SceneView view = scene.view();
    std::vector<float> depths;
    depths.reserve(static_cast<size_t>(width) * static_cast<size_t>(height));
    for (int y = 0; y < height; ++y) {
        if (stop) { return {}; }
        for (int x = 0; x < width; ++x) {
            depths.push_back(hitOf(view, width, height, x, y).depth);
        }
    }
    return depths;
}

}  // namespace glint
