#include "engine/scene/shape_forms.h"

#include <algorithm>
#include <string_view>

#include "engine/base/check.h"
#include "engine/kernels/shapes/shapes.h"
#include "engine/scene/mesh_grid.h"

namespace glint {
namespace {

template <class Shape>
MeshData trianglesOf() {
    const SurfaceGrid grid = Shape::description().grid;
    MeshData mesh =
        bendGrid({grid.columns, grid.rows, grid.wrapsColumns, grid.wrapsRows, grid.poles}, grid.at);
    const bool isOwnUv = grid.wrapsColumns || grid.wrapsRows;
    for (size_t i = 0; i < mesh.positions.size(); ++i) {
        const ObjectPoint point = Shape::template surface<kAllFeatures>(mesh.positions[i]);
        if (!isOwnUv) { mesh.uvs[i] = point.uv; }
        mesh.normals[i] = glm::normalize(point.ng);
    }
    const bool isFlat = std::ranges::count(mesh.normals, mesh.normals[0]) == std::ssize(mesh.normals);
    if (isFlat) { mesh.normals.clear(); }
    return mesh;
}

ShapeForm formOf(ShapeKind kind) {
    return visitShape<ShapeForm, kAllFeatures>(kind, [=](auto shape) {
        using Shape = decltype(shape);
        ShapeForm form{Shape::description(), kind};
        if constexpr ((Shape::kFeature & kAnalyticOnly<kAllFeatures>) != 0) {
            form.triangles = trianglesOf<Shape>;
        }
        return form;
    });
}

}  // namespace

std::span<const PlacementKey> ShapeForm::keys() const {
    const auto end = std::ranges::find(keyList, std::string_view(),
                                       [](const PlacementKey& key) { return std::string_view(key.key); });
    return {keyList.begin(), end};
}

std::span<const ShapeForm> shapeForms() {
    static const auto kForms = [] {
        std::vector<ShapeForm> forms;
        for (const ShapeKind kind : kShapeKinds) {
            forms.push_back(formOf(kind));
        }
        return forms;
    }();
    return kForms;
}

const ShapeForm& shapeForm(ShapeKind kind) {
    for (const ShapeForm& form : shapeForms()) {
        if (form.kind == kind) { return form; }
    }
    GLINT_CHECK(!"the shape is in the list of kinds");
    return shapeForms()[0];
}

}  // namespace glint
