// Polynomials in Bernstein form on [0, 1]: values, restriction to a part, and all real roots. Host and
// device.
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

/// The root between 0 and 1, where the signs differ. *steps counts Newton's.
template <int kMaxDegree>
GLINT_HD inline double bracketedRoot(const double* b, int degree, uint32_t* steps) {
    double lo = 0.0, hi = 1.0;
    const bool startsNegative = b[0] < 0.0;
    double x = b[0] / (b[0] - b[degree]);
    for (int i = 0; i < 64; ++i) {
        ++*steps;
        const PolynomialValue at = evaluateBernstein<kMaxDegree>(b, degree, x);
        if ((at.value < 0.0) == startsNegative) {
            lo = x;
        } else {
            hi = x;
        }
        const double newton = x - at.value / at.derivative;
        const double next = newton > lo && newton < hi ? newton : 0.5 * (lo + hi);
        if (std::fabs(next - x) <= 1e-15) { return next; }
        x = next;
    }
    return x;
}

}  // namespace detail

/// Calls found(x) for the roots in [0, 1], rising. Roots closer together than about 1e-8 count as one, and a
/// place where the polynomial touches zero to within its rounding may count as a root or not. Returns
/// Newton's steps.
template <int kMaxDegree, class Found>
GLINT_HD inline uint32_t forEachBernsteinRoot(const double* coefficients, int degree, const Found& found) {
    constexpr int kDeepest = 26;
    uint32_t steps = 0;
    int level = 0;
    uint32_t index = 0;  // of 2^level parts
    for (;;) {
        double b[kMaxDegree + 1];
        for (int i = 0; i <= degree; ++i) {
            b[i] = coefficients[i];
        }
        const double width = std::ldexp(1.0, -level);
        if (level > 0) { detail::restrictBernstein(b, degree, index * width, (index + 1) * width); }
        const int changes = detail::signChanges(b, degree);
        if (changes > 1 && level < kDeepest) {
            ++level;
            index *= 2;
            continue;
        }
        if (changes > 0) {
            const bool endsDiffer = (b[0] < 0.0) != (b[degree] < 0.0);
            const double root = endsDiffer ? detail::bracketedRoot<kMaxDegree>(b, degree, &steps) : 0.5;
            found((index + root) * width);
        }
        ++index;
        while (level > 0 && index % 2 == 0) {
            index /= 2;
            --level;
        }
        if (level == 0) { return steps; }
    }
}

}  // namespace glint
