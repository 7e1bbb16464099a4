// How the picture's area is filled: one picture, or path tracing left of a divider and SPPM right of it, each
// with its passes and seconds; and the colour scale of what is shown as false colours.
//
// Used by image_view alone. Draws and drags; which pictures there are is the application's business.
#pragma once

#include "viewer/window/image_display.h"
#include "viewer/window/shown_image_source.h"
#include "viewer/window/viewer_model.h"

namespace glint {

/// What is on the graphics card. `other` belongs to ViewerModel::otherSnapshot() and matters while the
/// picture is split.
struct ImageFiles {
    const ImageDisplay* main = nullptr;
    const ImageDisplay* other = nullptr;
    const ShownImageSource* mainSource = nullptr;
    const ShownImageSource* otherSource = nullptr;
};

/// Call before any other widget of the area, so that the divider gets the mouse first. True while it is held.
bool dragDivider(DisplaySettings* settings, Vec2 imageMin, Vec2 imageMax);

/// Pictures, divider, labels and scale inside the rectangle (ImGui units).
void drawImages(const ViewerModel& model, const ImageFiles& images, Vec2 min, Vec2 max);

}  // namespace glint
