// One ray against the eight boxes of a node: the slab test, in one SIMD and one scalar body that give the
// same bits.
//
// Conservative (Ize 2013, "Robust BVH Ray Traversal", JCGT
// 2(2)): a box that the exact ray touches is never missed; one that it just misses may be reported.
#pragma once

#include "engine/kernels/bvh_nodes.h"
#include "engine/kernels/simd.h"
#include "engine/math/bounds.h"
#include "engine/math/ray.h"

namespace glint {

/// What of a ray the slab test needs, computed once per ray and space.
struct BoxRay {
    Vec3 origin;
    Vec3 inverseDirection;  ///< may be infinite: the test is written so that 0 * inf drops out
    int nearRow[3];         ///< which row of WideNode::bounds the ray meets first
};

/// Widens the interval by more than the rounding of subtraction, product and reciprocal, and of the triangle
/// test's shear: about 16 units in the last place.
constexpr float kSlabWidening = 1.0f + 0x1p-20f;

GLINT_HD inline BoxRay makeBoxRay(const Ray& ray) {
    BoxRay box{ray.origin, Vec3(1.0f) / ray.direction, {0, 0, 0}};
    for (int axis = 0; axis < 3; ++axis) {
        box.nearRow[axis] = lowerRow(axis) + (std::signbit(ray.direction[axis]) ? 1 : 0);
    }
    return box;
}

/// Bit i of the result: the ray meets child i between tMin and tMax, first at distance[i] (valid for set bits
/// only). Each comparison keeps its second operand when the first is NaN, which is 0 * inf on a slab's very
/// plane: a touch.
GLINT_HD inline uint32_t boxHitsScalar(const WideNode& node, const BoxRay& ray, float tMin, float tMax,
                                       float* distance) {
    uint32_t hits = 0;
    for (int i = 0; i < kNodeWidth; ++i) {
        float tNear = tMin;
        float tFar = kInfinity;
        for (int axis = 0; axis < 3; ++axis) {
            const int row = ray.nearRow[axis];
            const float t0 = (node.bounds[row][i] - ray.origin[axis]) * ray.inverseDirection[axis];
            const float t1 = (node.bounds[row ^ 1][i] - ray.origin[axis]) * ray.inverseDirection[axis];
            tNear = t0 > tNear ? t0 : tNear;
            tFar = t1 < tFar ? t1 : tFar;
        }
        tFar = tFar * kSlabWidening;
        tFar = tFar < tMax ? tFar : tMax;
        distance[i] = tNear;
        hits |= (tNear <= tFar ? 1u : 0u) << i;
    }
    return hits;
}

/// The same for one box, and where the ray leaves it, which is not before any of it that it touches.
GLINT_HD inline bool boxHit(const Bounds& bounds, const BoxRay& ray, float tMin, float tMax, float* tEnter,
                            float* tLeave) {
    float tNear = tMin;
    float tFar = kInfinity;
    for (int axis = 0; axis < 3; ++axis) {
        const bool isBackwards = ray.nearRow[axis] != lowerRow(axis);
        const float first = isBackwards ? bounds.hi[axis] : bounds.lo[axis];
        const float last = isBackwards ? bounds.lo[axis] : bounds.hi[axis];
        const float t0 = (first - ray.origin[axis]) * ray.inverseDirection[axis];
        const float t1 = (last - ray.origin[axis]) * ray.inverseDirection[axis];
        tNear = t0 > tNear ? t0 : tNear;
        tFar = t1 < tFar ? t1 : tFar;
    }
    tFar = tFar * kSlabWidening;
    *tEnter = tNear;
    *tLeave = tFar < tMax ? tFar : tMax;
    return tNear <= *tLeave;
}

#if GLINT_HAS_AVX2
inline uint32_t boxHitsSimd(const WideNode& node, const BoxRay& ray, float tMin, float tMax,
                            float* distance) {
    __m256 tNear = _mm256_set1_ps(tMin);
    __m256 tFar = _mm256_set1_ps(kInfinity);
    for (int axis = 0; axis < 3; ++axis) {
        const __m256 origin = _mm256_set1_ps(ray.origin[axis]);
        const __m256 inverse = _mm256_set1_ps(ray.inverseDirection[axis]);
        const int row = ray.nearRow[axis];
        const __m256 t0 = _mm256_mul_ps(_mm256_sub_ps(_mm256_load_ps(node.bounds[row]), origin), inverse);
        const __m256 t1 = _mm256_mul_ps(_mm256_sub_ps(_mm256_load_ps(node.bounds[row ^ 1]), origin), inverse);
        tNear = _mm256_max_ps(t0, tNear);
        tFar = _mm256_min_ps(t1, tFar);
    }
    tFar = _mm256_min_ps(_mm256_mul_ps(tFar, _mm256_set1_ps(kSlabWidening)), _mm256_set1_ps(tMax));
    _mm256_store_ps(distance, tNear);
    return static_cast<uint32_t>(_mm256_movemask_ps(_mm256_cmp_ps(tNear, tFar, _CMP_LE_OQ)));
}
#endif

/// `distance`: eight floats, aligned to 32 bytes.
GLINT_HD inline uint32_t boxHits(const WideNode& node, const BoxRay& ray, float tMin, float tMax,
                                 float* distance) {
#if GLINT_HAS_AVX2
    return boxHitsSimd(node, ray, tMin, tMax, distance);
#else
    return boxHitsScalar(node, ray, tMin, tMax, distance);
#endif
}

}  // namespace glint
