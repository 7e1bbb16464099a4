// The albedo of a plastic's dielectric coat, integrated once when the material is built (bsdf/plastic.h says
// how it is used).
#pragma once

#include "engine/kernels/shading_view.h"

namespace glint {

/// The coat of one index of refraction and GGX alpha. About 0.3 ms for a rough one.
CoatRow tabulateCoat(float ior, float alpha);

/// The share of a rough dielectric's reflection (without what passes) of light from cosine mu.
float roughCoatAlbedo(float ior, float alpha, float mu);

}  // namespace glint
