// Where a ray meets a piece of a profile that turns about the y axis. Host and device.
//
// A point of the curve at parameter s turned by the angle a is (x cos a, y, -x sin a). Eliminating the ray's
// t from the equations of the ray and of the surface leaves, for a curve of degree n, one polynomial of
// degree 2n in s:
//   d.y^2 x(s)^2 = |o.xz d.y + (y(s) - o.y) d.xz|^2,   t = (y(s) - o.y) / d.y.
// All its roots are found: a quadratic close to it tells of most pieces that there is one or none, and
// where Newton's method starts; otherwise by bernstein.h. A ray that is nearly horizontal leaves y(s)
// alone: profile_level_rays.h.
#pragma once

#include "engine/base/inlining.h"
#include "engine/kernels/shapes/profile_level_rays.h"
#include "engine/kernels/shapes/profile_point.h"

namespace glint {
namespace detail {

/// The polynomial of a piece, for one ray.
struct PieceMiss {
    const ProfilePiece& piece;
    const ProfileRay& ray;
    double a, b, linear, constant, dy2;

    GLINT_HD PieceMiss(const ProfilePiece& of, const ProfileRay& by)
        : piece(of),
          ray(by),
          a(by.ox * by.dy - by.oy * by.dx),
          b(by.oz * by.dy - by.oy * by.dz),
          linear(2.0 * (a * by.dx + b * by.dz)),
          constant(a * a + b * b),
          dy2(by.dy * by.dy) {}

    /// The ray meets its end first.
    GLINT_HD bool isMetBackwards() const {
        return (piece.yFit.value[2] < piece.yFit.value[0]) != (ray.dy < 0.0);
    }
    GLINT_HD double coefficient(double xSquared, double ySquared, double y) const {
        return dy2 * xSquared - ray.flat2 * ySquared - linear * y - constant;
    }
    /// How much errors of the three add up to: with y measured from the piece's middle, so that they
    /// cancel less.
    GLINT_HD double error(double xSquared, double ySquared, double y) const {
        return dy2 * xSquared + ray.flat2 * ySquared + std::fabs(linear + 2.0 * ray.flat2 * piece.middle) * y;
    }
};

/// The polynomial's value from the curve itself, without the rounding of coefficients. kDegree: the piece's,
/// or 0 for any.
template <int kDegree>
struct ExactMiss {
    const PieceMiss& miss;
    PolynomialValue y{0.0, 0.0};  ///< where it was asked last
    double at = 0.0;

    GLINT_HD PolynomialValue operator()(double s) {
        const ProfileRay& ray = miss.ray;
        const auto [x, height] = pointOf<kDegree>(miss.piece, s);
        y = height;
        at = s;
        const double px = miss.a + y.value * ray.dx, pz = miss.b + y.value * ray.dz;
        const double ring = ray.dy * x.value;
        return {ring * ring - px * px - pz * pz,
                2.0 * (ring * ray.dy * x.derivative - (px * ray.dx + pz * ray.dz) * y.derivative)};
    }
    /// The ray's t at s, which is as close to where the value was asked last as roots get.
    GLINT_HD double rayT(double s) const {
        return (y.value + (s - at) * y.derivative - miss.ray.oy) * miss.ray.inverseDy;
    }
};

/// Parts of a piece with one root each.
struct RootBrackets {
    static constexpr int kUnclear = -1, kAskTurn = -2;
    int count = kUnclear;  ///< kAskTurn: none or two, as the polynomial is near `turn`
    double turn = 1.0;     ///< where the second begins
    double guess = 0.5;    ///< of the first
    double bend = 0.0;     ///< half the second derivative, at least bendError off 0 where it counts
    double bendError = 0.0;
    bool startsNegative = false;  ///< the first; the second is the other way round
};

/// What roots there are, from the quadratic alone, where it is far enough from what the polynomial may do
/// beside it.
GLINT_HD inline RootBrackets bracketsByQuadratic(const PieceMiss& miss) {
    const QuadraticFit &x = miss.piece.xSquaredFit, &y2 = miss.piece.ySquaredFit, &y = miss.piece.yFit;
    double q[3];
    for (int i = 0; i < 3; ++i) {
        q[i] = miss.coefficient(x.value[i], y2.value[i], y.value[i]);
    }
    const double slope = 2.0 * (q[1] - q[0]), lastSlope = 2.0 * (q[2] - q[1]);
    RootBrackets found;
    if (q[0] == 0.0 || q[2] == 0.0) { return found; }
    found.startsNegative = q[0] < 0.0;
    found.bend = q[0] - 2.0 * q[1] + q[2];
    found.bendError = 0.5 * miss.error(x.curvatureError, y2.curvatureError, y.curvatureError);
    const bool bends = std::fabs(found.bend) > found.bendError;
    const double side = found.startsNegative ? -1.0 : 1.0;
    if ((q[0] < 0.0) != (q[2] < 0.0)) {
        const double error = miss.error(x.slopeError, y2.slopeError, y.slopeError);
        if (!bends && !(-side * slope > error && -side * lastSlope > error)) { return found; }
        const double rise = -side * std::sqrt(std::fabs(slope * slope - 4.0 * found.bend * q[0]));
        const bool adds = (slope < 0.0) == (rise < 0.0);
        found.guess = adds ? -2.0 * q[0] / (slope + rise) : 0.5 * (rise - slope) / found.bend;
        found.count = 1;
        return found;
    }
    const double error = miss.error(x.error, y2.error, y.error);
    const bool isClear = side * q[0] > error && side * q[2] > error;
    if ((bends && side * found.bend < 0.0) || (isClear && side * q[1] > error)) {
        found.count = 0;
    } else if (bends) {
        const double turn = -0.5 * slope / found.bend;
        found.turn = turn > 0.0 && turn < 1.0 ? turn : 0.5;
        found.count = RootBrackets::kAskTurn;
    }
    return found;
}

/// Whether a polynomial that bends away from zero at both ends comes to it between them; moves the turn to
/// where it is on the other side. Unclear where it touches zero to within rounding.
template <class Exact>
GLINT_HD inline void askTurn(Exact&& exact, RootBrackets* brackets, uint32_t* steps) {
    const double side = brackets->startsNegative ? -1.0 : 1.0;
    const double leastBend = std::fabs(brackets->bend) - brackets->bendError;
    double begin = 0.0, end = 1.0, turn = brackets->turn;
    brackets->count = RootBrackets::kUnclear;
    for (int i = 0; i < 8; ++i) {
        ++*steps;
        const PolynomialValue at = exact(turn);
        if (side * at.value < 0.0) {
            brackets->turn = turn;
            brackets->count = 2;
            const double half = std::sqrt(std::fabs(at.value / brackets->bend));
            brackets->guess = turn > half ? turn - half : 0.5 * turn;
            return;
        }
        // A parabola below it that stays above zero.
        if (side * at.value * 4.0 * leastBend > at.derivative * at.derivative) {
            brackets->count = 0;
            return;
        }
        (side * at.derivative < 0.0 ? begin : end) = turn;
        turn -= 0.5 * at.derivative / brackets->bend;
        turn = turn > begin && turn < end ? turn : 0.5 * (begin + end);
    }
}

/// The root between two parameters, whose values differ in sign, from a guess: Newton's method with the fit's
/// second derivative (Chebyshev's method), for one evaluation less. Ends when a bound of what is left of the
/// error, to third order in the step, is at most `close`.
template <class Exact>
GLINT_HD inline double rootByFit(Exact&& exact, const RootBrackets& fit, double lo, double hi,
                                 bool startsNegative, double guess, double close, uint32_t* steps) {
    constexpr double kLeastStep = 1e-9;
    double x = guess;
    for (int i = 0; i < 64; ++i) {
        ++*steps;
        const PolynomialValue at = exact(x);
        ((at.value < 0.0) == startsNegative ? lo : hi) = x;
        const double inverse = 1.0 / at.derivative;
        const double step = at.value * inverse, bent = fit.bend * inverse * step;
        // Far from the root, Newton's own step is the one that comes to it wherever it starts.
        const double next = x - step * (std::fabs(bent) < 0.5 ? 1.0 + bent : 1.0);
        const double left = std::fabs(step) * (fit.bendError * std::fabs(inverse * step) + 2.0 * bent * bent);
        // With another root just beyond the bracket's end, the guess may be closer to that one.
        const bool crosses = (at.derivative > 0.0) == startsNegative;
        if (crosses && (left <= close || std::fabs(step) <= kLeastStep)) {
            return next < lo ? lo : next > hi ? hi : next;
        }
        x = crosses && next > lo && next < hi ? next : 0.5 * (lo + hi);
        if (hi - lo <= kLeastStep) { break; }
    }
    return x;
}

/// A root at an end of its bracket. Brackets come from rounded coefficients, so that it may lie a little
/// beyond its end, which moves the hit of a nearly horizontal ray a million times as far: Newton's method
/// goes on there.
template <class Exact>
GLINT_HD inline double rootBeyond(Exact&& exact, double s, uint32_t* steps) {
    constexpr double kFarthest = 1e-7;
    double root = s;
    for (int i = 0; i < 3; ++i) {
        ++*steps;
        const PolynomialValue at = exact(root);
        const double next = root - at.value / at.derivative;
        if (!(std::fabs(next - s) <= kFarthest)) { break; }
        root = next;
    }
    return root;
}

/// All roots, with Bernstein coefficients of the whole degree.
template <class Found>
GLINT_ONE_PIECE_APART GLINT_HD uint32_t meetThoroughly(const PieceMiss& miss, const Found& found) {
    const ProfilePiece& piece = miss.piece;
    const int degree = 2 * piece.degree;
    double f[2 * kMaxProfileDegree + 1];
    for (int i = 0; i <= degree; ++i) {
        f[i] = miss.coefficient(piece.xSquared[i], piece.ySquared[i], piece.yRaised[i]);
    }
    uint32_t steps = 0;
    ExactMiss<0> exact{miss};
    const auto take = [&](double s) {
        exact(s);
        found(s < 0.0 ? 0.0 : s > 1.0 ? 1.0 : s, exact.rayT(s));
    };
    const double close = miss.ray.closeStep();
    forEachBernsteinBracket<2 * kMaxProfileDegree>(
        f, degree, [&](double begin, double end, bool startsNegative, double guess) {
            if (begin == end) { return take(guess); }
            const double s = bracketedRoot(exact, begin, end, startsNegative, guess, &steps, close);
            take(s <= begin + close || s >= end - close ? rootBeyond(exact, s, &steps) : s);
        });
    // Along the axis itself a pole is where the polynomial touches zero, and changes no sign.
    if (f[0] == 0.0 && piece.xSquared[0] == 0.0) { take(0.0); }
    if (f[degree] == 0.0 && piece.xSquared[degree] == 0.0) { take(1.0); }
    return steps;
}

template <int kDegree, class Found>
GLINT_HD inline uint32_t meetSteeply(const PieceMiss& miss, const Found& found) {
    RootBrackets brackets = bracketsByQuadratic(miss);
    uint32_t steps = 0;
    ExactMiss<kDegree> exact{miss};
    if (brackets.count == RootBrackets::kAskTurn) { askTurn(exact, &brackets, &steps); }
    if (brackets.count == RootBrackets::kUnclear) { return steps + meetThoroughly(miss, found); }
    // Heights rise or fall all along a piece, and the ray's t with them.
    const bool comesLast = brackets.count == 2 && miss.isMetBackwards();
    for (int i = 0; i < brackets.count; ++i) {
        const bool isSecond = (i == 1) != comesLast;
        const double begin = isSecond ? brackets.turn : 0.0;
        const double end = isSecond || brackets.count == 1 ? 1.0 : brackets.turn;
        const double mirrored = 2.0 * brackets.turn - brackets.guess;
        const double guess = !isSecond ? brackets.guess : mirrored < 1.0 ? mirrored : 0.5 * (begin + end);
        const double s = rootByFit(exact, brackets, begin, end, brackets.startsNegative != isSecond, guess,
                                   miss.ray.closeRoot(), &steps);
        if (found(s, exact.rayT(s))) { break; }
    }
    return steps;
}

}  // namespace detail

/// Calls found(s, t) for every place where the ray meets the piece: the piece's parameter, and t from the
/// ray's origin. Returns Newton's steps.
template <class Found>
GLINT_HD inline uint32_t meetPiece(const ProfilePiece& piece, const ProfileRay& ray, const Found& found) {
    if (ray.isHorizontal) { return detail::meetHorizontally(piece, ray, found); }
    const detail::PieceMiss miss(piece, ray);
    switch (piece.degree) {
        case 1:
            return detail::meetSteeply<1>(miss, found);
        case 2:
            return detail::meetSteeply<2>(miss, found);
        case 3:
            return detail::meetSteeply<3>(miss, found);
        default:
            return detail::meetSteeply<0>(miss, found);
    }
}

}  // namespace glint
