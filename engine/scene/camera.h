// Editable perspective camera with a thin lens.
#pragma once

#include "engine/math/vec.h"

namespace glint {

/// Right-handed: looking along `target - position`, image x runs to the right, image y down from the top row.
struct Camera {
    Vec3 position{0.0f, 1.0f, 5.0f};
    Vec3 target{0.0f, 1.0f,
                0.0f};  ///< the orbit centre; only its direction from `position` matters to the picture
    Vec3 up{0.0f, 1.0f, 0.0f};
    float verticalFovDeg = 40.0f;  ///< full angle, (0, 180)
    /// widens (> 1) or narrows the view horizontally: non-square pixels; 1 normally
    float horizontalScale = 1.0f;

    /// metres; 0: a pinhole. With blades: diameter of the circle around the polygon
    float apertureDiameter = 0.0f;
    float focalDistance = 5.0f;     ///< metres along the view axis to the plane in focus
    int apertureBlades = 0;         ///< 0: round, otherwise >= 3
    float bladeRotationDeg = 0.0f;  ///< turns the polygon; at 0 one corner lies on the image's +x axis
};

}  // namespace glint
