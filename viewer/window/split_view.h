// How the picture's area is filled: one picture, or path tracing left of a divider and SPPM right of it, each
// with its passes and seconds; and the colour scale of what is shown as false colours.
//
// Used by image_view alone. Draws and drags; which pictures there are is the application's business.
#pragma once

#include "viewer/window/image_display.h"
#include "viewer/window/picture_source.h"
#include "viewer/window/viewer_model.h"

namespace glint {

/// What is on the graphics card. `other` belongs to ViewerModel::otherSnapshot() and matters while the
/// picture is split.
struct Pictures {
    const ImageDisplay* main = nullptr;
    const ImageDisplay* other = nullptr;
    const PictureSource* mainSource = nullptr;
    const PictureSource* otherSource = nullptr;
};

/// Call before any other widget of the area, so that the divider gets the mouse first. True while it is held.
bool dragDivider(DisplaySettings* settings, Vec2 pictureMin, Vec2 pictureMax);

/// Pictures, divider, labels and scale inside the rectangle (ImGui units).
void drawPictures(const ViewerModel& model, const Pictures& pictures, Vec2 min, Vec2 max);

}  // namespace glint
