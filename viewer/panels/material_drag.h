// Materials that are dragged from a list to an object.
#pragma once

#include <string>

#include "viewer/model/material_presets.h"

namespace glint {

/// The line that was drawn last can be dragged; `name` goes with the mouse.
void offerMaterial(const MaterialDrag& drag, const std::string& name);

}  // namespace glint
