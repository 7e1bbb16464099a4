// Histogram, waveform and parade of the picture that is shown.
#pragma once

#include "viewer/model/inspector.h"

namespace glint {

/// A choice between them, and the one that is chosen. `snapshot` has a picture.
void drawScopes(const std::shared_ptr<const FilmSnapshot>& snapshot, const DisplayLook& look,
                Inspector* inspector);

}  // namespace glint
