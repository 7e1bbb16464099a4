// From a place in the picture to a ray: pinhole, thin lens or parallel rays. Host and device.
//
// Left out: lens distortion, vignetting (cos^4 of the film), motion of the camera.
#pragma once

#include "engine/kernels/features.h"
#include "engine/kernels/shading_view.h"
#include "engine/math/ray.h"
#include "engine/math/warp.h"

namespace glint {

/// Picture coordinates of a point in pixel (x, y), `offset` pixels away from its centre: x and y in [-1, 1]
/// over the picture, x to the right, y up.
GLINT_HD inline Vec2 pixelToNdc(int width, int height, int x, int y, Vec2 offset) {
    const float right = (static_cast<float>(x) + 0.5f + offset.x) / static_cast<float>(width);
    const float down = (static_cast<float>(y) + 0.5f + offset.y) / static_cast<float>(height);
    return {2.0f * right - 1.0f, 1.0f - 2.0f * down};
}

/// A point on the lens in its own radius, uniform by area: round, or a regular polygon within the
/// unit circle.
GLINT_HD inline Vec2 sampleLens(const CameraData& camera, Vec2 uLens) {
    return camera.blades >= 3 ? sampleRegularPolygon(uLens, camera.blades, camera.bladeRotationRad)
                              : sampleDisc(uLens);
}

/// The ray through picture coordinates `ndc` (pixelToNdc) and the lens point chosen by uLens. All rays of one
/// ndc meet in the plane at focalDistance along the view axis. Its direction has unit length. Every ray
/// weighs the same. Masks without kFeatureCameraArea know of pinholes only.
template <FeatureMask kMask>
GLINT_HD Ray cameraRay(const CameraData& camera, Vec2 ndc, Vec2 uLens) {
    const Vec2 place(ndc.x * camera.halfWidth + camera.middle.x, ndc.y * camera.halfHeight + camera.middle.y);
    if constexpr (hasFeature<kMask>(kFeatureCameraArea)) {
        if (camera.hasArea()) {
            Vec3 lens(0.0f);
            if (camera.lensRadius > 0.0f) {
                lens = Vec3(camera.lensRadius * sampleLens(camera, uLens), 0.0f);
            }
            const Vec3 axial(camera.isOrthographic ? Vec2(0.0f) : place, -1.0f);
            const Vec3 start = camera.isOrthographic ? lens + Vec3(place, 0.0f) : lens;
            return {camera.position + camera.frame.toWorld(start),
                    glm::normalize(camera.frame.toWorld(axial - lens / camera.focalDistance))};
        }
    }
    return {camera.position, glm::normalize(camera.frame.toWorld(Vec3(place, -1.0f)))};
}

}  // namespace glint
