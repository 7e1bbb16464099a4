// What the host asks of a shape by its kind: the mask's bit, and boxes.
#pragma once

#include "engine/kernels/shapes/shapes.h"

namespace glint {

/// The bit of the feature mask that kernels for the shape need.
inline FeatureMask featureOf(ShapeKind kind) {
    return visitShape<FeatureMask, kAllFeatures>(kind, [](auto shape) { return decltype(shape)::kFeature; });
}

/// Whether the shape has an end. Others are tested one by one, and their points cannot be sampled.
inline bool isFiniteShape(ShapeKind kind) {
    return visitShape<bool, kAllFeatures>(kind, [](auto shape) { return decltype(shape)::kIsFinite; });
}

/// The box of a shape in object space; `mesh`, which is that of its triangles, for meshes. Empty where the
/// shape has no end.
inline Bounds objectBounds(ShapeKind kind, const Bounds& mesh) {
    if (kind == ShapeKind::Mesh) { return mesh; }
    return visitShape<Bounds, kAnalyticOnly<kAllFeatures>>(
        kind, [](auto shape) { return decltype(shape)::bounds(); });
}

/// The box of a placed shape, as tight as the shape allows. Empty where it has no end.
inline Bounds worldBounds(ShapeKind kind, const Affine& objectToWorld, const Bounds& mesh) {
    if (kind == ShapeKind::Mesh) { return MeshShape::worldBounds(objectToWorld, mesh); }
    return visitShape<Bounds, kAnalyticOnly<kAllFeatures>>(
        kind, [&](auto shape) { return decltype(shape)::worldBounds(objectToWorld); });
}

}  // namespace glint
