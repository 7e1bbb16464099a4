// What a hit means for shading, and rays that leave it: position with error bounds, normals,
// texture coordinates.
//
// Every position carries a bound of its rounding error per axis, so that the next ray starts beyond it and no
// fixed epsilon is needed: Pharr, Jakob and Humphreys 2023, Physically Based Rendering, section 6.8. Errors
// through instance transforms are bounded there and back.
//
// Texture coordinates are each shape's own (shapes/); v runs upwards.
#pragma once

#include "engine/kernels/bump.h"
#include "engine/kernels/scene_view.h"

namespace glint {

struct SurfacePoint {
    Vec3 p;  ///< world space
    /// the true point of the surface lies within p +- pError, per axis; transforms back and forth included
    Vec3 pError;
    /// unit geometric normal of the surface's FRONT side: outward for spheres, +z of flat shapes, the side a
    /// triangle is counter-clockwise from in object space (also under mirroring transforms)
    Vec3 ng;
    Vec3 ns;  ///< unit shading normal on ng's side
    Vec2 uv;  ///< set where the mask has textures
    /// derivatives of p by uv; set where the mask has kFeatureTangents or the material needs them. Of a mesh
    /// whose highlights have a direction they are smooth, or the unit vectors of its own tangents
    Vec3 dpdu;
    Vec3 dpdv;
    float uvWidth;     ///< what a pixel covers of u and v; 0 where no texture asks for it
    Vec3 vertexColor;  ///< interpolated; 1 without colours
    uint32_t instance;
    uint32_t primitive;
    uint32_t material;
};

namespace detail {

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
    point->ng = normalizeOr(toWorld(local.ng), Vec3(0.0f));
    if (isZero(point->ng)) { point->ng = normalizeOr(-ray.direction, Vec3(0.0f, 0.0f, 1.0f)); }
    point->ns = point->ng;
    if constexpr (hasFeature<kMask>(kFeatureMeshNormals)) {
        if (isZero(local.ns)) { return; }
        point->ns = normalizeOr(toWorld(local.ns), point->ng);
        if (glm::dot(point->ns, point->ng) < 0.0f) { point->ns = -point->ns; }
    }
}

/// A vector of the surface in world space.
template <FeatureMask kMask>
GLINT_HD inline Vec3 vectorToWorld(const InstanceData& instance, const Vec3& v) {
    return isInWorldSpace<kMask>(instance) ? v : instance.objectToWorld.vector(v);
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

namespace detail {

/// Derivatives by uv where they are asked for, and what follows from them: what perturbs the shading normal
/// comes last, here, for all integrators alike.
template <FeatureMask kMask>
GLINT_HD inline void addTangents(const SceneView& view, const Ray& ray, const Hit& hit, const Vec3& pObject,
                                 float pixelWidth, SurfacePoint* point) {
    const InstanceData& instance = view.geometry.instances[hit.instance];
    const uint16_t flags = materialFlagsOf(view, instance);
    if (!hasFeature<kMask>(kFeatureTangents) &&
        (flags & (kMaterialBump | kMaterialMipmaps | kMaterialFacets)) == 0) {
        return;
    }
    const auto toWorld = [&](const Tangents& t) {
        return Tangents{vectorToWorld<kMask>(instance, t.dpdu), vectorToWorld<kMask>(instance, t.dpdv)};
    };
    const Tangents object = objectTangentsAt<kMask>(view, hit, pObject);
    const Tangents world = toWorld(object);
    point->dpdu = world.dpdu;
    point->dpdv = world.dpdv;
    if (hasFeature<kMask>(kFeatureMipmaps) && pixelWidth > 0.0f) {
        const float cosine = absDot(point->ng, ray.direction);
        const float area = glm::length(glm::cross(world.dpdu, world.dpdv)) * cosine;
        point->uvWidth = area > 0.0f ? minf(pixelWidth / std::sqrt(area), 1e6f) : 0.0f;
    }
    if (hasFeature<kMask>(kFeatureBumps) && (flags & kMaterialBump) != 0) {
        point->ns =
            perturbedNormal<kMask>(view, view.materials[instance.material], point->uv, point->uvWidth, world,
                                   toWorld(ownTangentsAt<kMask>(view, hit)), point->ng, point->ns);
    }
    if (hasFeature<kMask>(kFeatureFacets) && (flags & kMaterialFacets) != 0) {
        const Tangents facets = toWorld(facetTangentsAt<kMask>(view, hit, object));
        point->dpdu = facets.dpdu;
        point->dpdv = facets.dpdv;
    }
}

}  // namespace detail

/// The surface at a hit of `ray`, which must be the ray that intersect() was asked about. pixelWidth: world
/// units that a pixel is wide there (ray_cone.h), for mip maps; 0 to do without.
template <FeatureMask kMask>
GLINT_HD SurfacePoint surfaceAt(const SceneView& view, const Ray& ray, const Hit& hit,
                                float pixelWidth = 0.0f) {
    const InstanceData& instance = view.geometry.instances[hit.instance];
    SurfacePoint point;
    point.vertexColor = Vec3(1.0f);
    point.uvWidth = 0.0f;
    point.instance = hit.instance;
    point.primitive = hit.primitive;
    point.material = instance.material;

    const ObjectPoint local = objectPointAt<kMask>(view, ray, hit, &point.vertexColor);
    detail::transformToWorld<kMask>(instance, local, &point);
    detail::normalsToWorld<kMask>(instance, local, ray, &point);
    point.uv = local.uv;
    if constexpr (hasFeature<kMask>(kFeatureTangents | kFeatureBumps | kFeatureMipmaps | kFeatureFacets)) {
        detail::addTangents<kMask>(view, ray, hit, local.p, pixelWidth, &point);
    }
    return point;
}

/// Sets a ray that leaves the surface towards `direction`, on whichever side that is.
GLINT_HD inline void leaveSurface(const SurfacePoint& from, const Vec3& direction, Ray* ray) {
    ray->origin = detail::offsetPoint(from.p, from.pError, from.ng, direction);
    ray->direction = direction;
    ray->tMin = 0.0f;
    ray->tMax = kInfinity;
}

/// The same, as a ray of its own.
GLINT_HD inline Ray spawnRay(const SurfacePoint& from, const Vec3& direction) {
    Ray ray;
    leaveSurface(from, direction, &ray);
    return ray;
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
