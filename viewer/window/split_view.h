// How the image's area is filled: one image, or those of two integrators left and right of a divider, each
// with its passes and seconds; and the colour scale of what is shown as false colours.
//
// Draws and drags; which images there are is the application's business.
#pragma once

#include "viewer/model/workspace.h"
#include "viewer/window/image_pane.h"

namespace glint {

/// Call before any other widget of the area, so that the divider gets the mouse first. True while it is held.
bool dragDivider(DisplaySettings* settings, Vec2 imageMin, Vec2 imageMax);

/// Images, divider, labels and scale inside the rectangle (ImGui units).
void drawPanes(const Workspace& workspace, const ImagePanes& panes, Vec2 min, Vec2 max);

}  // namespace glint
