// The shapes that a scene can name: their words in scene files, the keys that place them, and the transforms
// that those keys stand for. A shape is one entry of the table.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "engine/base/kinds.h"
#include "engine/math/transform.h"
#include "engine/scene/mesh_data.h"

namespace glint {

enum class PlacementForm : uint8_t {
    Point,
    Direction,  ///< of any length but zero
    Length,     ///< above 0; the x of its value
};

/// One of the keys that place a shape.
struct PlacementKey {
    std::string_view key;
    PlacementForm form = PlacementForm::Point;
    Vec3 usual{0.0f};            ///< where the key is left out
    std::string_view help = {};  ///< for the schema
};

/// Values of a shape's keys, in their order; those beyond the last key mean nothing.
using Placement = std::array<Vec3, 3>;

struct ShapeForm {
    ShapeKind kind;
    std::string_view name;
    std::string_view help = {};  ///< for the schema
    std::array<PlacementKey, 3> keyList{};
    /// What maps the canonical shape to the place. Nothing: the keys' values do not go together.
    std::optional<Affine> (*transform)(const Placement& values) = nullptr;
    std::string_view refusal = {};  ///< the message for that
    /// The values that transform() makes exactly `placed` of; nothing where only a matrix does.
    std::optional<Placement> (*valuesOf)(const Affine& placed) = nullptr;
    /// The canonical shape for programs that lack it; meshes and profiles have triangles of their own.
    MeshData (*triangles)() = nullptr;

    std::span<const PlacementKey> keys() const;
};

std::span<const ShapeForm> shapeForms();
const ShapeForm& shapeForm(ShapeKind kind);

}  // namespace glint
