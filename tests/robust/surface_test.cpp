// Surfaces: error bounds that hold, rays that leave without meeting their surface again, normals
// and coordinates.
#include "engine/kernels/surface.h"

#include <gtest/gtest.h>

#include "tests/support/geometry_scene.h"

namespace glint {
namespace {

using namespace testing_support;
using Vec3d = glm::dvec3;
using Mat3d = glm::dmat3;

/// How far p lies from the instance's true surface along the normal, over the bound that pError gives
/// for that.
double errorOverBound(const GeometryScene& scene, const SurfacePoint& s) {
    const InstanceData& instance = scene.instances->instances[s.instance];
    const Mat3d inverse = glm::inverse(Mat3d(instance.objectToWorld.linear));
    const Vec3d local = inverse * (Vec3d(s.p) - Vec3d(instance.objectToWorld.translation));
    Vec3d normal(0.0, 0.0, 1.0);
    double off = local.z;
    if (instance.shape == ShapeKind::Sphere) {
        normal = local / glm::length(local);
        off = glm::length(local) - 1.0;
    } else if (instance.shape == ShapeKind::Mesh) {
        const MeshData& mesh = *scene.meshes[instance.mesh]->data;
        const Vec3d a = mesh.positions[mesh.indices[3 * s.primitive]];
        const Vec3d b = mesh.positions[mesh.indices[3 * s.primitive + 1]];
        const Vec3d c = mesh.positions[mesh.indices[3 * s.primitive + 2]];
        normal = glm::normalize(glm::cross(b - a, c - a));
        off = glm::dot(local - a, normal);
    }
    // The plane normal . x = const moves to a plane with the normal n * M^-1: distances shrink by its length.
    const Vec3d worldNormal = normal * inverse;
    const double length = glm::length(worldNormal);
    const double bound = glm::dot(glm::abs(worldNormal) / length, Vec3d(s.pError));
    return off == 0.0 ? 0.0
                      : std::abs(off) / length / bound;  // a bound may be 0: flat shapes in object space
}

const ShapeKind kShapes[] = {ShapeKind::Sphere, ShapeKind::Plane, ShapeKind::Rectangle, ShapeKind::Disc,
                             ShapeKind::Mesh};

/// One shape, once alone and once with a size and a place that float handles badly.
std::vector<Affine> grades(Random* random) {
    std::vector<Affine> result = {Affine{}};
    for (float size : {1e-6f, 1.0f, 1e6f}) {
        for (float away : {0.0f, 1e3f, 1e5f}) {
            if (away * 1e-6f > 0.02f) {
                continue;  // finer than float resolves over there
            }
            result.push_back(translate(Vec3(1.0f, -0.7f, 0.4f) * (away * size)) * scale(Vec3(size)) *
                             random->transform(0.0f));
        }
    }
    result.push_back(translate(Vec3(1e5f, 0.0f, -1e5f)) * scale(Vec3(1e3f)) * random->transform(0.0f));
    return result;
}

/// A ray from outside (or, for half of them, near by) that aims at the shape.
Ray aimedRay(const Affine& transform, Random* random, ShapeKind shape) {
    const Vec3 target = shape == ShapeKind::Sphere || shape == ShapeKind::Mesh
                            ? random->box(0.4f)
                            : Vec3(random->uniform(-0.6f, 0.6f), random->uniform(-0.6f, 0.6f), 0.0f);
    const Vec3 from = target + random->direction() * random->uniform(1.5f, 20.0f);
    const Vec3 origin = transform.point(from);
    return {origin, transform.point(target) - origin};
}

template <class Check>
void forHits(int raysEach, const Check& check) {
    Random random(21);
    for (ShapeKind shape : kShapes) {
        for (const Affine& transform : grades(&random)) {
            const GeometryScene scene =
                makeScene({makeObject(shape, transform, 0)}, {generated("blob", 3000)});
            int hits = 0;
            for (int i = 0; i < raysEach; ++i) {
                const Ray ray = aimedRay(transform, &random, shape);
                Hit hit{};
                if (!intersect<kAllFeatures>(scene.view, ray, &hit)) { continue; }
                ++hits;
                check(scene, shape, ray, surfaceAt<kAllFeatures>(scene.view, ray, hit), &random);
                if (::testing::Test::HasFailure()) { return; }
            }
            EXPECT_GT(hits, raysEach * 9 / 10) << static_cast<int>(shape);
        }
    }
}

TEST(Surface, ThePositionLiesWithinItsErrorBound) {
    forHits(2000,
            [](const GeometryScene& scene, ShapeKind shape, const Ray&, const SurfacePoint& s, Random*) {
                EXPECT_LE(errorOverBound(scene, s), 1.0) << static_cast<int>(shape);
                EXPECT_TRUE(isFinite(s.pError));
            });
}

TEST(Surface, NormalsAreUnitAndOnTheFrontSideUnderEveryTransform) {
    forHits(500,
            [](const GeometryScene& scene, ShapeKind shape, const Ray& ray, const SurfacePoint& s, Random*) {
                ASSERT_NEAR(glm::length(s.ng), 1.0f, 1e-5f);
                ASSERT_NEAR(glm::length(s.ns), 1.0f, 1e-5f);
                ASSERT_GE(glm::dot(s.ns, s.ng), 0.0f);
                if (shape == ShapeKind::Sphere || shape == ShapeKind::Mesh) {
                    // Met from outside: the front, mirrored or not. The first hit of a closed body is always
                    // a front.
                    ASSERT_LT(glm::dot(s.ng, ray.direction), 1e-3f * glm::length(ray.direction));
                } else {
                    const Affine& m = scene.instances->instances[s.instance].objectToWorld;
                    ASSERT_GT(glm::dot(s.ng, m.vector(Vec3(0.0f, 0.0f, 1.0f))), 0.0f);
                }
            });
}

TEST(Surface, LeavingRaysOfConvexAndFlatShapesNeverMeetThemAgain) {
    forHits(2000, [](const GeometryScene& scene, ShapeKind shape, const Ray&, const SurfacePoint& s,
                     Random* random) {
        if (shape == ShapeKind::Mesh) { return; }
        Vec3 w = random->direction();
        if (glm::dot(w, s.ng) < 0.0f) { w = -w; }
        ASSERT_FALSE(occluded<kAllFeatures>(scene.view, spawnRay(s, w))) << static_cast<int>(shape);
        if (shape != ShapeKind::Sphere) {
            ASSERT_FALSE(occluded<kAllFeatures>(scene.view, spawnRay(s, -w))) << static_cast<int>(shape);
        } else {
            Hit hit{};
            ASSERT_TRUE(intersect<kAllFeatures>(scene.view, spawnRay(s, -w), &hit)) << "tunnelled";
        }
    });
}

TEST(Surface, LeavingRaysNeverMeetTheTriangleTheyLeft) {
    forHits(4000, [](const GeometryScene& scene, ShapeKind shape, const Ray&, const SurfacePoint& s,
                     Random* random) {
        if (shape != ShapeKind::Mesh) { return; }
        const Ray ray = spawnRay(s, random->direction());
        Hit hit{};
        if (!intersect<kAllFeatures>(scene.view, ray, &hit)) {
            ASSERT_GT(glm::dot(ray.direction, s.ng), 0.0f) << "tunnelled out of a closed body";
            return;
        }
        ASSERT_NE(hit.primitive, s.primitive);
    });
}

TEST(Surface, ShadowRaysReachTheOtherSurfaceAndStopBeforeIt) {
    Random random(31);
    for (float size : {1e-6f, 1.0f, 1e6f}) {
        for (float away : {0.0f, 1e3f}) {
            const Affine place = translate(Vec3(away * size)) * scale(Vec3(size));
            const GeometryScene scene =
                makeScene({makeObject(ShapeKind::Rectangle, place),
                           makeObject(ShapeKind::Sphere, place * translate(Vec3(0, 0, 3))),
                           makeObject(ShapeKind::Disc,
                                      place * translate(Vec3(3, 0, 1)) * rotate(Vec3(0, 1, 0), 1.2f))});
            std::vector<SurfacePoint> points;
            while (points.size() < 600) {
                const Affine& target = scene.instances->instances[points.size() % 3].objectToWorld;
                const Vec3 origin = place.point(Vec3(1.5f, 0.2f, 1.2f) + random.box(0.2f));
                const Ray ray{origin, target.point(random.box(0.9f)) - origin};
                Hit hit{};
                if (!intersect<kAllFeatures>(scene.view, ray, &hit)) { continue; }
                SurfacePoint s = surfaceAt<kAllFeatures>(scene.view, ray, hit);
                if (s.instance == points.size() % 3) { points.push_back(s); }
            }
            int open = 0;
            for (size_t i = 0; i + 1 < points.size(); ++i) {
                const SurfacePoint& a = points[i];
                const SurfacePoint& b = points[i + 1];
                if (a.instance == b.instance) { continue; }
                const Vec3 way = glm::normalize(b.p - a.p);
                if (std::abs(glm::dot(way, a.ng)) < 0.05f || std::abs(glm::dot(way, b.ng)) < 0.05f) {
                    continue;
                }
                const bool forth = occluded<kAllFeatures>(scene.view, spawnShadowRay(a, b.p, b.pError, b.ng));
                const bool back = occluded<kAllFeatures>(scene.view, spawnShadowRay(b, a.p, a.pError, a.ng));
                open += forth ? 0 : 1;
                // Only a sphere's own body stands between two of these surfaces.
                const bool blocked = (a.instance == 1 && glm::dot(way, a.ng) < 0.0f) ||
                                     (b.instance == 1 && glm::dot(way, b.ng) > 0.0f);
                if (a.instance == 1 || b.instance == 1) {
                    EXPECT_EQ(forth, blocked) << size << " " << away << " " << i;
                    EXPECT_EQ(back, blocked) << size << " " << away << " " << i;
                } else if (!forth) {
                    EXPECT_FALSE(back);
                }
            }
            EXPECT_GT(open, 100);
        }
    }
}

SurfacePoint surfaceUnder(const GeometryScene& scene, const Ray& ray) {
    Hit hit{};
    EXPECT_TRUE(intersect<kAllFeatures>(scene.view, ray, &hit));
    return surfaceAt<kAllFeatures>(scene.view, ray, hit);
}

TEST(Surface, SphereCoordinatesRunAsDocumented) {
    const GeometryScene scene = makeScene({makeObject(ShapeKind::Sphere, {})});
    const auto uvFrom = [&](const Vec3& from) { return surfaceUnder(scene, {from, -from}).uv; };
    EXPECT_NEAR(uvFrom({0, 0, 2}).x, 0.5f, 1e-6f);
    EXPECT_NEAR(uvFrom({2, 0, 0}).x, 0.75f, 1e-6f);
    EXPECT_NEAR(uvFrom({-2, 0, 0}).x, 0.25f, 1e-6f);
    EXPECT_NEAR(uvFrom({0, 2, 0}).y, 1.0f, 1e-3f);
    EXPECT_NEAR(uvFrom({0, -2, 0}).y, 0.0f, 1e-3f);
    EXPECT_NEAR(uvFrom({0, 0, 2}).y, 0.5f, 1e-6f);
}

TEST(Surface, FlatCoordinatesRunAsDocumented) {
    const Ray ray{Vec3(0.5f, -0.25f, 2.0f), Vec3(0, 0, -1)};
    EXPECT_EQ(surfaceUnder(makeScene({makeObject(ShapeKind::Plane, {})}), ray).uv, Vec2(0.5f, -0.25f));
    EXPECT_EQ(surfaceUnder(makeScene({makeObject(ShapeKind::Rectangle, {})}), ray).uv, Vec2(0.75f, 0.375f));
    EXPECT_EQ(surfaceUnder(makeScene({makeObject(ShapeKind::Disc, {})}), ray).uv, Vec2(0.75f, 0.375f));
}

TEST(Surface, MeshAttributesAreInterpolatedBarycentrically) {
    auto data = std::make_shared<MeshData>();
    data->positions = {Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};
    data->indices = {0, 1, 2};
    const Ray ray{Vec3(1, 2, 3), Vec3(0, 0, -1)};
    const auto surface = [&] {
        return surfaceUnder(makeScene({makeObject(ShapeKind::Mesh, {}, 0)}, {data}), ray);
    };
    EXPECT_EQ(surface().uv, Vec2(0.25f, 0.5f));
    EXPECT_EQ(surface().vertexColor, Vec3(1.0f));
    data = std::make_shared<MeshData>(*data);
    data->uvs = {Vec2(0, 0), Vec2(8, 0), Vec2(0, 16)};
    data->colors = {Vec3(4, 0, 0), Vec3(0, 4, 0), Vec3(0, 0, 4)};
    data->normals = {Vec3(0, 0, -1), Vec3(0, 0, -1), Vec3(0, 0, -2)};
    EXPECT_EQ(surface().uv, Vec2(2.0f, 8.0f));
    EXPECT_EQ(surface().vertexColor, Vec3(1, 1, 2));
    EXPECT_EQ(surface().ns, Vec3(0, 0, 1)) << "flipped to the side of ng";
    data = std::make_shared<MeshData>(*data);
    data->normals = {Vec3(0.0f), Vec3(0.0f), Vec3(0.0f)};
    EXPECT_EQ(surface().ns, Vec3(0, 0, 1)) << "zero normals mean the face's";
}

}  // namespace
}  // namespace glint
