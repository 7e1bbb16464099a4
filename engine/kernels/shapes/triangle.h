// One ray against a cluster of triangles, watertight: Woop, Benthin and Wald 2013, "Watertight Ray/Triangle
// Intersection", JCGT 2(1). One SIMD and one scalar body that give the same bits.
//
// The ray becomes the z axis by a shear, and three edge functions decide in 2-D. Neighbours evaluate a
// shared edge on the same numbers, so what matters is that each edge function's sign is the true one. The
// paper repeats ties in double; here every edge function is a compensated difference of products (Kahan;
// Jeannerod, Louvet and Muller 2013), whose relative error is below 1: its sign, and whether it is zero, are
// exact as the double-precision repetition's are, without a branch. A ray exactly on an edge or a vertex
// meets all its triangles.
//
// The distance t that the edge functions give is off by some units in the last place of the triangle's extent
// along the ray, not of t. Near the ends of the ray, where a rounding error would make a surface shadow
// itself or hide its own emitter, t comes from the triangle's plane in double instead.
#pragma once

#include "engine/kernels/simd.h"
#include "engine/kernels/triangle_cluster.h"
#include "engine/math/ray.h"

namespace glint {

/// The shear that turns a ray into the +z axis. kz is the direction's largest axis; kx, ky keep the winding.
struct ShearRay {
    Vec3 origin;
    Vec3 direction;
    int kx, ky, kz;
    float sx, sy, sz;
};

GLINT_HD inline ShearRay makeShearRay(const Ray& ray) {
    const Vec3 a = absVec(ray.direction);
    ShearRay shear;
    shear.origin = ray.origin;
    shear.direction = ray.direction;
    shear.kz = a.x > a.y ? (a.x > a.z ? 0 : 2) : (a.y > a.z ? 1 : 2);
    shear.kx = shear.kz == 2 ? 0 : shear.kz + 1;
    shear.ky = shear.kx == 2 ? 0 : shear.kx + 1;
    if (ray.direction[shear.kz] < 0.0f) {
        const int swapped = shear.kx;
        shear.kx = shear.ky;
        shear.ky = swapped;
    }
    shear.sz = 1.0f / ray.direction[shear.kz];
    shear.sx = ray.direction[shear.kx] / ray.direction[shear.kz];
    shear.sy = ray.direction[shear.ky] / ray.direction[shear.kz];
    return shear;
}

/// What the edge functions found out about one triangle. Weights: b1 of vertex 1, b2 of vertex 2.
struct TriangleHit {
    float t;
    float b1, b2;
    uint32_t primitive;  ///< index into MeshView::clusterPrimitives while traversing
};

/// a * b - c * d within 1.5 units in the last place, barring underflow.
GLINT_HD inline float differenceOfProducts(float a, float b, float c, float d) {
    const float cd = c * d;
    const float difference = std::fma(a, b, -cd);
    const float error = std::fma(-c, d, cd);
    return difference + error;
}

/// Edge functions of one triangle: weights times twice the projected area, which is `det`. The sign of det
/// tells the side: positive when the ray meets the front (counter-clockwise) side.
struct EdgeValues {
    float u, v, w, det, tScaled;  ///< t = tScaled / det
};

/// The scalar body, for one triangle of a cluster. Same bits as a lane of the SIMD body.
GLINT_HD inline EdgeValues edgeValues(const TriangleCluster& cluster, int lane, const ShearRay& ray) {
    float x[3], y[3], z[3];
    for (int corner = 0; corner < 3; ++corner) {
        const int vertex = cluster.vertex[corner][lane];
        const float vz = cluster.position[ray.kz][vertex] - ray.origin[ray.kz];
        x[corner] = std::fma(-ray.sx, vz, cluster.position[ray.kx][vertex] - ray.origin[ray.kx]);
        y[corner] = std::fma(-ray.sy, vz, cluster.position[ray.ky][vertex] - ray.origin[ray.ky]);
        z[corner] = ray.sz * vz;
    }
    EdgeValues e;
    e.u = differenceOfProducts(x[2], y[1], y[2], x[1]);
    e.v = differenceOfProducts(x[0], y[2], y[0], x[2]);
    e.w = differenceOfProducts(x[1], y[0], y[1], x[0]);
    e.det = (e.u + e.v) + e.w;
    e.tScaled = std::fma(e.u, z[0], std::fma(e.v, z[1], e.w * z[2]));
    return e;
}

/// Distance along the ray to the plane of the triangle, in double: right to float's last place unless the ray
/// runs within the plane. Products of float differences are all but exact in double, also for needles.
GLINT_HD inline float planeDistance(const Vec3& p0, const Vec3& p1, const Vec3& p2, const Vec3& origin,
                                    const Vec3& direction) {
    double toCorner[3], e1[3], e2[3];
    for (int axis = 0; axis < 3; ++axis) {
        const double corner = static_cast<double>(p0[axis]);
        e1[axis] = static_cast<double>(p1[axis]) - corner;
        e2[axis] = static_cast<double>(p2[axis]) - corner;
        toCorner[axis] = corner - static_cast<double>(origin[axis]);
    }
    double height = 0.0;
    double slope = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        const int j = axis == 2 ? 0 : axis + 1;
        const int k = axis == 0 ? 2 : axis - 1;
        const double normal = e1[j] * e2[k] - e1[k] * e2[j];
        height += normal * toCorner[axis];
        slope += normal * static_cast<double>(direction[axis]);
    }
    return static_cast<float>(height / slope);
}

/// This part of a triangle's extent along the ray is more than the edge functions' error of t, but for rays
/// within some 1e-5 radians of the triangle's plane.
constexpr float kCoarseDistance = 0x1p-6f;

GLINT_HD inline Vec3 clusterCorner(const TriangleCluster& cluster, int corner, int lane) {
    const int vertex = cluster.vertex[corner][lane];
    return {cluster.position[0][vertex], cluster.position[1][vertex], cluster.position[2][vertex]};
}

/// t, or where it is so near to an end of the ray that its error would decide, the better one. Only shadow
/// rays (kAnyHit) have an end that matters.
template <bool kAnyHit>
GLINT_HD inline float refineDistance(const TriangleCluster& cluster, int lane, const ShearRay& ray, float t,
                                     float tMin, float tMax) {
    float extent = 0.0f;
    for (int corner = 0; corner < 3; ++corner) {
        const float z = cluster.position[ray.kz][cluster.vertex[corner][lane]] - ray.origin[ray.kz];
        extent = maxf(std::fabs(z), extent);
    }
    const float coarse = kCoarseDistance * std::fabs(ray.sz) * extent;
    const bool nearStart = t < tMin + coarse;
    const bool nearEnd = kAnyHit && t > tMax - coarse;
    if (!nearStart && !nearEnd) { return t; }
    return planeDistance(clusterCorner(cluster, 0, lane), clusterCorner(cluster, 1, lane),
                         clusterCorner(cluster, 2, lane), ray.origin, ray.direction);
}

/// Whether the edge functions of a triangle mean a hit within (tMin, hit->t); then t and the weights.
template <bool kAnyHit, bool kFrontOnly>
GLINT_HD inline bool acceptTriangle(const TriangleCluster& cluster, int lane, const ShearRay& ray,
                                    const EdgeValues& e, float tMin, TriangleHit* hit) {
    const bool anyNegative = e.u < 0.0f || e.v < 0.0f || e.w < 0.0f;
    const bool anyPositive = e.u > 0.0f || e.v > 0.0f || e.w > 0.0f;
    if ((anyNegative && anyPositive) || e.det == 0.0f) { return false; }
    if (kFrontOnly && !(e.det > 0.0f)) { return false; }
    const float inverseDet = 1.0f / e.det;
    const float t = refineDistance<kAnyHit>(cluster, lane, ray, e.tScaled * inverseDet, tMin, hit->t);
    if (!(t > tMin && t < hit->t)) { return false; }
    hit->t = t;
    hit->b1 = e.v * inverseDet;
    hit->b2 = e.w * inverseDet;
    return true;
}

/// Finds the nearest hit in the cluster with tMin < t < hit->t and stores it; false when there is none. With
/// kAnyHit the first one found will do.
template <bool kAnyHit, bool kFrontOnly>
GLINT_HD inline bool intersectClusterScalar(const TriangleCluster& cluster, const ShearRay& ray, float tMin,
                                            TriangleHit* hit) {
    bool found = false;
    for (uint32_t lane = 0; lane < cluster.count; ++lane) {
        const EdgeValues e = edgeValues(cluster, static_cast<int>(lane), ray);
        if (!acceptTriangle<kAnyHit, kFrontOnly>(cluster, static_cast<int>(lane), ray, e, tMin, hit)) {
            continue;
        }
        hit->primitive = cluster.firstPrimitive + lane;
        found = true;
        if (kAnyHit) { return true; }
    }
    return found;
}

#if GLINT_HAS_AVX2
inline __m256 differenceOfProducts(__m256 a, __m256 b, __m256 c, __m256 d) {
    const __m256 cd = _mm256_mul_ps(c, d);
    const __m256 difference = _mm256_fmsub_ps(a, b, cd);
    const __m256 error = _mm256_fnmadd_ps(c, d, cd);
    return _mm256_add_ps(difference, error);
}

/// The SIMD body: shears the cluster's eight vertices once, then hands them to the eight triangles
/// by permutation.
template <bool kAnyHit, bool kFrontOnly>
inline bool intersectClusterSimd(const TriangleCluster& cluster, const ShearRay& ray, float tMin,
                                 TriangleHit* hit) {
    const __m256 vz =
        _mm256_sub_ps(_mm256_load_ps(cluster.position[ray.kz]), _mm256_set1_ps(ray.origin[ray.kz]));
    const __m256 vx = _mm256_fnmadd_ps(
        _mm256_set1_ps(ray.sx), vz,
        _mm256_sub_ps(_mm256_load_ps(cluster.position[ray.kx]), _mm256_set1_ps(ray.origin[ray.kx])));
    const __m256 vy = _mm256_fnmadd_ps(
        _mm256_set1_ps(ray.sy), vz,
        _mm256_sub_ps(_mm256_load_ps(cluster.position[ray.ky]), _mm256_set1_ps(ray.origin[ray.ky])));

    __m256 x[3], y[3];
    __m256i corner[3];
    for (int k = 0; k < 3; ++k) {
        corner[k] =
            _mm256_cvtepu8_epi32(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(cluster.vertex[k])));
        x[k] = _mm256_permutevar8x32_ps(vx, corner[k]);
        y[k] = _mm256_permutevar8x32_ps(vy, corner[k]);
    }
    const __m256 u = differenceOfProducts(x[2], y[1], y[2], x[1]);
    const __m256 v = differenceOfProducts(x[0], y[2], y[0], x[2]);
    const __m256 w = differenceOfProducts(x[1], y[0], y[1], x[0]);
    const __m256 zero = _mm256_setzero_ps();
    const __m256 lowest = _mm256_min_ps(u, _mm256_min_ps(v, w));
    const __m256 highest = _mm256_max_ps(u, _mm256_max_ps(v, w));
    // All of one sign (zeros allowed), and not all zero.
    const __m256 allPositive =
        _mm256_and_ps(_mm256_cmp_ps(lowest, zero, _CMP_GE_OQ), _mm256_cmp_ps(highest, zero, _CMP_GT_OQ));
    const __m256 allNegative =
        _mm256_and_ps(_mm256_cmp_ps(highest, zero, _CMP_LE_OQ), _mm256_cmp_ps(lowest, zero, _CMP_LT_OQ));
    uint32_t inside = static_cast<uint32_t>(
        _mm256_movemask_ps(kFrontOnly ? allPositive : _mm256_or_ps(allPositive, allNegative)));
    if (inside == 0) { return false; }

    const __m256 z = _mm256_mul_ps(_mm256_set1_ps(ray.sz), vz);
    const __m256 det = _mm256_add_ps(_mm256_add_ps(u, v), w);
    const __m256 tScaled =
        _mm256_fmadd_ps(u, _mm256_permutevar8x32_ps(z, corner[0]),
                        _mm256_fmadd_ps(v, _mm256_permutevar8x32_ps(z, corner[1]),
                                        _mm256_mul_ps(w, _mm256_permutevar8x32_ps(z, corner[2]))));
    alignas(32) float values[4][kClusterTriangles];
    _mm256_store_ps(values[0], v);
    _mm256_store_ps(values[1], w);
    _mm256_store_ps(values[2], det);
    _mm256_store_ps(values[3], tScaled);
    bool found = false;
    for (; inside != 0; inside &= inside - 1) {
        const uint32_t lane = static_cast<uint32_t>(__builtin_ctz(inside));
        const float inverseDet = 1.0f / values[2][lane];
        const float t = refineDistance<kAnyHit>(cluster, static_cast<int>(lane), ray,
                                                values[3][lane] * inverseDet, tMin, hit->t);
        if (!(t > tMin && t < hit->t)) { continue; }
        *hit = {t, values[0][lane] * inverseDet, values[1][lane] * inverseDet, cluster.firstPrimitive + lane};
        found = true;
        if (kAnyHit) { return true; }
    }
    return found;
}
#endif

template <bool kAnyHit, bool kFrontOnly>
GLINT_HD inline bool intersectCluster(const TriangleCluster& cluster, const ShearRay& ray, float tMin,
                                      TriangleHit* hit) {
#if GLINT_HAS_AVX2
    return intersectClusterSimd<kAnyHit, kFrontOnly>(cluster, ray, tMin, hit);
#else
    return intersectClusterScalar<kAnyHit, kFrontOnly>(cluster, ray, tMin, hit);
#endif
}

}  // namespace glint
