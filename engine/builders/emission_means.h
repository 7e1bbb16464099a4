// Means of emission textures over what shines with them: how strongly a light is chosen.
#pragma once

#include "engine/kernels/shading_view.h"

namespace glint {

/// What lights are chosen by needs not be exact, for the probability is divided out; but nothing that shines
/// may have the probability 0. So each mean is at least a twentieth of the one over all texture coordinates.
class EmissionMeans {
  public:
    explicit EmissionMeans(const TextureView& texture);

    /// Over texture coordinates from 0 to 1: a whole analytic shape.
    const Vec3& overAll() const { return overAll_; }

    /// Over a triangle with these texture coordinates.
    Vec3 overTriangle(const Vec2& a, const Vec2& b, const Vec2& c) const;

  private:
    const TextureView texture_;
    Vec3 overAll_{0.0f};
};

}  // namespace glint
