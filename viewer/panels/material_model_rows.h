// The Materials panel's rows of what a material's model computes with beside its colour.
#pragma once

#include "engine/scene/material.h"

namespace glint {

void drawModelInputs(Material* material);

}  // namespace glint
