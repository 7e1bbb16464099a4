// A histogram of directions whose cells are rings and sectors around an axis, with ring angles in
// geometric progression, so that lobes of any width around the axis are resolved. For chi-square tests of
// direction sampling.
#pragma once

#include <functional>
#include <vector>

#include "engine/math/frame.h"

namespace glint::test {

class DirectionGrid {
  public:
    /// Rings begin at `smallestAngleRad` (inside it: one cap) and end at the antipode of the unit
    /// vector `axis`.
    DirectionGrid(const Vec3& axis, double smallestAngleRad, int rings, int sectors);

    int cells() const { return (rings_ + 1) * sectors_; }
    int cellOf(const Vec3& direction) const;
    /// The integral of a density by solid angle over every cell, by adaptive Gauss quadrature. The density
    /// may jump (a horizon); absolute errors stay below about 1e-6 a cell.
    std::vector<double> integrate(const std::function<double(const Vec3&)>& density) const;

  private:
    double ringAngle(int ring) const;

    Frame frame_;
    double smallest_;
    double ratioLog_;  ///< logarithm of the ratio of neighbouring ring angles
    int rings_;
    int sectors_;
};

}  // namespace glint::test
