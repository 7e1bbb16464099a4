// Points of a piece of a profile. Host and device.
#pragma once

#include <cmath>

#include "engine/kernels/profile_view.h"
#include "engine/kernels/simd.h"
#include "engine/math/bernstein.h"

namespace glint {
namespace detail {

/// The distance from the axis and the height.
struct ProfilePoint {
    PolynomialValue x, y;
};

/// The profile at a piece's parameter. kDegree: the piece's, or 0 for any.
template <int kDegree = 0>
GLINT_HD inline ProfilePoint pointOf(const ProfilePiece& piece, double s) {
    const int n = kDegree > 0 ? kDegree : piece.degree;
#if GLINT_HAS_AVX2
    const __m128d at = _mm_set1_pd(s);
    __m128d value = _mm_load_pd(piece.powers[n]), derivative = _mm_setzero_pd();
    for (int i = n - 1; i >= 0; --i) {
        derivative = _mm_fmadd_pd(derivative, at, value);
        value = _mm_fmadd_pd(value, at, _mm_load_pd(piece.powers[i]));
    }
    return {{_mm_cvtsd_f64(value), _mm_cvtsd_f64(derivative)},
            {_mm_cvtsd_f64(_mm_unpackhi_pd(value, value)),
             _mm_cvtsd_f64(_mm_unpackhi_pd(derivative, derivative))}};
#else
    ProfilePoint point{{piece.powers[n][0], 0.0}, {piece.powers[n][1], 0.0}};
    for (int i = n - 1; i >= 0; --i) {
        point.x.derivative = std::fma(point.x.derivative, s, point.x.value);
        point.y.derivative = std::fma(point.y.derivative, s, point.y.value);
        point.x.value = std::fma(point.x.value, s, piece.powers[i][0]);
        point.y.value = std::fma(point.y.value, s, piece.powers[i][1]);
    }
    return point;
#endif
}

}  // namespace detail
}  // namespace glint
