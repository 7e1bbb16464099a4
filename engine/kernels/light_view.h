// Lights as kernels see them: emitters of every kind, how one is chosen, and the environment. Plain data.
//
// Filled by build/light_table, read by light_sampling.h.
#pragma once

#include "engine/base/view.h"
#include "engine/math/vec.h"

namespace glint {

enum class EmitterTag : uint8_t { Sphere, Rectangle, Disc, Triangle, Point, Spot, Directional, Environment };

struct LightView {
    Vec3 environmentRadiance{0.0f};  ///< constant environment; multiplies the image where there is one
};

}  // namespace glint
