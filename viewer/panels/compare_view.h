// The rows by which two panels say how pictures are compared.
#pragma once

#include "viewer/model/display_settings.h"
#include "viewer/model/key_map.h"

namespace glint {

void drawCompareView(DisplaySettings* display, const KeyMap& keys);

}  // namespace glint
