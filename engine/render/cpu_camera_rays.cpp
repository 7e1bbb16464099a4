// The loop over pinholes is written so that GCC makes vector code of it (-fopt-info-vec tells): everything
// inlined, what is constant over the tile chosen outside, no structure copied as a whole but the ray.
#include "engine/render/cpu_camera_rays.h"

#include "engine/base/inlining.h"

namespace glint {
namespace {

inline void store(int pixel, const Sampler& sampler, const Vec3& origin, const Vec3& direction,
                  CameraTile* tile) {
    tile->pixelKey[pixel] = sampler.pixelKey;
    tile->originX[pixel] = origin.x;
    tile->originY[pixel] = origin.y;
    tile->originZ[pixel] = origin.z;
    tile->directionX[pixel] = direction.x;
    tile->directionY[pixel] = direction.y;
    tile->directionZ[pixel] = direction.z;
}

template <FilterKind kFilter>
GLINT_FLATTEN void fillPinhole(const CameraData& sceneCamera, PassParams params, int x0, int y0,
                               CameraTile* tile) {
    params.filter = kFilter;
    const CameraData camera = sceneCamera;
    for (int i = 0; i < kCameraTilePixels; ++i) {
        const int x = x0 + i % kCameraTileSize;
        const int y = y0 + i / kCameraTileSize;
        const Sampler sampler = makeSampler(params, x, y);
        const Ray ray = pixelRay<FeatureMask{0}>(camera, params, sampler, x, y);
        store(i, sampler, camera.position, ray.direction, tile);
    }
}

/// Of any camera with any sampler.
void fillOneByOne(const CameraData& camera, const PassParams& params, int x0, int y0, CameraTile* tile) {
    for (int i = 0; i < kCameraTilePixels; ++i) {
        const int x = x0 + i % kCameraTileSize;
        const int y = y0 + i / kCameraTileSize;
        const Sampler sampler = makeSampler(params, x, y);
        const Ray ray =
            pixelRay<kFeatureCameraArea | kFeatureIndependentSampler>(camera, params, sampler, x, y);
        store(i, sampler, ray.origin, ray.direction, tile);
    }
}

}  // namespace

void fillCameraTile(const CameraData& camera, const PassParams& params, int x0, int y0, CameraTile* tile) {
    // A choice of samplers within the loop over pinholes would keep it from becoming vector code.
    if (camera.hasArea() || params.sampler != SamplerKind::Sobol) {
        return fillOneByOne(camera, params, x0, y0, tile);
    }
    switch (params.filter) {
        case FilterKind::Box:
            return fillPinhole<FilterKind::Box>(camera, params, x0, y0, tile);
        case FilterKind::Gaussian:
            return fillPinhole<FilterKind::Gaussian>(camera, params, x0, y0, tile);
        case FilterKind::BlackmanHarris:
            return fillPinhole<FilterKind::BlackmanHarris>(camera, params, x0, y0, tile);
    }
}

}  // namespace glint
