#include "engine/builders/profile_builder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <glm/ext/vector_double2.hpp>

#include "engine/math/bernstein.h"
#include "engine/scene/profile.h"

namespace glint {
namespace {

using Point = glm::dvec2;

double binomial(int n, int k) {
    double value = 1.0;
    for (int i = 0; i < k; ++i) {
        value = value * (n - i) / (i + 1);
    }
    return value;
}

/// Bernstein coefficients of the product of two polynomials of one degree (Farouki and Rajan 1988, equation
/// 44).
void multiply(const double* f, const double* g, int degree, double* product) {
    std::fill(product, product + 2 * degree + 1, 0.0);
    for (int i = 0; i <= degree; ++i) {
        for (int j = 0; j <= degree; ++j) {
            product[i + j] +=
                binomial(degree, i) * binomial(degree, j) / binomial(2 * degree, i + j) * f[i] * g[j];
        }
    }
    // The ends are exact, so that neighbouring curves agree about them.
    product[0] = f[0] * g[0];
    product[2 * degree] = f[degree] * g[degree];
}

/// The Bézier points of the span of a uniform cubic B-spline that begins at `p`.
std::array<Point, 4> spanPoints(const Vec2* p) {
    const auto knot = [&](int i) { return (Point(p[i]) + 4.0 * Point(p[i + 1]) + Point(p[i + 2])) / 6.0; };
    return {knot(0), (2.0 * Point(p[1]) + Point(p[2])) / 3.0, (Point(p[1]) + 2.0 * Point(p[2])) / 3.0,
            knot(1)};
}

/// Coefficients of powers from those of Bernstein polynomials, by forward differences.
void toPowers(const double* bernstein, int degree, double* powers) {
    std::vector<double> differences(bernstein, bernstein + degree + 1);
    for (int i = 0; i <= degree; ++i) {
        powers[i] = binomial(degree, i) * differences[0];
        for (size_t k = 0; k + 1 < differences.size(); ++k) {
            differences[k] = differences[k + 1] - differences[k];
        }
        differences.pop_back();
    }
}

ProfileCurve makeCurve(const Point* points, int degree) {
    ProfileCurve curve{};
    curve.degree = degree;
    curve.lowest = curve.highest = points[0].y;
    for (int i = 0; i <= degree; ++i) {
        curve.x[i] = points[i].x;
        curve.y[i] = points[i].y;
        curve.radius = std::max(curve.radius, std::fabs(points[i].x));
        curve.lowest = std::min(curve.lowest, points[i].y);
        curve.highest = std::max(curve.highest, points[i].y);
    }
    double one[kMaxProfileDegree + 1];
    std::fill(std::begin(one), std::end(one), 1.0);
    multiply(curve.x, curve.x, degree, curve.xSquared);
    multiply(curve.y, curve.y, degree, curve.ySquared);
    multiply(curve.y, one, degree, curve.yRaised);
    if (degree < static_cast<int>(std::size(curve.xPowers))) {
        toPowers(curve.x, degree, curve.xPowers);
        toPowers(curve.y, degree, curve.yPowers);
    }
    return curve;
}

/// The volume between a curve and the axis over pi, the integral of x^2 dy: positive where the outside is to
/// the right of a curve that runs upwards.
double volumeOf(const ProfileCurve& curve) {
    constexpr int kSteps = 256;
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        const double s = (i + 0.5) / kSteps;
        const double x = evaluateBernstein<kMaxProfileDegree>(curve.x, curve.degree, s).value;
        sum += x * x * evaluateBernstein<kMaxProfileDegree>(curve.y, curve.degree, s).derivative / kSteps;
    }
    return sum;
}

/// Area of the surface between two parameters of a curve, over 2 pi.
double ringOf(const ProfileCurve& curve, double begin, double end) {
    constexpr int kSteps = 32;
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        const double s = begin + (end - begin) * (i + 0.5) / kSteps;
        const PolynomialValue x = evaluateBernstein<kMaxProfileDegree>(curve.x, curve.degree, s);
        const PolynomialValue y = evaluateBernstein<kMaxProfileDegree>(curve.y, curve.degree, s);
        sum += std::fabs(x.value) * std::hypot(x.derivative, y.derivative);
    }
    return sum * (end - begin) / kSteps;
}

void tabulateArea(std::vector<ProfileCurve>* curves) {
    constexpr int kSteps = ProfileCurve::kAreaSteps;
    std::vector<double> before{0.0};
    for (const ProfileCurve& curve : *curves) {
        for (int step = 0; step < kSteps; ++step) {
            before.push_back(before.back() + ringOf(curve, static_cast<double>(step) / kSteps,
                                                    static_cast<double>(step + 1) / kSteps));
        }
    }
    const double all = before.back();
    for (size_t i = 0; i < curves->size(); ++i) {
        ProfileCurve& curve = (*curves)[i];
        curve.area = static_cast<float>(2.0 * std::numbers::pi * all);
        for (size_t step = 0; step <= kSteps; ++step) {
            curve.areaBefore[step] = static_cast<float>(all > 0.0 ? before[i * kSteps + step] / all : 0.0);
        }
    }
}

}  // namespace

std::vector<ProfileCurve> buildProfile(const Object& object) {
    const ProfileCurves shape = profileCurves(object);
    std::vector<ProfileCurve> curves;
    double volume = 0.0;
    for (size_t i = 0; i < shape.count; ++i) {
        std::array<Point, kMaxProfileDegree + 1> points{};
        if (object.curve == CurveKind::Bspline) {
            std::ranges::copy(spanPoints(&object.profile[i]), points.begin());
        } else {
            const auto first = object.profile.begin() + static_cast<std::ptrdiff_t>(i) * shape.degree;
            std::transform(first, first + shape.degree + 1, points.begin(),
                           [](const Vec2& p) { return Point(p); });
        }
        curves.push_back(makeCurve(points.data(), shape.degree));
        volume += volumeOf(curves.back());
    }
    const Bounds box = profileBounds(object.profile);
    for (ProfileCurve& curve : curves) {
        curve.count = static_cast<uint32_t>(shape.count);
        curve.centerY = 0.5 * (static_cast<double>(box.lo.y) + static_cast<double>(box.hi.y));
        curve.size = glm::length(glm::dvec3(box.hi) - glm::dvec3(box.lo));
        curve.front = volume < 0.0 ? -1.0f : 1.0f;
    }
    tabulateArea(&curves);
    return curves;
}

}  // namespace glint
