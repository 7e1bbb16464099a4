// The exposure at which a picture can be looked at, for scenes whose files state none.
#pragma once

#include <vector>

namespace glint {

/// Stops, a multiple of 1/3, for a linear RGB picture; 0 where it shows well as it is, and where it is black.
/// Means of blocks of pixels decide, so that a noisy picture gives nearly what a clean one does, of which
/// only those count that are not black: a picture is too bright where half of them are beyond white, and too
/// dark where hardly one reaches a fifth of it.
float autoExposure(const std::vector<float>& rgb, int width, int height);

}  // namespace glint
