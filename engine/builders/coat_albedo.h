// The albedo of a plastic's dielectric coat, integrated once when the material is built (bsdf/plastic.h says
// how it is used).
#pragma once

#include "engine/kernels/bsdf/facets.h"

namespace glint {

/// The coat of one index of refraction and GGX alpha. About 0.3 ms for a rough one.
CoatRow tabulateCoat(float ior, float alpha);

/// A coat of other facets: of light along their first direction, or across it. The average is that of
/// the row.
CoatRow tabulateCoat(float ior, const GeneralFacets& facets, bool across);

/// Sets both rows of a material with kMaterialFacets, whose inputs are set otherwise.
void tabulateCrossedCoat(FacetDistribution distribution, ShadingInputs* inputs);

/// The share of a rough dielectric's reflection (without what passes) of light from `wo`.
float roughCoatAlbedo(float ior, const GeneralFacets& facets, const Vec3& wo);
/// The same for GGX with one alpha and light from cosine mu.
float roughCoatAlbedo(float ior, float alpha, float mu);

}  // namespace glint
