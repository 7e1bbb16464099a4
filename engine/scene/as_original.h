// Settings of the program that 6.837 texts were written for.
#pragma once

#include "engine/scene/scene.h"

namespace glint {

/// Depth 20, a box filter of one pixel each way, and a square lens, whose corners lie on the circle that a
/// round one fills. Its pictures are clamped, without an exposure.
void setAsOriginal(SceneDescription* scene);

}  // namespace glint
