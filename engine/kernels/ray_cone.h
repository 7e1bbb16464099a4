// How wide a pixel is along a path: a cone around its rays (Amanatides 1984, "Ray Tracing with Cones"), for
// mip maps alone. Host and device.
//
// It widens by the pixel's angle, where rays are not parallel, and after a rough surface by a part of the
// width of the lobe that was sampled. Left out: what curved mirrors and lenses do to it.
#pragma once

#include "engine/kernels/shading_view.h"

namespace glint {

struct RayCone {
    float width = 0.0f;   ///< world units, where the ray begins
    float spread = 0.0f;  ///< world units a unit of distance

    GLINT_HD void travel(float distance) { width += spread * distance; }

    /// Takes a direction of this density per solid angle: a tenth of a square of that lobe's solid angle.
    GLINT_HD void scatter(float pdfSolidAngle) { spread = maxf(spread, 0.1f / std::sqrt(pdfSolidAngle)); }
};

/// Of a camera ray of a picture with so many rows.
GLINT_HD inline RayCone pixelCone(const CameraData& camera, int height) {
    const float pixel = 2.0f * camera.halfHeight / static_cast<float>(height);
    return camera.isOrthographic ? RayCone{pixel, 0.0f} : RayCone{0.0f, pixel};
}

}  // namespace glint
