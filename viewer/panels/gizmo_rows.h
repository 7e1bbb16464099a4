// The rows by which two panels set the handles in the picture.
#pragma once

#include "viewer/model/gizmo.h"
#include "viewer/model/key_map.h"

namespace glint {

void drawGizmoRows(GizmoSettings* gizmo, const KeyMap& keys);

}  // namespace glint
