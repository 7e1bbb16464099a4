// Polynomials in Bernstein form on [0, 1]: values, restriction to a part, and all real roots. Host
// and device.
//
// The roots are isolated by Descartes' rule of signs for Bernstein coefficients (Lane and Riesenfeld 1981,
// "Bounds on a polynomial", BIT 21): a part whose coefficients change their sign once has one root, and one
// without a change has none; others are halved. Within a part, Newton's method runs inside a bracket.
#pragma once

#include <cmath>
#include <cstdint>

#include "engine/base/host_device.h"

namespace glint {

/// A polynomial's value and derivative.
struct PolynomialValue {
    double value;
    double derivative;
};

/// By de Casteljau's algorithm; `coefficients` has degree + 1 entries, degree from 1 to kMaxDegree.
template <int kMaxDegree>
GLINT_HD inline PolynomialValue evaluateBernstein(const double* coefficients, int degree, double x) {
    double b[kMaxDegree + 1];
    b[0] = coefficients[0];
    b[1] = coefficients[1];
    for (int i = 2; i <= degree; ++i) {
        b[i] = coefficients[i];
    }
    for (int left = degree; left > 1; --left) {
        for (int i = 0; i < left; ++i) {
            b[i] += x * (b[i + 1] - b[i]);
        }
    }
    return {b[0] + x * (b[1] - b[0]), degree * (b[1] - b[0])};
}

namespace detail {

/// Changes the coefficients to those of the part [begin, end] of [0, 1].
GLINT_HD inline void restrictBernstein(double* b, int degree, double begin, double end) {
    if (end < 1.0) {
        for (int last = degree; last > 0; --last) {
            for (int i = degree; i > degree - last; --i) {
                b[i] = b[i - 1] + end * (b[i] - b[i - 1]);
            }
        }
    }
    const double share = begin / end;
    if (share > 0.0) {
        for (int left = degree; left > 0; --left) {
            for (int i = 0; i < left; ++i) {
                b[i] += share * (b[i + 1] - b[i]);
            }
        }
    }
}

/// Zero counts as positive, so that neighbouring parts agree about their common end.
GLINT_HD inline int signChanges(const double* b, int degree) {
    int changes = 0;
    for (int i = 0; i < degree; ++i) {
        changes += static_cast<int>((b[i] < 0.0) != (b[i + 1] < 0.0));
    }
    return changes;
}

/// Where the control polygon first crosses zero: close to the root where there is one. The signs of the
/// ends differ.
GLINT_HD inline double polygonRoot(const double* b, int degree) {
    int i = 0;
    while (i + 1 < degree && (b[i] < 0.0) == (b[i + 1] < 0.0)) {
        ++i;
    }
    return (i + b[i] / (b[i] - b[i + 1])) / degree;
}

}  // namespace detail

/// Newton's method for f(x), a PolynomialValue, from x within a bracket whose ends differ in sign. Ends with
/// a step, or a bracket, of at most `close`; where the slope is not close to 0 there, a step's square is what
/// is left of the error. *steps counts evaluations.
template <class Function>
GLINT_HD inline double bracketedRoot(Function&& f, double lo, double hi, bool startsNegative, double x,
                                     uint32_t* steps, double close = 1e-9) {
    for (int i = 0; i < 64; ++i) {
        ++*steps;
        const PolynomialValue at = f(x);
        if ((at.value < 0.0) == startsNegative) {
            lo = x;
        } else {
            hi = x;
        }
        const double newton = x - at.value / at.derivative;
        if (std::fabs(newton - x) <= close) { return newton < lo ? lo : newton > hi ? hi : newton; }
        x = newton > lo && newton < hi ? newton : 0.5 * (lo + hi);
        if (hi - lo <= close) { break; }
    }
    return x;
}

/// Calls found(begin, end, startsNegative, guess) for parts of [0, 1] that have a root each, rising; the
/// guess is close to it. Roots closer together than about 1e-8 count as one, whose part is given as a point,
/// and a place where the polynomial touches zero to within its rounding may count as a root or not. kMost:
/// the largest degree; where it is the degree itself, the code is straight.
template <int kMost, class Found>
GLINT_HD inline void forEachBernsteinBracket(const double* coefficients, int degree, const Found& found) {
    constexpr int kDeepest = 26;
    int level = 0;
    uint32_t index = 0;  // of 2^level parts
    for (;;) {
        double b[kMost + 1];
        for (int i = 0; i <= degree; ++i) {
            b[i] = coefficients[i];
        }
        const double width = 1.0 / static_cast<double>(1u << level);
        if (level > 0) { detail::restrictBernstein(b, degree, index * width, (index + 1) * width); }
        const int changes = detail::signChanges(b, degree);
        if (changes > 1 && level < kDeepest) {
            ++level;
            index *= 2;
            continue;
        }
        if (changes > 0) {
            const double begin = index * width;
            if ((b[0] < 0.0) != (b[degree] < 0.0)) {
                found(begin, begin + width, b[0] < 0.0, begin + width * detail::polygonRoot(b, degree));
            } else {
                found(begin + 0.5 * width, begin + 0.5 * width, false, begin + 0.5 * width);
            }
        }
        ++index;
        while (level > 0 && index % 2 == 0) {
            index /= 2;
            --level;
        }
        if (level == 0) { return; }
    }
}

/// Calls found(x) for the roots in [0, 1], rising, as forEachBernsteinBracket() says. Returns Newton's steps.
template <int kMost, class Found>
GLINT_HD inline uint32_t forEachBernsteinRoot(const double* coefficients, int degree, const Found& found) {
    uint32_t steps = 0;
    auto valueAt = [&](double x) { return evaluateBernstein<kMost>(coefficients, degree, x); };
    forEachBernsteinBracket<kMost>(
        coefficients, degree, [&](double begin, double end, bool startsNegative, double guess) {
            found(begin < end ? bracketedRoot(valueAt, begin, end, startsNegative, guess, &steps) : guess);
        });
    return steps;
}

}  // namespace glint
