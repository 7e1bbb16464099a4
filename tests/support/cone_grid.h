// Directions in a cone, counted in cells and expected from a density.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <glm/glm.hpp>

#include "engine/math/frame.h"
#include "tests/support/uniform_numbers.h"

namespace glint::test {

/// Cells over a cone of directions around an axis, equal in solid angle.
struct ConeGrid {
    static constexpr int kBinsCos = 20;
    static constexpr int kBinsPhi = 20;
    static constexpr int kCells = kBinsCos * kBinsPhi;

    Frame frame;
    double oneMinusCosMax;

    Vec3 direction(double cosPart, double phiPart) const {
        const double oneMinusCos = cosPart * oneMinusCosMax;
        const double r = std::sqrt(std::max(0.0, oneMinusCos * (2.0 - oneMinusCos)));
        const double phi = 2.0 * std::numbers::pi * phiPart;
        const glm::dvec3 w = r * std::cos(phi) * glm::dvec3(frame.s) +
                             r * std::sin(phi) * glm::dvec3(frame.t) +
                             (1.0 - oneMinusCos) * glm::dvec3(frame.n);
        return Vec3(glm::normalize(w));
    }
    size_t cell(const Vec3& w) const {
        const double x = glm::dot(glm::dvec3(w), glm::dvec3(frame.s)),
                     y = glm::dot(glm::dvec3(w), glm::dvec3(frame.t));
        const double z = glm::dot(glm::dvec3(w), glm::dvec3(frame.n));
        const double oneMinusCos = z > 0.0 ? (x * x + y * y) / (1.0 + z) : 1.0 - z;
        const double phi = std::atan2(y, x) / (2.0 * std::numbers::pi);
        const int i = std::clamp(static_cast<int>(oneMinusCos / oneMinusCosMax * kBinsCos), 0, kBinsCos - 1);
        const int j = std::clamp(static_cast<int>((phi < 0.0 ? phi + 1.0 : phi) * kBinsPhi), 0, kBinsPhi - 1);
        return static_cast<size_t>(i * kBinsPhi + j);
    }
    double cellSolidAngle() const { return 2.0 * std::numbers::pi * oneMinusCosMax / kCells; }
};

/// Counts a stratified integral of `density` over every cell would expect.
template <class Density>
std::vector<double> expectedCounts(const ConeGrid& grid, UniformNumbers& random, int samples,
                                   const Density& density) {
    std::vector<double> expected(ConeGrid::kCells, 0.0);
    constexpr int kSubdivisions = 40;
    constexpr double kShare = 1.0 / (kSubdivisions * kSubdivisions);
    for (int i = 0; i < ConeGrid::kBinsCos * kSubdivisions; ++i) {
        for (int j = 0; j < ConeGrid::kBinsPhi * kSubdivisions; ++j) {
            const double a = (i + static_cast<double>(random.next())) / (ConeGrid::kBinsCos * kSubdivisions);
            const double b = (j + static_cast<double>(random.next())) / (ConeGrid::kBinsPhi * kSubdivisions);
            const auto cell = static_cast<size_t>(i / kSubdivisions * ConeGrid::kBinsPhi + j / kSubdivisions);
            expected[cell] += samples * density(grid.direction(a, b)) * grid.cellSolidAngle() * kShare;
        }
    }
    return expected;
}

}  // namespace glint::test
