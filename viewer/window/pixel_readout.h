// The value under the mouse, in the terms of the picture that is shown: the status line's text.
#pragma once

#include <string>

#include "viewer/window/viewer_model.h"

namespace glint {

/// `filmPixel` counts in full resolution and is clamped to the picture. "" where the snapshot does not carry
/// that picture (yet). `reference` may be null.
std::string pixelReadout(const FilmSnapshot& snapshot, ShownImage wanted, const LoadedReference* reference,
                         Vec2i filmPixel);

}  // namespace glint
