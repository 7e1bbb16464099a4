// How scene files and other programs know a shape: its word, the keys that place it with the transform that
// they stand for, and a grid to make triangles of. It is for the host.
#pragma once

#include <array>
#include <cstdint>

#include "engine/math/frame.h"
#include "engine/math/transform.h"

namespace glint {

enum class PlacementForm : uint8_t {
    Point,
    Direction,  ///< of any length but zero
    Length,     ///< above 0; the x of its value
};

/// One of the keys that place a shape.
struct PlacementKey {
    const char* key = "";  ///< empty after the last one
    PlacementForm form = PlacementForm::Point;
    Vec3 usual{0.0f};       ///< where the key is left out
    const char* help = "";  ///< for the schema
};

/// Values of a shape's keys, in their order; those beyond the last key mean nothing.
using Placement = std::array<Vec3, 3>;

/// The canonical surface as the image of the unit square, to make triangles of for programs that lack the
/// shape. Where it wraps, u and v are its texture coordinates.
struct SurfaceGrid {
    uint32_t columns = 1, rows = 1;
    bool wrapsColumns = false, wrapsRows = false;
    bool poles = false;                              ///< the first and the last row shrink to a point each
    glm::dvec3 (*at)(double u, double v) = nullptr;  ///< u and v in [0, 1]; dp/du x dp/dv points to the front
};

struct ShapeDescription {
    const char* name;
    const char* help = "";  ///< for the schema
    std::array<PlacementKey, 3> keyList{};
    /// What maps the canonical shape to the place. False: the keys' values do not go together.
    bool (*transform)(const Placement& values, Affine* placed) = nullptr;
    const char* refusal = "";  ///< the message for that
    /// The values that transform() makes exactly `placed` of; false where only a matrix does.
    bool (*valuesOf)(const Affine& placed, Placement* values) = nullptr;
    SurfaceGrid grid = {};  ///< none for shapes with data, whose triangles come from these
};

/// Half the side of what stands for an endless plane.
constexpr float kEndOfPlaneMesh = 1e4f;

/// The canonical z axis along `normal`.
inline Affine facing(const Vec3& normal, float radius, const Vec3& origin) {
    const Frame frame = Frame::fromNormal(glm::normalize(normal));
    return {Mat3(radius * frame.s, radius * frame.t, radius * frame.n), origin};
}

}  // namespace glint
