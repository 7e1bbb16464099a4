// Clear coats that files lay over other materials.
#pragma once

#include "engine/scene/material.h"

namespace glint {

/// Lays a coat of this index (1 or more) and GGX alpha over a conductor or a mirror, which becomes coated.
void coatMetal(float ior, const NumberInput& alpha, Material* metal);

/// Lays a coat of this index (1 or more) and GGX alpha over the material: a diffuse one becomes plastic, a
/// metal or a principled one principled, whose coat is as strong head on as that index says. False: other
/// kinds, which stay as they are.
bool coatMaterial(float ior, const NumberInput& alpha, Material* material);

}  // namespace glint
