// All shapes, and the one place that tells them apart.
//
// A shape is a struct in a header of its own. Analytic ones, which need no data but their transform, have:
//   kFeature, kIsFinite          the mask's bit that compiles them in; whether they have an end
//   kIsSampled                   whether light sampling and photons start at an emissive one
//   intersect<kFrontOnly>(ray)   the nearest t in (tMin, tMax) of a ray in object space, or kNoHit
//   surface<kMask>(pRough)       the surface near a point in object space: position and error, normals, uv
//   tangents(p)                  dp/du and dp/dv there
//   bounds(), worldBounds(m)     boxes in object and, as tight as it gets, in world space
//   makeEmitter(m), boundEmitter(e, node), power(geometry, e, exitance)
//                                what light sampling keeps of an emissive one; where and how strongly it
//                                shines (the node's intensity comes in as radiance); exitance times area
//   sampleArea(geometry, e, u)            a point uniform by area: where a photon starts
//   sampleFrom(geometry, e, from, u)      a point as seen from a place, with its density per solid angle
//   pdfFrom(geometry, e, from, p)         the density with which sampleFrom() finds p. Which way samples a
//                                         shape depends on the shape and on `from` alone, so that it is right
//                                         for points that were found otherwise, too
//   description()                for the host: its word in scene files, what places it, how it is made
//   triangles
// Meshes and surfaces of revolution have the same, but with their data.
#pragma once

#include "engine/kernels/shapes/disc.h"
#include "engine/kernels/shapes/mesh.h"
#include "engine/kernels/shapes/plane.h"
#include "engine/kernels/shapes/rectangle.h"
#include "engine/kernels/shapes/revolved.h"
#include "engine/kernels/shapes/sphere.h"

namespace glint {

/// The shapes without data of their own.
template <FeatureMask kMask>
constexpr FeatureMask kAnalyticOnly = kMask & ~FeatureMask{kFeatureMesh | kFeatureRevolved};

namespace detail {

template <class Result, FeatureMask kMask, class Shape, class Visit>
GLINT_HD constexpr Result visitOne(Visit&& visit) {
    if constexpr ((kMask & Shape::kFeature) != 0) {
        return visit(Shape{});
    } else {
        __builtin_unreachable();
    }
}

}  // namespace detail

/// visit(shape) with the struct of the shape. `kind` must be one that the mask has; nothing is compiled for
/// the others.
template <class Result, FeatureMask kMask, class Visit>
GLINT_HD constexpr Result visitShape(ShapeKind kind, Visit&& visit) {
    switch (kind) {
        case ShapeKind::Sphere:
            return detail::visitOne<Result, kMask, SphereShape>(visit);
        case ShapeKind::Plane:
            return detail::visitOne<Result, kMask, PlaneShape>(visit);
        case ShapeKind::Rectangle:
            return detail::visitOne<Result, kMask, RectangleShape>(visit);
        case ShapeKind::Disc:
            return detail::visitOne<Result, kMask, DiscShape>(visit);
        case ShapeKind::Mesh:
            return detail::visitOne<Result, kMask, MeshShape>(visit);
        case ShapeKind::Revolved:
            return detail::visitOne<Result, kMask, RevolvedShape>(visit);
    }
    __builtin_unreachable();
}

/// The bits of all kinds of shapes but `without`; some share one.
constexpr FeatureMask featuresOfShapes(ShapeKind without) {
    FeatureMask mask = 0;
    for (const ShapeKind kind : kShapeKinds) {
        if (kind == without) { continue; }
        mask |=
            visitShape<FeatureMask, kAllFeatures>(kind, [](auto shape) { return decltype(shape)::kFeature; });
    }
    return mask;
}

}  // namespace glint
