// The albedos of a material's coat, for one roughness and index or, where textures vary these, for a table
// of them.
#pragma once

#include <vector>

#include "engine/kernels/shading_view.h"

namespace glint {

/// Sets the coat's constant row, or adds its rows to `rows` and sets the first of them. Those of the material
/// `before` (may be null), whose rows are in `rowsBefore`, are taken where they are the same.
void setCoat(const MaterialData* before, const std::vector<CoatRow>* rowsBefore, MaterialData* data,
             std::vector<CoatRow>* rows);

}  // namespace glint
