// Independent uniform numbers for tests that sample: seeded, and none of the kernels' own.
#pragma once

#include <random>

#include "engine/math/vec.h"

namespace glint::test {

/// Numbers in [0, 1), with 24 bits.
class UniformNumbers {
  public:
    explicit UniformNumbers(uint32_t seed) : random_(seed) {}
    float next() { return static_cast<float>(random_() >> 8) * 0x1p-24f; }
    Vec2 next2() {
        const float x = next();
        return {x, next()};
    }

  private:
    std::mt19937 random_;
};

}  // namespace glint::test
