// A built-in texture: squares of two colours, two of them along each unit of u and v.
#pragma once

#include <memory>

#include "engine/math/vec.h"

namespace glint {

struct ImageF;

struct Checkerboard {
    Vec3 even{0.8f};  ///< linear; of the square at (0, 0)
    Vec3 odd{0.1f};

    bool operator==(const Checkerboard&) const = default;
};

/// Its four texels, for textures that show the nearest one.
std::shared_ptr<const ImageF> generateCheckerboard(const Checkerboard& board);

}  // namespace glint
