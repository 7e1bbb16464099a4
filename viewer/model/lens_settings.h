// How the lens is spoken of and looked at. Nothing here reaches the renderer.
#pragma once

#include "viewer/model/focus_overlay.h"
#include "viewer/model/lens.h"

namespace glint {

struct LensSettings {
    size_t sensor = 0;  ///< of sensorSizes()
    float customHeightMm = 24.0f;
    FocusOverlayKind overlay = FocusOverlayKind::None;
    float sharpPixels = 2.0f;  ///< the largest circle of confusion that counts as sharp
    bool picksFocus = false;   ///< the next click on the picture focuses there

    float sensorHeightMm() const {
        const float height = sensorSizes()[sensor].heightMm;
        return height > 0.0f ? height : customHeightMm;
    }
};

}  // namespace glint
