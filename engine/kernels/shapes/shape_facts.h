// What the host asks of a shape by its kind: the mask's bit, and boxes.
#pragma once

#include "engine/kernels/shapes/shapes.h"

namespace glint {

/// The bit of the feature mask that kernels for the shape need.
inline FeatureMask featureOf(ShapeKind kind) {
    return visitShape<FeatureMask, kAllFeatures>(kind, [](auto shape) { return decltype(shape)::kFeature; });
}

/// Whether the shape has an end. Others are tested one by one.
inline bool isFiniteShape(ShapeKind kind) {
    return visitShape<bool, kAllFeatures>(kind, [](auto shape) { return decltype(shape)::kIsFinite; });
}

/// Whether light sampling and photons start at an emissive one. Others shine where rays find them.
inline bool isSampledAsLight(ShapeKind kind) {
    return visitShape<bool, kAllFeatures>(kind, [](auto shape) { return decltype(shape)::kIsSampled; });
}

/// Whether a shape is given by more than its transform.
inline bool hasShapeData(ShapeKind kind) { return (featureOf(kind) & kAnalyticOnly<kAllFeatures>) == 0; }

/// The box of a shape in object space; `data`, which is that of its triangles or of its profile, where it has
/// such. Empty where the shape has no end.
inline Bounds objectBounds(ShapeKind kind, const Bounds& data) {
    if (hasShapeData(kind)) { return data; }
    return visitShape<Bounds, kAnalyticOnly<kAllFeatures>>(
        kind, [](auto shape) { return decltype(shape)::bounds(); });
}

/// The box of a placed shape, as tight as the shape allows. Empty where it has no end.
inline Bounds worldBounds(ShapeKind kind, const Affine& objectToWorld, const Bounds& data) {
    if (hasShapeData(kind)) { return transformBounds(objectToWorld, data); }
    return visitShape<Bounds, kAnalyticOnly<kAllFeatures>>(
        kind, [&](auto shape) { return decltype(shape)::worldBounds(objectToWorld); });
}

}  // namespace glint
