#include "engine/scene/shape_forms.h"

#include <bit>

#include "engine/base/check.h"
#include "engine/math/frame.h"
#include "engine/scene/shape_meshes.h"

namespace glint {
namespace {

/// Unlike ==, tells -0 from 0, which a file keeps apart too.
bool sameBits(const Mat3& a, const Mat3& b) {
    using Bits = std::array<uint32_t, 9>;
    return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b);
}

/// The canonical z axis along `normal`.
Affine facing(const Vec3& normal, float radius, const Vec3& origin) {
    const Frame frame = Frame::fromNormal(glm::normalize(normal));
    return {Mat3(radius * frame.s, radius * frame.t, radius * frame.n), origin};
}

std::optional<Affine> sphere(const Placement& values) { return Affine{Mat3(values[1].x), values[0]}; }

std::optional<Placement> sphereValues(const Affine& placed) {
    const float radius = placed.linear[0].x;
    if (!(radius > 0.0f) || !sameBits(placed.linear, Mat3(radius))) { return std::nullopt; }
    return Placement{placed.translation, Vec3(radius)};
}

std::optional<Affine> plane(const Placement& values) { return facing(values[1], 1.0f, values[0]); }

/// The third axis has the edges' mean length, so that the transform can be undone.
std::optional<Affine> rectangle(const Placement& values) {
    const auto& [center, edgeU, edgeV] = values;
    const Vec3 across = glm::cross(glm::normalize(edgeU), glm::normalize(edgeV));
    if (lengthSquared(across) < 1e-12f) { return std::nullopt; }
    const float depth = 0.5f * std::sqrt(glm::length(edgeU)) * std::sqrt(glm::length(edgeV));
    return Affine{Mat3(0.5f * edgeU, 0.5f * edgeV, depth * glm::normalize(across)), center};
}

std::optional<Affine> disc(const Placement& values) { return facing(values[1], values[2].x, values[0]); }

constexpr Vec3 kUp(0.0f, 0.0f, 1.0f);

const ShapeForm kForms[] = {
    {.kind = ShapeKind::Sphere,
     .name = "sphere",
     .keyList = {{{"center"}, {"radius", PlacementForm::Length, Vec3(1.0f)}}},
     .transform = sphere,
     .valuesOf = sphereValues,
     .triangles = sphereMesh},
    {.kind = ShapeKind::Plane,
     .name = "plane",
     .help = "Infinite.",
     .keyList = {{{"point"}, {"normal", PlacementForm::Direction, kUp}}},
     .transform = plane,
     .triangles = planeMesh},
    {.kind = ShapeKind::Rectangle,
     .name = "rectangle",
     .help = "Its front is the side edgeU x edgeV points to.",
     .keyList = {{{"center"},
                  {"edgeU", PlacementForm::Direction, {2.0f, 0.0f, 0.0f}, "One whole edge (m)."},
                  {"edgeV", PlacementForm::Direction, {0.0f, 2.0f, 0.0f}, "The other whole edge (m)."}}},
     .transform = rectangle,
     .refusal = "\"edgeU\" and \"edgeV\" are parallel; expected two edges of a rectangle",
     .triangles = squareMesh},
    {.kind = ShapeKind::Disc,
     .name = "disc",
     .keyList = {{{"center"},
                  {"normal", PlacementForm::Direction, kUp},
                  {"radius", PlacementForm::Length, Vec3(1.0f)}}},
     .transform = disc,
     .triangles = discMesh},
    {.kind = ShapeKind::Mesh,
     .name = "mesh",
     .help = "Without a material, a whole OBJ or PLY file brings its own."},
    {.kind = ShapeKind::Revolved,
     .name = "revolved",
     .help = "A profile turned about the y axis. Its front is outside, whichever way the profile runs."}};

}  // namespace

std::span<const PlacementKey> ShapeForm::keys() const {
    size_t count = 0;
    while (count < keyList.size() && !keyList[count].key.empty()) {
        ++count;
    }
    return {keyList.data(), count};
}

std::span<const ShapeForm> shapeForms() { return kForms; }

const ShapeForm& shapeForm(ShapeKind kind) {
    for (const ShapeForm& form : kForms) {
        if (form.kind == kind) { return form; }
    }
    GLINT_CHECK(!"the shape is in the table");
    return kForms[0];
}

}  // namespace glint
