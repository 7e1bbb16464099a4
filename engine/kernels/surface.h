// What a hit means for shading, and rays that leave it: position with error bounds, normals,
// texture coordinates.
//
// Called by the path kernels and the light sampling. Every position carries a bound of its rounding error
// per axis, so that the next ray starts beyond it and no fixed epsilon is needed: Pharr, Jakob and
// Humphreys 2023, Physically Based Rendering, section 6.8. Errors through instance transforms are bounded
// there and back.
//
// Texture coordinates (v runs upwards). Sphere: u = 0.5 + atan2(n.x, n.z) / 2 pi, v = 0.5 + asin(n.y) / pi,
// with n the object-space normal: north is +y. Plane: the object-space x and y. Rectangle and disc: (x + 1) /
// 2, (y + 1) / 2. Mesh: its uvs, or else the barycentric weights of the second and third vertex.
#pragma once

#include "engine/kernels/features.h"
#include "engine/kernels/intersect.h"
#include "engine/kernels/scene_view.h"

namespace glint {

struct SurfacePoint {
    Vec3 p;  ///< world space
    /// the true point of the surface lies within p +- pError, per axis; transforms back and forth included
    Vec3 pError;
    /// unit geometric normal of the surface's FRONT side: outward for spheres, +z of flat shapes, the side a
    /// triangle is counter-clockwise from in object space (also under mirroring transforms)
    Vec3 ng;
    Vec3 ns;           ///< unit shading normal on ng's side
    Vec2 uv;           ///< set where the mask has textures
    Vec3 vertexColor;  ///< interpolated; 1 without colours
    uint32_t instance;
    uint32_t primitive;
    uint32_t material;
};

namespace detail {

/// v / |v| without overflow or underflow; `fallback` for zero and non-finite vectors.
GLINT_HD inline Vec3 normalizeOr(const Vec3& v, const Vec3& fallback) {
    const float largest = maxComponent(absVec(v));
    if (!(largest > 0.0f && largest < kInfinity)) { return fallback; }
    return glm::normalize(v / largest);
}

/// |M| * v, entry by entry.
GLINT_HD inline Vec3 absMultiply(const Mat3& m, const Vec3& v) {
    return absVec(m[0]) * v.x + absVec(m[1]) * v.y + absVec(m[2]) * v.z;
}

/// A surface point in object space, before the instance's transform.
struct ObjectPoint {
    Vec3 p{0.0f};
    Vec3 error{0.0f};
    Vec3 ng{0.0f};  ///< any length
    Vec3 ns{0.0f};  ///< any length; zero: like ng
    Vec2 uv{0.0f};
};

/// Whether object space is world space; known beforehand for meshes of masks without transforms.
template <FeatureMask kMask>
GLINT_HD inline bool isInWorldSpace(const InstanceData& instance) {
    constexpr bool kMeshesStay = !hasFeature<kMask>(kFeatureTransforms);
    return (kMeshesStay && isMesh<kMask>(instance)) || (instance.flags & kInstanceIdentity) != 0;
}

/// Applies the instance's transform. The error is that of the given point, of this transform, and of the
/// transform that will take the next ray's origin back into object space (PBR, equation 6.28 and after).
template <FeatureMask kMask>
GLINT_HD inline void transformToWorld(const InstanceData& instance, const ObjectPoint& local,
                                      SurfacePoint* point) {
    if (isInWorldSpace<kMask>(instance)) {
        point->p = local.p;
        point->pError = local.error;
        return;
    }
    const Affine& m = instance.objectToWorld;
    const Affine& inverse = instance.worldToObject;
    point->p = m.point(local.p);
    const Vec3 back =
        errorGamma(4) * (absMultiply(inverse.linear, absVec(point->p)) + absVec(inverse.translation));
    point->pError = (1.0f + errorGamma(4)) * absMultiply(m.linear, local.error + back) +
                    errorGamma(4) * (absMultiply(m.linear, absVec(local.p)) + absVec(m.translation));
}

/// The unit normals of both kinds in world space.
template <FeatureMask kMask>
GLINT_HD inline void normalsToWorld(const InstanceData& instance, const ObjectPoint& local, const Ray& ray,
                                    SurfacePoint* point) {
    const bool isThere = isInWorldSpace<kMask>(instance);
    const auto toWorld = [&](const Vec3& n) {
        return isThere ? n : transformNormal(instance.worldToObject.linear, n);
    };
    point->ng = normalizeOr(toWorld(local.ng), normalizeOr(-ray.direction, Vec3(0.0f, 0.0f, 1.0f)));
    point->ns = point->ng;
    if constexpr (hasFeature<kMask>(kFeatureMeshNormals)) {
        if (isZero(local.ns)) { return; }
        point->ns = normalizeOr(toWorld(local.ns), point->ng);
        if (glm::dot(point->ns, point->ng) < 0.0f) { point->ns = -point->ns; }
    }
}

/// The next p on the unit sphere, which the ray's own arithmetic missed by its rounding.
template <FeatureMask kMask>
GLINT_HD inline ObjectPoint sphereSurface(const Vec3& pRough) {
    ObjectPoint local;
    local.p = normalizeOr(pRough, Vec3(0.0f, 0.0f, 1.0f));
    local.error = errorGamma(6) * absVec(local.p) + Vec3(errorGamma(2));
    local.ng = local.p;
    if constexpr (hasFeature<kMask>(kFeatureTextures)) {
        local.uv = Vec2(0.5f + std::atan2(local.p.x, local.p.z) / kTwoPi,
                        0.5f + std::asin(clampf(local.p.y, -1.0f, 1.0f)) / kPi);
    }
    return local;
}

/// A point of z = 0: exactly on the surface whatever its x and y are.
GLINT_HD inline ObjectPoint flatSurface(const Vec3& pRough, ShapeKind shape) {
    ObjectPoint local;
    local.p = Vec3(pRough.x, pRough.y, 0.0f);
    local.ng = Vec3(0.0f, 0.0f, 1.0f);
    local.uv = shape == ShapeKind::Plane ? Vec2(local.p) : 0.5f * Vec2(local.p) + Vec2(0.5f);
    return local;
}

template <class T>
GLINT_HD inline T interpolate(const T* values, const uint32_t* corner, const Vec3& weights) {
    return values[corner[0]] * weights.x + values[corner[1]] * weights.y + values[corner[2]] * weights.z;
}

/// e1 x e2, each product difference compensated: thin triangles keep their direction.
GLINT_HD inline Vec3 triangleNormal(const Vec3& p0, const Vec3& p1, const Vec3& p2) {
    const Vec3 e1 = p1 - p0;
    const Vec3 e2 = p2 - p0;
    const float scale = maxComponent(glm::max(absVec(e1), absVec(e2)));
    if (!(scale > 0.0f)) { return Vec3(0.0f); }
    const Vec3 a = e1 / scale;
    const Vec3 b = e2 / scale;
    return {differenceOfProducts(a.y, b.z, a.z, b.y), differenceOfProducts(a.z, b.x, a.x, b.z),
            differenceOfProducts(a.x, b.y, a.y, b.x)};
}

/// Weighted corners of a triangle are off by some units in the last place of the corners. Where the triangle
/// is much larger than the way to it, the point is better found along the ray.
GLINT_HD inline void refineOnLargeTriangle(const Vec3& p0, const Vec3& p1, const Vec3& p2, const Ray& ray,
                                           ObjectPoint* local) {
    const float t = planeDistance(p0, p1, p2, ray.origin, ray.direction);
    const Vec3 way = ray.direction * t;
    const Vec3 error = errorGamma(3) * (absVec(ray.origin) + absVec(way));
    if (!(maxComponent(error) < maxComponent(local->error))) { return; }
    local->p = ray.origin + way;
    local->error = error;
}

template <FeatureMask kMask>
GLINT_HD inline ObjectPoint triangleSurface(const MeshView& mesh, const Hit& hit,
                                            const InstanceData& instance, const Ray& ray,
                                            SurfacePoint* point) {
    const uint32_t* corner = mesh.indices + 3 * static_cast<size_t>(hit.primitive);
    const Vec3 weights(1.0f - hit.barycentric.x - hit.barycentric.y, hit.barycentric.x, hit.barycentric.y);
    const Vec3& p0 = mesh.positions[corner[0]];
    const Vec3& p1 = mesh.positions[corner[1]];
    const Vec3& p2 = mesh.positions[corner[2]];
    ObjectPoint local;
    local.p = weights.x * p0 + weights.y * p1 + weights.z * p2;
    local.error = errorGamma(8) * (absVec(weights.x * p0) + absVec(weights.y * p1) + absVec(weights.z * p2)) +
                  errorGamma(4) * glm::max(absVec(p0), glm::max(absVec(p1), absVec(p2)));
    constexpr float kMuchLarger = 64.0f;
    const float largest = maxComponent(glm::max(absVec(p0), glm::max(absVec(p1), absVec(p2))));
    const Ray objectRay = instance.flags & kInstanceIdentity ? ray : toObjectSpace(instance, ray);
    if (largest > kMuchLarger * (maxComponent(absVec(objectRay.direction)) * hit.t +
                                 maxComponent(absVec(objectRay.origin)))) {
        refineOnLargeTriangle(p0, p1, p2, objectRay, &local);
    }
    local.ng = triangleNormal(p0, p1, p2);
    if (hasFeature<kMask>(kFeatureMeshNormals) && mesh.normals) {
        local.ns = interpolate(mesh.normals, corner, weights);
    }
    if constexpr (hasFeature<kMask>(kFeatureTextures)) {
        local.uv = mesh.uvs ? interpolate(mesh.uvs, corner, weights) : hit.barycentric;
    }
    if (hasFeature<kMask>(kFeatureMeshColors) && mesh.colors) {
        point->vertexColor = interpolate(mesh.colors, corner, weights);
    }
    return local;
}

/// The next float up or down (|x| finite).
GLINT_HD inline float nextFloat(float x, bool up) {
    if (x == 0.0f) { return up ? 0x1p-149f : -0x1p-149f; }
    const uint32_t bits = std::bit_cast<uint32_t>(x);
    return std::bit_cast<float>((x > 0.0f) == up ? bits + 1 : bits - 1);
}

/// p moved along the normal `n`, to the side of `direction`, until it is surely beyond the error box
/// around it.
GLINT_HD inline Vec3 offsetPoint(const Vec3& p, const Vec3& pError, const Vec3& n, const Vec3& direction) {
    const float distance = glm::dot(absVec(n), pError);
    const Vec3 offset = n * (glm::dot(direction, n) < 0.0f ? -distance : distance);
    Vec3 moved = p + offset;
    for (int axis = 0; axis < 3; ++axis) {
        if (offset[axis] != 0.0f) { moved[axis] = nextFloat(moved[axis], offset[axis] > 0.0f); }
    }
    return moved;
}

}  // namespace detail

/// The surface at a hit of `ray`, which must be the ray that intersect() was asked about.
template <FeatureMask kMask>
GLINT_HD SurfacePoint surfaceAt(const SceneView& view, const Ray& ray, const Hit& hit) {
    const InstanceData& instance = view.geometry.instances[hit.instance];
    SurfacePoint point;
    point.vertexColor = Vec3(1.0f);
    point.instance = hit.instance;
    point.primitive = hit.primitive;
    point.material = instance.material;

    detail::ObjectPoint local;
    if (isMesh<kMask>(instance)) {
        local =
            detail::triangleSurface<kMask>(view.geometry.meshes[instance.mesh], hit, instance, ray, &point);
    } else {
        const Vec3 pRough = detail::toObjectSpace(instance, ray).at(hit.t);
        local = instance.shape == ShapeKind::Sphere ? detail::sphereSurface<kMask>(pRough)
                                                    : detail::flatSurface(pRough, instance.shape);
    }
    detail::transformToWorld<kMask>(instance, local, &point);
    detail::normalsToWorld<kMask>(instance, local, ray, &point);
    point.uv = local.uv;
    return point;
}

/// A ray that leaves the surface towards `direction`, on whichever side that is.
GLINT_HD inline Ray spawnRay(const SurfacePoint& from, const Vec3& direction) {
    return {detail::offsetPoint(from.p, from.pError, from.ng, direction), direction, 0.0f, kInfinity};
}

/// A ray from the surface to the point `to`, ending just before it; its direction is `to - origin`, so t = 1
/// is there. toError, toNormal: of the surface `to` lies on; both 0 for a point in space.
GLINT_HD inline Ray spawnShadowRay(const SurfacePoint& from, const Vec3& to, const Vec3& toError,
                                   const Vec3& toNormal) {
    const Vec3 origin = detail::offsetPoint(from.p, from.pError, from.ng, to - from.p);
    Vec3 target = to;
    if (!isZero(toNormal)) {
        // The way's own rounding counts as an error of its end.
        const Vec3 error = toError + errorGamma(4) * absVec(to - origin);
        target = detail::offsetPoint(to, error, toNormal, origin - to);
    }
    return {origin, target - origin, 0.0f, 1.0f - 8.0f * 0x1p-24f};
}

}  // namespace glint
