// What stands for shapes in programs that lack them, against the kernels' shapes.
#include <gtest/gtest.h>

#include "engine/kernels/shapes/shapes.h"
#include "engine/scene/shape_forms.h"

namespace glint {
namespace {

ObjectPoint pointOf(ShapeKind kind, const Vec3& p) {
    return visitShape<ObjectPoint, kAnalyticOnly<kAllFeatures>>(
        kind, [&](auto shape) { return decltype(shape)::template surface<kAllFeatures>(p); });
}

double areaOf(ShapeKind kind) {
    switch (kind) {
        case ShapeKind::Sphere:
            return 4.0 * double{kPi};
        case ShapeKind::Disc:
            return double{kPi};
        case ShapeKind::Rectangle:
            return 4.0;
        case ShapeKind::Plane:
            return 4.0 * double{kEndOfPlaneMesh} * double{kEndOfPlaneMesh};
        case ShapeKind::Mesh:
        case ShapeKind::Revolved:
            break;
    }
    return 0.0;
}

TEST(ShapeMeshes, EveryPlacedShapeHasOneThatLiesOnItAndFacesAsItDoes) {
    int shapes = 0;
    for (const ShapeForm& form : shapeForms()) {
        SCOPED_TRACE(form.name);
        ASSERT_EQ(form.triangles != nullptr, form.transform != nullptr);
        if (form.triangles == nullptr) { continue; }
        ++shapes;
        const MeshData mesh = form.triangles();
        ASSERT_EQ(mesh.uvs.size(), mesh.positions.size());
        const float size = form.kind == ShapeKind::Plane ? kEndOfPlaneMesh : 1.0f;
        for (const Vec3& p : mesh.positions) {
            EXPECT_LE(glm::length(pointOf(form.kind, p).p - p), 1e-6f * size);
        }
        double area = 0.0;
        for (size_t i = 0; i < mesh.indices.size(); i += 3) {
            const Vec3 &a = mesh.positions[mesh.indices[i]], &b = mesh.positions[mesh.indices[i + 1]],
                       &c = mesh.positions[mesh.indices[i + 2]];
            const Vec3 twice = glm::cross(b - a, c - a);
            area += 0.5 * static_cast<double>(glm::length(twice));
            EXPECT_GE(glm::dot(twice, pointOf(form.kind, (a + b + c) / 3.0f).ng), 0.0f) << "triangle " << i;
        }
        const double exact = areaOf(form.kind);
        EXPECT_NEAR(area, exact, 4e-4 * exact);  // 256 steps around: (2 pi / 256)^2 / 6 and a little more
    }
    EXPECT_GE(shapes, 4);
}

TEST(ShapeMeshes, TextureCoordinatesAreTheShapes) {
    for (const ShapeKind kind : {ShapeKind::Rectangle, ShapeKind::Disc, ShapeKind::Plane}) {
        const MeshData mesh = shapeForm(kind).triangles();
        for (size_t i = 0; i < mesh.positions.size(); ++i) {
            const Vec2 uv = pointOf(kind, mesh.positions[i]).uv;
            const float size = kind == ShapeKind::Plane ? kEndOfPlaneMesh : 1.0f;
            EXPECT_LE(glm::length(mesh.uvs[i] - uv), 1e-6f * size) << shapeForm(kind).name << " " << i;
        }
    }
}

}  // namespace
}  // namespace glint
