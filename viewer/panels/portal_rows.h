// The rows of the rectangle that an environment shines through.
#pragma once

#include "viewer/model/scene_document.h"

namespace glint {

/// None, the one that there is, or one of the scene's rectangles, whose front its light then leaves.
void drawPortalRows(SceneDocument* document);

}  // namespace glint
