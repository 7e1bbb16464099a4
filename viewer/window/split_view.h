// How the image's area is filled: one image, or two that are compared, as their view says, each with what it
// is; and the colour scale of what is shown as false colours.
//
// Draws and drags; which images there are is the application's business.
#pragma once

#include "viewer/model/workspace.h"
#include "viewer/window/image_pane.h"

namespace glint {

/// Call before any other widget of the area, so that the divider gets the mouse first. True while it is held.
bool dragDivider(DisplaySettings* settings, const PlacedImage& placed);

/// Where the divider is, in ImGui units; both functions are for within the image's window.
float dividerX(const DisplaySettings& settings, const PlacedImage& placed);

bool hasDivider(const Workspace& workspace);
/// The area's left half has one picture, its right half the other.
bool isSideBySide(const Workspace& workspace);
/// Of the mouse at `x`, the picture on the right is seen there.
bool seesRight(const Workspace& workspace, const PlacedImage& placed, float x);

/// Images, divider, labels and scale (ImGui units). `placed`: in the left half where they are side by side.
void drawPanes(const Workspace& workspace, const ImagePanes& panes, const PlacedImage& placed);

}  // namespace glint
