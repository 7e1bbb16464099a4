// The shapes that a scene can name: their words in scene files, the keys that place them, and the transforms
// that those keys stand for, as each shape describes itself (kernels/shapes/).
#pragma once

#include <span>

#include "engine/base/kinds.h"
#include "engine/kernels/shapes/shape_description.h"
#include "engine/scene/mesh_data.h"

namespace glint {

struct ShapeForm : ShapeDescription {
    ShapeKind kind;
    /// The canonical shape for programs that lack it, with its texture coordinates, and with its normals
    /// where they differ; null for meshes and profiles, which have triangles of their own.
    MeshData (*triangles)() = nullptr;

    std::span<const PlacementKey> keys() const;
};

std::span<const ShapeForm> shapeForms();
const ShapeForm& shapeForm(ShapeKind kind);

}  // namespace glint
