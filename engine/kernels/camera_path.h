// The camera ray of a pixel's sample: filter, lens and camera together, so that every kernel that looks at a
// pixel in the same pass looks along the same ray.
#pragma once

#include "engine/kernels/camera_ray.h"
#include "engine/kernels/filter.h"
#include "engine/kernels/sampler.h"

namespace glint {

template <FeatureMask kMask>
GLINT_HD inline Ray pixelRay(const CameraData& camera, const PassParams& params, const Sampler& sampler,
                             int x, int y) {
    const Vec2 uFilter = get2D<kMask>(sampler, dimension(CameraDimension::PixelFilter));
    const Vec2 offset = sampleFilter(params.filter, params.filterRadius, uFilter);
    Vec2 uLens(0.0f);
    if constexpr (hasFeature<kMask>(kFeatureCameraArea)) {
        if (camera.lensRadius > 0.0f) { uLens = get2D<kMask>(sampler, dimension(CameraDimension::Lens)); }
    }
    return cameraRay<kMask>(camera, pixelToNdc(params.width, params.height, x, y, offset), uLens);
}

}  // namespace glint
