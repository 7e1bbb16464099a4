// What pieces of profiles are made of from Bernstein coefficients: products, powers, lower
// degrees, quadratics.
#pragma once

#include "engine/kernels/profile_view.h"

namespace glint {

/// Bernstein coefficients of the product of two polynomials of one degree, 2 * degree + 1 of them (Farouki
/// and Rajan 1988, equation 44). Its ends are exact, so that neighbouring pieces agree about them.
void multiplyBernstein(const double* f, const double* g, int degree, double* product);

/// Coefficients of powers, of x (axis 0) or y, from those of Bernstein polynomials.
void bernsteinToPowers(const double* bernstein, int degree, int axis, double (*powers)[2]);

/// Lowers the degree, from 2 on, by one: the recurrences of raising it, from both ends (Forrest 1972),
/// blended by Eck's weights (1993, "Degree reduction of Bézier curves", CAGD 10). The ends keep their bits.
/// Returns how far it is off at most: as far as at so many Chebyshev points, by a factor (Ehlich and Zeller
/// 1964).
double lowerBernsteinDegree(double* f, int degree);

/// Of a polynomial of a degree from 2 on. The errors' bounds are the coefficients of the difference.
QuadraticFit fitQuadratic(const double* f, int degree);

}  // namespace glint
