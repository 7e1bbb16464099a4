// All kinds of acceleration structures give the same hits. They are compared to the last bit with testing
// everything, which no structure can get wrong. The exception is stated by intersect(): of primitives that a
// ray meets at distances within rounding of each other, any may be the one.
#include <array>
#include <cmath>
#include <span>

#include <gtest/gtest.h>

#include "engine/kernels/intersect.h"
#include "tests/support/geometry_scene.h"

namespace glint {
namespace {

using namespace testing_support;

constexpr std::array kKinds{AcceleratorKind::None, AcceleratorKind::Aabb, AcceleratorKind::KdTree,
                            AcceleratorKind::Bvh};
/// Of a distance: the triangle test's own error, which decides between two triangles.
constexpr float kTie = 0x1p-16f;

struct Answer {
    Hit hit{kNoHit, kNone, kNone, Vec2(0.0f)};
    bool isOccluded = false;
    TestCounts tests;
};

Answer answerOf(const SceneView& view, const Ray& ray) {
    Answer answer;
    Hit hit{};
    if (intersect<kAllFeatures>(view, ray, &hit, CountTests{&answer.tests})) { answer.hit = hit; }
    answer.isOccluded = occluded<kAllFeatures>(view, ray);
    return answer;
}

bool isSame(const Hit& a, const Hit& b) {
    return a.t == b.t && a.instance == b.instance && a.primitive == b.primitive &&
           a.barycentric == b.barycentric;
}

bool isTie(const Hit& a, const Hit& b) {
    return a.instance != kNone && b.instance != kNone && std::fabs(a.t - b.t) <= kTie * a.t &&
           (a.instance != b.instance || a.primitive != b.primitive);
}

/// A third from anywhere, a third along an axis or within a plane that is parallel to two, and a third from
/// and to round coordinates, where planes of structures lie.
Ray randomRay(int number, float reach, Random* random) {
    Ray ray{random->box(reach), random->direction() * random->uniform(0.1f, 10.0f)};
    if (number % 3 == 1) { ray.direction[random->below(3)] = 0.0f; }
    if (number % 6 == 1) { ray.direction[random->below(3)] = 0.0f; }
    if (number % 3 == 2) {
        ray.origin = glm::round(ray.origin * 4.0f) * 0.25f;
        ray.direction = glm::round(ray.direction * 4.0f) * 0.25f;
    }
    if (isZero(ray.direction)) { ray.direction.x = 1.0f; }
    if (number % 5 == 0) { ray.tMin = random->uniform(0.0f, 0.5f); }
    if (number % 5 == 1) { ray.tMax = random->uniform(0.5f, 3.0f); }
    return ray;
}

struct Tally {
    int hits = 0;
    int ties = 0;
    std::array<uint64_t, kKinds.size()> primitives{};
};

Tally compareKinds(const std::vector<Object>& objects,
                   const std::vector<std::shared_ptr<const MeshData>>& meshes, int rays, float reach) {
    std::vector<GeometryScene> scenes;
    for (const AcceleratorKind kind : kKinds) {
        scenes.push_back(makeScene(objects, meshes, kind));
    }
    Random random(17);
    Tally tally;
    for (int i = 0; i < rays; ++i) {
        const Ray ray = randomRay(i, reach, &random);
        const Answer expected = answerOf(scenes[0].view, ray);
        tally.hits += expected.hit.instance != kNone ? 1 : 0;
        tally.primitives[0] += expected.tests.primitives;
        for (size_t kind = 1; kind < kKinds.size(); ++kind) {
            const Answer answer = answerOf(scenes[kind].view, ray);
            tally.primitives[kind] += answer.tests.primitives;
            EXPECT_EQ(answer.isOccluded, expected.isOccluded) << "kind " << kind << ", ray " << i;
            if (isSame(answer.hit, expected.hit)) { continue; }
            ++tally.ties;
            EXPECT_TRUE(isTie(answer.hit, expected.hit)) << "kind " << kind << ", ray " << i << ": "
                                                         << answer.hit.t << " instead of " << expected.hit.t;
        }
    }
    EXPECT_GT(tally.hits, rays / 50);
    EXPECT_LT(tally.ties, rays / 20);
    return tally;
}

Object revolved(const Affine& place, CurveKind curve) {
    Object object = makeObject(ShapeKind::Revolved, place);
    object.curve = curve;
    object.profile = {{0.0f, 0.0f}, {0.9f, 0.0f}, {0.2f, 0.8f}, {1.1f, 1.3f}, {0.0f, 1.5f}};
    return object;
}

TEST(Accelerators, MeshesAreMetAlike) {
    for (const char* name : {"blob", "cube", "torus-knot", "terrain"}) {
        SCOPED_TRACE(name);
        const Tally tally =
            compareKinds({makeObject(ShapeKind::Mesh, {}, 0)}, {generated(name, 600)}, 60'000, 2.0f);
        EXPECT_LT(tally.primitives[1], tally.primitives[0]) << "a box is worth its test";
        EXPECT_LT(4 * tally.primitives[2], tally.primitives[1]);
        EXPECT_LT(4 * tally.primitives[3], tally.primitives[1]);
    }
}

TEST(Accelerators, PlacedMeshesAreMetAlike) {
    Random random(3);
    std::vector<Object> objects;
    for (int i = 0; i < 12; ++i) {
        objects.push_back(makeObject(ShapeKind::Mesh, random.transform(4.0f), i % 2));
        objects.back().frontOnly = i % 3 == 0;
    }
    compareKinds(objects, {generated("blob", 300), generated("cube", 108)}, 100'000, 6.0f);
}

TEST(Accelerators, SpheresPlanesAndSurfacesOfRevolutionAreMetAlike) {
    Random random(5);
    std::vector<Object> objects = {makeObject(ShapeKind::Plane, translate({0, 0, -5})),
                                   makeObject(ShapeKind::Plane, random.transform(3.0f))};
    const ShapeKind shapes[] = {ShapeKind::Sphere, ShapeKind::Rectangle, ShapeKind::Disc};
    for (int i = 0; i < 45; ++i) {
        objects.push_back(makeObject(shapes[i % 3], random.transform(5.0f)));
    }
    for (int i = 0; i < 10; ++i) {
        objects.push_back(
            revolved(random.transform(5.0f), i % 2 == 0 ? CurveKind::Bezier : CurveKind::Bspline));
    }
    compareKinds(objects, {}, 100'000, 6.0f);
}

TEST(Accelerators, AMixedSceneIsMetAlike) {
    Random random(7);
    std::vector<Object> objects = {makeObject(ShapeKind::Plane, translate({0, 0, -5}))};
    const ShapeKind shapes[] = {ShapeKind::Sphere, ShapeKind::Rectangle, ShapeKind::Mesh};
    for (int i = 0; i < 30; ++i) {
        objects.push_back(makeObject(shapes[i % 3], random.transform(5.0f), i % 2));
        objects.push_back(revolved(random.transform(5.0f), CurveKind::Bezier));
    }
    compareKinds(objects, {generated("torus-knot", 400), generated("cube", 48)}, 100'000, 6.0f);
}

/// Many triangles in one place cannot be told apart by a plane.
TEST(Accelerators, RepeatedAndDegenerateTrianglesAreMetAlike) {
    auto mesh = std::make_shared<MeshData>(*generated("cube", 12));
    for (int i = 0; i < 5; ++i) {
        mesh->indices.insert(mesh->indices.end(), mesh->indices.begin(), mesh->indices.begin() + 36);
    }
    mesh->indices.insert(mesh->indices.end(), {0, 0, 0, 1, 1, 2});
    std::vector<GeometryScene> scenes;
    for (const AcceleratorKind kind : kKinds) {
        scenes.push_back(makeScene({makeObject(ShapeKind::Mesh, {}, 0)}, {mesh}, kind));
    }
    Random random(9);
    for (int i = 0; i < 20'000; ++i) {
        const Ray ray = randomRay(i, 2.0f, &random);
        const Answer expected = answerOf(scenes[0].view, ray);
        for (const GeometryScene& scene : scenes) {
            const Answer answer = answerOf(scene.view, ray);
            ASSERT_EQ(answer.isOccluded, expected.isOccluded);
            ASSERT_EQ(answer.hit.t, expected.hit.t);
        }
    }
}

TEST(Accelerators, KdTreesHaveNoWayOutOfClosedMeshes) {
    Random random(11);
    for (const char* name : {"blob", "cube", "sphere"}) {
        for (const uint32_t triangles : {300u, 100'000u}) {
            const GeometryScene scene = makeScene({makeObject(ShapeKind::Mesh, {}, 0)},
                                                  {generated(name, triangles)}, AcceleratorKind::KdTree);
            for (int i = 0; i < 100'000; ++i) {
                Ray ray{random.box(0.3f), random.direction()};
                if (i % 4 == 0) { ray.direction[i % 3] = 0.0f; }
                ASSERT_TRUE(occluded<kAllFeatures>(scene.view, ray)) << name << ", ray " << i;
            }
        }
    }
}

TEST(Accelerators, KdTreesAreTheSameOnAnyNumberOfThreads) {
    const auto data = generated("blob", 50'000);
    const auto one = buildMesh(data, 1, AcceleratorKind::KdTree);
    const auto two = buildMesh(data, 2, AcceleratorKind::KdTree);
    const auto bytesOf = [](const BuiltMesh& mesh) {
        return std::span(mesh.accelerator.view.data, mesh.accelerator.view.bytes);
    };
    EXPECT_TRUE(std::ranges::equal(bytesOf(*one), bytesOf(*two)));
    EXPECT_EQ(one->clusterPrimitives, two->clusterPrimitives);
}

}  // namespace
}  // namespace glint
