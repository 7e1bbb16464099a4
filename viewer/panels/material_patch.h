// The colour by which lists show a material.
#pragma once

#include "engine/scene/material.h"

namespace glint {

/// Linear: a lamp's light, a metal's reflectance head on, or the colour.
Vec3 patchColor(const Material& material);

}  // namespace glint
