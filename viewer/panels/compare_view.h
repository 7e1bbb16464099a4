// The rows by which two panels say how pictures are compared.
#pragma once

#include "viewer/model/display_settings.h"

namespace glint {

void drawCompareView(DisplaySettings* display);

}  // namespace glint
