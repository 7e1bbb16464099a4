// Four floats at once for the hierarchy builder, with a plain body where there is no SSE. Host only; internal
// to engine/build.
#pragma once

#include <algorithm>
#include <cstdint>

#include "engine/kernels/simd.h"
#include "engine/math/vec.h"

namespace glint {

#if GLINT_HAS_AVX2

struct Lanes4 {
    __m128 v;

    static Lanes4 all(float x) { return {_mm_set1_ps(x)}; }
    static Lanes4 of(const Vec3& x) { return {_mm_setr_ps(x.x, x.y, x.z, 0.0f)}; }
    static Lanes4 load(const float* aligned) { return {_mm_load_ps(aligned)}; }
    Vec3 xyz() const {
        alignas(16) float x[4];
        _mm_store_ps(x, v);
        return {x[0], x[1], x[2]};
    }
    /// Truncates; values beyond int32 and NaN become `lo`.
    void storeClampedInts(int32_t lo, int32_t hi, int32_t out[4]) const {
        const __m128i i = _mm_cvttps_epi32(v);
        const __m128i clamped = _mm_min_epi32(_mm_max_epi32(i, _mm_set1_epi32(lo)), _mm_set1_epi32(hi));
        _mm_storeu_si128(reinterpret_cast<__m128i*>(out), clamped);
    }
    friend Lanes4 operator+(Lanes4 a, Lanes4 b) { return {_mm_add_ps(a.v, b.v)}; }
    friend Lanes4 operator-(Lanes4 a, Lanes4 b) { return {_mm_sub_ps(a.v, b.v)}; }
    friend Lanes4 operator*(Lanes4 a, Lanes4 b) { return {_mm_mul_ps(a.v, b.v)}; }
    friend Lanes4 min(Lanes4 a, Lanes4 b) { return {_mm_min_ps(a.v, b.v)}; }
    friend Lanes4 max(Lanes4 a, Lanes4 b) { return {_mm_max_ps(a.v, b.v)}; }
};

#else

struct Lanes4 {
    Vec3 v;

    static Lanes4 all(float x) { return {Vec3(x)}; }
    static Lanes4 of(const Vec3& x) { return {x}; }
    static Lanes4 load(const float* p) { return {Vec3(p[0], p[1], p[2])}; }
    Vec3 xyz() const { return v; }
    /// Truncates; values beyond int32 and NaN become `lo`.
    void storeClampedInts(int32_t lo, int32_t hi, int32_t out[4]) const {
        for (int i = 0; i < 3; ++i) {
            const bool inRange = v[i] > -2147483648.0f && v[i] < 2147483648.0f;
            out[i] = inRange ? std::clamp(static_cast<int32_t>(v[i]), lo, hi) : lo;
        }
        out[3] = lo;
    }
    friend Lanes4 operator+(Lanes4 a, Lanes4 b) { return {a.v + b.v}; }
    friend Lanes4 operator-(Lanes4 a, Lanes4 b) { return {a.v - b.v}; }
    friend Lanes4 operator*(Lanes4 a, Lanes4 b) { return {a.v * b.v}; }
    friend Lanes4 min(Lanes4 a, Lanes4 b) { return {glm::min(a.v, b.v)}; }
    friend Lanes4 max(Lanes4 a, Lanes4 b) { return {glm::max(a.v, b.v)}; }
};

#endif

}  // namespace glint
