// Closed meshes let no ray out, through faces, edges and vertices, at any size.
#include <gtest/gtest.h>

#include "engine/kernels/intersect.h"
#include "tests/support/geometry_scene.h"

namespace glint {
namespace {

using namespace testing_support;

TEST(Watertight, AMillionRaysInsideClosedMeshesFindNoWayOut) {
    Random random(11);
    for (const char* name : {"blob", "cube", "sphere"}) {
        for (uint32_t triangles : {300u, 100'000u}) {
            const GeometryScene scene =
                makeScene({makeObject(ShapeKind::Mesh, {}, 0)}, {generated(name, triangles)});
            for (int i = 0; i < 170'000; ++i) {
                const Ray ray{random.box(0.3f), random.direction()};
                ASSERT_TRUE(occluded<kAllFeatures>(scene.view, ray))
                    << name << " " << triangles << " ray " << i;
            }
        }
    }
}

TEST(Watertight, RaysAtVerticesAndEdgesHit) {
    Random random(12);
    for (const char* name : {"blob", "cube", "sphere"}) {
        const auto data = generated(name, 5000);
        for (const Affine& transform : {Affine{}, random.transform(3.0f)}) {
            const GeometryScene scene = makeScene({makeObject(ShapeKind::Mesh, transform, 0)}, {data});
            for (int i = 0; i < 100'000; ++i) {
                const uint32_t triangle = random.below(data->triangleCount());
                const Vec3& a = data->positions[data->indices[3 * triangle]];
                const Vec3& b = data->positions[data->indices[3 * triangle + 1]];
                const float s = i % 4 == 0 ? 0.0f : (i % 4 == 1 ? 0.5f : random.uniform());
                const Vec3 target = transform.point(a + s * (b - a));
                const Vec3 origin = transform.point(i % 3 == 0 ? Vec3(0.0f) : random.box(0.2f));
                ASSERT_TRUE(occluded<kAllFeatures>(scene.view, {origin, target - origin}))
                    << name << " ray " << i;
            }
        }
    }
}

TEST(Watertight, AxisParallelRaysInTheEdgesOfACubeGridHit) {
    const GeometryScene scene = makeScene({makeObject(ShapeKind::Mesh, {}, 0)}, {generated("cube", 12 * 64)});
    for (int axis = 0; axis < 3; ++axis) {
        for (int i = -8; i < 8; ++i) {
            for (int j = -8; j < 8; ++j) {
                Vec3 origin(0.0f);
                Vec3 direction(0.0f);
                origin[(axis + 1) % 3] = 0.125f * static_cast<float>(i);
                origin[(axis + 2) % 3] = 0.125f * static_cast<float>(j);
                direction[axis] = (i + j) % 2 ? -1.0f : 1.0f;
                if (i == -8 || j == -8) {
                    continue;  // on the outside itself
                }
                Hit hit{};
                ASSERT_TRUE(intersect<kAllFeatures>(scene.view, {origin, direction}, &hit));
                EXPECT_EQ(hit.t, 1.0f);
            }
        }
    }
}

TEST(Watertight, TinyHugeAndFarAwayMeshesStayClosed) {
    for (float size : {1e-6f, 1e-3f, 1e6f, 1e12f}) {
        for (float away : {0.0f, 1e3f}) {
            auto data = std::make_shared<MeshData>(*generated("blob", 2000));
            const Vec3 offset = Vec3(1.0f, -0.5f, 0.25f) * (away * size);
            for (Vec3& p : data->positions) {
                p = p * size + offset;
            }
            const GeometryScene scene = makeScene({makeObject(ShapeKind::Mesh, {}, 0)}, {data});
            Random random(14);
            for (int i = 0; i < 20'000; ++i) {
                const Ray ray{offset + random.box(0.3f) * size, random.direction()};
                ASSERT_TRUE(occluded<kAllFeatures>(scene.view, ray)) << size << " " << away << " ray " << i;
            }
        }
    }
}

}  // namespace
}  // namespace glint
