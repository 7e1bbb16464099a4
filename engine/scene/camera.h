// Editable camera: perspective with a thin lens, or orthographic.
#pragma once

#include <cmath>

#include "engine/base/kinds.h"
#include "engine/math/vec.h"

namespace glint {

/// Right-handed: looking along `target - position`, image x runs to the right, image y down from the top row.
/// Things behind `position` are not seen, by parallel rays neither.
struct Camera {
    Vec3 position{0.0f, 1.0f, 5.0f};
    Vec3 target{0.0f, 1.0f,
                0.0f};  ///< the orbit centre; only its direction from `position` matters to the picture
    Vec3 up{0.0f, 1.0f, 0.0f};
    ProjectionKind kind = ProjectionKind::Perspective;
    float verticalFovDeg = 40.0f;  ///< perspective: full angle, (0, 180), of a picture that is not shifted
    float viewHeight = 2.0f;       ///< orthographic: metres from the picture's bottom to its top
    /// widens (> 1) or narrows the view horizontally: non-square pixels; 1 normally
    float horizontalScale = 1.0f;
    /// Where the picture's middle lies to the right of and above the view axis, in heights of the picture
    /// (along x, too): a lens that is shifted, or a window cut out of a larger picture. The picture shows
    /// what the rows and columns of pixels beyond its edges would show, with straight lines kept straight.
    Vec2 shift{0.0f};

    /// metres; 0: a pinhole. With blades: diameter of the circle around the polygon
    float apertureDiameter = 0.0f;
    float focalDistance = 5.0f;     ///< metres along the view axis to the plane in focus
    int apertureBlades = 0;         ///< 0: round, otherwise >= 3
    float bladeRotationDeg = 0.0f;  ///< turns the polygon; at 0 one corner lies on the image's +x axis
};

/// Unit vectors of the picture: to its right, to its top, and along the view.
struct CameraAxes {
    Vec3 right, up, forward;
};
/// An up vector that is zero or along the view is replaced by the world axis farthest from the view (y, else
/// z). A camera whose position and target coincide looks along -z.
CameraAxes axesOf(const Camera& camera);

/// Metres from the bottom to the top of what the picture shows, in the plane at this depth along the
/// view axis.
inline float heightOfView(const Camera& camera, float depth) {
    return camera.kind == ProjectionKind::Orthographic
               ? camera.viewHeight
               : 2.0f * depth * std::tan(camera.verticalFovDeg * kPi / 360.0f);
}

}  // namespace glint
