// The albedo of a plastic's dielectric coat, integrated once when the material is built (bsdf/plastic.h says
// how it is used).
#pragma once

#include "engine/kernels/shading_view.h"

namespace glint {

/// Fills coatRatio, coatAverageAlbedo and coatInternalAlbedo from ior and alpha. About 0.3 ms for a
/// rough coat.
void tabulateCoat(MaterialData* material);

/// The share of a rough dielectric's reflection (without what passes) of light from cosine mu.
float roughCoatAlbedo(float ior, float alpha, float mu);

}  // namespace glint
