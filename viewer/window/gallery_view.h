// What an empty window offers: the scenes that come with the program.
#pragma once

#include "viewer/model/workspace.h"

namespace glint {

/// Cards in rows within the rectangle (ImGui units); a click opens one. For within the image's window.
void drawGallery(Workspace* workspace, Vec2 min, Vec2 max);

}  // namespace glint
