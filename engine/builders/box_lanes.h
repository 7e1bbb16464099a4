// Boxes as one vector (lower corner, negated upper corner), so that joining two is a single minimum. With a
// plain body where there is no AVX. Host only; internal to the hierarchy builder.
#pragma once

#include <algorithm>
#include <cstdint>

#include "engine/builders/bvh_builder.h"
#include "engine/kernels/simd.h"

namespace glint {

#if GLINT_HAS_AVX2

/// Lanes 0..2: lower corner; 4..6: negated upper corner; 3 and 7 are never read.
struct BoxLanes {
    __m256 v = _mm256_set1_ps(kInfinity);

    static BoxLanes of(const BuildPrimitive& p) { return {_mm256_load_ps(&p.lo.x)}; }
    /// The box around one point: the primitive's centre, doubled.
    static BoxLanes doubledCenter(const BuildPrimitive& p) {
        const __m256 box = _mm256_load_ps(&p.lo.x);
        const __m128 center = _mm_sub_ps(_mm256_castps256_ps128(box), _mm256_extractf128_ps(box, 1));
        const __m128 negated = _mm_xor_ps(center, _mm_set1_ps(-0.0f));
        return {_mm256_insertf128_ps(_mm256_castps128_ps256(center), negated, 1)};
    }
    void grow(const BoxLanes& b) { v = _mm256_min_ps(v, b.v); }
    Bounds bounds() const {
        alignas(32) float x[8];
        _mm256_store_ps(x, v);
        return {Vec3(x[0], x[1], x[2]), -Vec3(x[4], x[5], x[6])};
    }
    float halfArea() const {
        const __m128 e =
            _mm_sub_ps(_mm_setzero_ps(), _mm_add_ps(_mm256_castps256_ps128(v), _mm256_extractf128_ps(v, 1)));
        const __m128 yzx = _mm_permute_ps(e, _MM_SHUFFLE(3, 0, 2, 1));
        const __m128 products = _mm_mul_ps(e, yzx);
        const __m128 sum = _mm_add_ss(_mm_add_ss(products, _mm_movehdup_ps(products)),
                                      _mm_permute_ps(products, _MM_SHUFFLE(2, 2, 2, 2)));
        return _mm_cvtss_f32(sum);
    }
};

#else

struct BoxLanes {
    Vec3 lo{kInfinity};
    Vec3 negatedHi{kInfinity};

    static BoxLanes of(const BuildPrimitive& p) { return {p.lo, p.negatedHi}; }
    /// The box around one point: the primitive's centre, doubled.
    static BoxLanes doubledCenter(const BuildPrimitive& p) {
        return {p.lo - p.negatedHi, -(p.lo - p.negatedHi)};
    }
    void grow(const BoxLanes& b) {
        lo = glm::min(lo, b.lo);
        negatedHi = glm::min(negatedHi, b.negatedHi);
    }
    Bounds bounds() const { return {lo, -negatedHi}; }
    float halfArea() const { return bounds().halfArea(); }
};

#endif

/// Maps a primitive to a bin along each axis by its centre. Scalar and vector forms give the same bins.
class BinMap {
  public:
    BinMap(const Bounds& doubledCenters, int bins)
        : origin_(doubledCenters.lo), last_(static_cast<float>(bins - 1)) {
        const Vec3 extent = doubledCenters.extent();
        for (int axis = 0; axis < 3; ++axis) {
            const float perBin = 0.9999f * static_cast<float>(bins) / extent[axis];
            if (extent[axis] > 0.0f && perBin < kInfinity) { scale_[axis] = perBin; }
        }
    }
    bool splits(int axis) const { return scale_[axis] > 0.0f; }
    bool empty() const { return isZero(scale_); }

    int bin(const BuildPrimitive& p, int axis) const {
        const float x = (p.lo[axis] - p.negatedHi[axis] - origin_[axis]) * scale_[axis];
        return static_cast<int>(std::min(std::max(x, 0.0f), last_));
    }
    void bins(const BuildPrimitive& p, uint32_t bin[3]) const {
#if GLINT_HAS_AVX2
        const __m128 lo = _mm_load_ps(&p.lo.x);
        const __m128 negatedHi = _mm_load_ps(&p.negatedHi.x);
        const __m128 origin = _mm_setr_ps(origin_.x, origin_.y, origin_.z, 0.0f);
        const __m128 scale = _mm_setr_ps(scale_.x, scale_.y, scale_.z, 0.0f);
        const __m128 x = _mm_mul_ps(_mm_sub_ps(_mm_sub_ps(lo, negatedHi), origin), scale);
        const __m128i i = _mm_cvttps_epi32(_mm_min_ps(_mm_max_ps(x, _mm_setzero_ps()), _mm_set1_ps(last_)));
        const uint64_t xy = static_cast<uint64_t>(_mm_cvtsi128_si64(i));
        bin[0] = static_cast<uint32_t>(xy);
        bin[1] = static_cast<uint32_t>(xy >> 32);
        bin[2] = static_cast<uint32_t>(_mm_extract_epi32(i, 2));
#else
        for (int axis = 0; axis < 3; ++axis) {
            bin[axis] = static_cast<uint32_t>(this->bin(p, axis));
        }
#endif
    }

  private:
    Vec3 origin_;
    Vec3 scale_{0.0f};
    float last_;
};

}  // namespace glint
