#include "tests/support/direction_grid.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace glint::test {
namespace {

constexpr double kPiDouble = 3.14159265358979323846;
constexpr int kDepth = 9;  // of subdivision, at most

struct Rectangle {
    double x0, x1, y0, y1;
};

/// 4 x 4 Gauss-Legendre.
double gauss(const std::function<double(double, double)>& f, const Rectangle& r) {
    static constexpr std::array<double, 4> kNode{-0.8611363115940526, -0.3399810435848563, 0.3399810435848563,
                                                 0.8611363115940526};
    static constexpr std::array<double, 4> kWeight{0.3478548451374538, 0.6521451548625461, 0.6521451548625461,
                                                   0.3478548451374538};
    const double hx = 0.5 * (r.x1 - r.x0);
    const double hy = 0.5 * (r.y1 - r.y0);
    double sum = 0.0;
    for (size_t i = 0; i < 4; ++i) {
        for (size_t j = 0; j < 4; ++j) {
            sum += kWeight[i] * kWeight[j] * f(r.x0 + hx * (1.0 + kNode[i]), r.y0 + hy * (1.0 + kNode[j]));
        }
    }
    return sum * hx * hy;
}

double adaptive(const std::function<double(double, double)>& f, const Rectangle& r, double whole,
                double tolerance, int depth) {
    const double mx = 0.5 * (r.x0 + r.x1);
    const double my = 0.5 * (r.y0 + r.y1);
    const std::array<Rectangle, 4> parts{
        {{r.x0, mx, r.y0, my}, {mx, r.x1, r.y0, my}, {r.x0, mx, my, r.y1}, {mx, r.x1, my, r.y1}}};
    std::array<double, 4> values{};
    double sum = 0.0;
    for (size_t i = 0; i < 4; ++i) {
        values[i] = gauss(f, parts[i]);
        sum += values[i];
    }
    // The first subdivisions are unconditional: a narrow part of the density may lie between all points.
    const bool converged = depth <= kDepth - 2 && std::fabs(sum - whole) < tolerance;
    if (depth == 0 || converged) { return sum; }
    sum = 0.0;
    for (size_t i = 0; i < 4; ++i) {
        sum += adaptive(f, parts[i], values[i], 0.5 * tolerance, depth - 1);
    }
    return sum;
}

}  // namespace

DirectionGrid::DirectionGrid(const Vec3& axis, double smallestAngleRad, int rings, int sectors)
    : frame_(Frame::fromNormal(glm::normalize(axis))),
      smallest_(smallestAngleRad),
      ratioLog_(std::log(kPiDouble / smallestAngleRad) / rings),
      rings_(rings),
      sectors_(sectors) {}

double DirectionGrid::ringAngle(int ring) const {
    return ring < 0 ? 0.0 : std::min(smallest_ * std::exp(ratioLog_ * ring), kPiDouble);
}

int DirectionGrid::cellOf(const Vec3& direction) const {
    const glm::dvec3 local(frame_.toLocal(direction));
    const double angle = std::atan2(std::hypot(local.x, local.y), local.z);
    const int ring = angle < smallest_
                         ? -1
                         : std::min(static_cast<int>(std::log(angle / smallest_) / ratioLog_), rings_ - 1);
    const double turn = 0.5 + std::atan2(local.y, local.x) / (2.0 * kPiDouble);
    return (ring + 1) * sectors_ + std::min(static_cast<int>(turn * sectors_), sectors_ - 1);
}

std::vector<double> DirectionGrid::integrate(const std::function<double(const Vec3&)>& density) const {
    const auto integrand = [&](double angle, double turn) {
        const double phi = (turn - 0.5) * 2.0 * kPiDouble;
        const glm::dvec3 local(std::sin(angle) * std::cos(phi), std::sin(angle) * std::sin(phi),
                               std::cos(angle));
        return density(glm::normalize(frame_.toWorld(Vec3(local)))) * std::sin(angle) * 2.0 * kPiDouble;
    };
    std::vector<double> sums(static_cast<size_t>(cells()));
    for (int ring = -1; ring < rings_; ++ring) {
        for (int sector = 0; sector < sectors_; ++sector) {
            const Rectangle cell{ringAngle(ring), ringAngle(ring + 1), static_cast<double>(sector) / sectors_,
                                 (sector + 1.0) / sectors_};
            sums[static_cast<size_t>((ring + 1) * sectors_ + sector)] =
                adaptive(integrand, cell, gauss(integrand, cell), 1e-6, kDepth);
        }
    }
    return sums;
}

}  // namespace glint::test
