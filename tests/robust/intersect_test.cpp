// The two-level traversal against brute force and against what is exactly known: nothing may slip through.
#include "engine/kernels/intersect.h"

#include <span>

#include <gtest/gtest.h>

#include "tests/support/geometry_scene.h"

namespace glint {
namespace {

using namespace testing_support;
using Vec3d = glm::dvec3;
using Mat3d = glm::dmat3;

/// Where one instance is met, in double precision; margin: how far (relative to the shape) the ray is from
/// its rim.
struct ExactHit {
    double t = -1.0;
    double margin = 1.0;
};

ExactHit exactTriangle(const MeshData& mesh, uint32_t triangle, const Vec3d& o, const Vec3d& d) {
    const Vec3d a = Vec3d(mesh.positions[mesh.indices[3 * triangle]]) - o;
    const Vec3d b = Vec3d(mesh.positions[mesh.indices[3 * triangle + 1]]) - o;
    const Vec3d c = Vec3d(mesh.positions[mesh.indices[3 * triangle + 2]]) - o;
    const double u = glm::dot(glm::cross(c, b), d);
    const double v = glm::dot(glm::cross(a, c), d);
    const double w = glm::dot(glm::cross(b, a), d);
    const double det = u + v + w;
    if (det == 0.0) { return {}; }
    const double margin = std::min({u, v, w}) / det;
    const double smallest = det > 0.0 ? std::min({u, v, w}) / det : std::min({u / det, v / det, w / det});
    if (smallest < 0.0) { return {-1.0, std::abs(smallest)}; }
    const Vec3d n = glm::cross(b - a, c - a);
    return {glm::dot(n, a) / glm::dot(n, d), std::abs(margin)};
}

ExactHit exactSphere(const Vec3d& o, const Vec3d& d) {
    const double a = glm::dot(d, d);
    const double b = -glm::dot(o, d);
    const Vec3d nearest = o + d * (b / a);
    const double discriminant = 1.0 - glm::dot(nearest, nearest);
    const double margin = std::abs(discriminant);
    if (discriminant < 0.0) { return {-1.0, margin}; }
    const double root = std::sqrt(discriminant * a);
    const double t0 = (b - root) / a;
    return {t0 > 0.0 ? t0 : (b + root) / a, margin};
}

ExactHit exactFlat(ShapeKind shape, const Vec3d& o, const Vec3d& d) {
    const double t = -o.z / d.z;
    const Vec3d p = o + d * t;
    double inside = 1.0;
    if (shape == ShapeKind::Rectangle) { inside = 1.0 - std::max(std::abs(p.x), std::abs(p.y)); }
    if (shape == ShapeKind::Disc) { inside = 1.0 - std::sqrt(p.x * p.x + p.y * p.y); }
    return {inside < 0.0 ? -1.0 : t, std::abs(inside)};
}

/// Brute force over all instances. `rim`: whether some shape's rim is so near that rounding may decide.
struct Reference {
    double t = std::numeric_limits<double>::infinity();
    bool rim = false;
};

Reference bruteForce(const GeometryScene& scene, const Ray& ray) {
    Reference reference;
    const auto consider = [&](const ExactHit& hit) {
        if (hit.margin < 1e-4) { reference.rim = true; }
        if (hit.t > 0.0 && hit.t < reference.t) { reference.t = hit.t; }
    };
    for (const InstanceData& instance : scene.instances->instances) {
        const Mat3d inverse = glm::inverse(Mat3d(instance.objectToWorld.linear));
        const Vec3d o = inverse * (Vec3d(ray.origin) - Vec3d(instance.objectToWorld.translation));
        const Vec3d d = inverse * Vec3d(ray.direction);
        if (instance.shape == ShapeKind::Mesh) {
            const MeshData& mesh = *scene.meshes[instance.mesh]->data;
            for (uint32_t i = 0; i < mesh.triangleCount(); ++i) {
                consider(exactTriangle(mesh, i, o, d));
            }
        } else if (instance.shape == ShapeKind::Sphere) {
            consider(exactSphere(o, d));
        } else {
            consider(exactFlat(instance.shape, o, d));
        }
    }
    return reference;
}

void compareWithBruteForce(const GeometryScene& scene, int rays, uint32_t seed) {
    Random random(seed);
    int compared = 0;
    int hits = 0;
    for (int i = 0; i < rays; ++i) {
        const Ray ray{random.box(6.0f), random.direction() * random.uniform(0.1f, 10.0f)};
        const Reference reference = bruteForce(scene, ray);
        if (reference.rim) { continue; }
        ++compared;
        Hit hit{};
        const bool found = intersect<kAllFeatures>(scene.view, ray, &hit);
        ASSERT_EQ(found, reference.t < std::numeric_limits<double>::infinity()) << "ray " << i;
        EXPECT_EQ(occluded<kAllFeatures>(scene.view, ray), found) << "ray " << i;
        if (!found) { continue; }
        ++hits;
        EXPECT_NEAR(static_cast<double>(hit.t), reference.t, 2e-4 * reference.t + 1e-5) << "ray " << i;
        Ray shorter = ray;
        shorter.tMax = hit.t * 0.999f;
        EXPECT_FALSE(occluded<kAllFeatures>(scene.view, shorter)) << "ray " << i;
    }
    EXPECT_GT(compared, rays / 2);
    EXPECT_GT(hits, rays / 50);
}

TEST(Intersect, EveryShapeUnderRandomTransformsAgreesWithBruteForce) {
    const ShapeKind shapes[] = {ShapeKind::Sphere, ShapeKind::Rectangle, ShapeKind::Disc, ShapeKind::Mesh,
                                ShapeKind::Plane};
    uint32_t seed = 1;
    for (ShapeKind shape : shapes) {
        SCOPED_TRACE(static_cast<int>(shape));
        Random random(seed);
        std::vector<Object> objects;
        const int count = shape == ShapeKind::Plane ? 3 : 30;
        for (int i = 0; i < count; ++i) {
            objects.push_back(makeObject(shape, random.transform(4.0f), 0));
        }
        const GeometryScene scene = makeScene(objects, {generated("blob", 200)});
        compareWithBruteForce(scene, 2000, ++seed);
    }
}

TEST(Intersect, AMixedSceneAgreesWithBruteForce) {
    Random random(7);
    std::vector<Object> objects = {makeObject(ShapeKind::Plane, translate(Vec3(0, 0, -5)))};
    for (int i = 0; i < 60; ++i) {
        const ShapeKind shapes[] = {ShapeKind::Sphere, ShapeKind::Rectangle, ShapeKind::Disc,
                                    ShapeKind::Mesh};
        objects.push_back(makeObject(shapes[i % 4], random.transform(5.0f), i % 2));
    }
    compareWithBruteForce(makeScene(objects, {generated("torus-knot", 600), generated("cube", 48)}), 2000, 8);
}

TEST(Intersect, AnEmptySceneAndEmptyMeshesAreMissed) {
    const auto empty = std::make_shared<MeshData>();
    const Ray ray{Vec3(0.0f, 0.0f, 5.0f), Vec3(0.0f, 0.0f, -1.0f)};
    Hit hit{};
    EXPECT_FALSE(intersect<kAllFeatures>(makeScene({}).view, ray, &hit));
    const GeometryScene scene =
        makeScene({makeObject(ShapeKind::Mesh, {}, 0), makeObject(ShapeKind::Sphere, {})}, {empty});
    ASSERT_TRUE(intersect<kAllFeatures>(scene.view, ray, &hit));
    EXPECT_EQ(hit.instance, 1u);
    EXPECT_FLOAT_EQ(hit.t, 4.0f);
}

TEST(Intersect, FrontOnlyShapesAreMetFromTheFrontAlone) {
    for (ShapeKind shape :
         {ShapeKind::Plane, ShapeKind::Rectangle, ShapeKind::Disc, ShapeKind::Sphere, ShapeKind::Mesh}) {
        for (float mirror : {1.0f, -1.0f}) {
            Object object = makeObject(shape, scale(Vec3(mirror, 1.0f, 1.0f)), 0);
            object.frontOnly = true;
            const GeometryScene scene = makeScene({object}, {generated("sphere", 2000)});
            const Ray front{Vec3(0.1f, 0.2f, 3.0f), Vec3(0.0f, 0.0f, -1.0f)};
            const Ray back{Vec3(0.1f, 0.2f, -0.5f), Vec3(0.0f, 0.0f, 1.0f)};
            EXPECT_TRUE(occluded<kAllFeatures>(scene.view, front)) << static_cast<int>(shape) << mirror;
            EXPECT_FALSE(occluded<kAllFeatures>(scene.view, back)) << static_cast<int>(shape) << mirror;
        }
    }
}

TEST(Intersect, ScalarAndSimdBodiesGiveTheSameBits) {
#if GLINT_HAS_AVX2
    const auto mesh = buildMesh(generated("blob", 20'000), 1);
    Random random(3);
    for (int i = 0; i < 300; ++i) {
        Ray ray{random.box(1.5f), random.direction()};
        if (i % 4 == 0) { ray.direction[i % 3] = 0.0f; }
        const BoxRay box = makeBoxRay(ray);
        const ShearRay shear = makeShearRay(ray);
        const auto* nodes = mesh->accelerator.view.as<WideNode>();
        const size_t nodeCount = mesh->accelerator.view.bytes / sizeof(WideNode);
        for (const WideNode& node : std::span(nodes, nodeCount)) {
            alignas(32) float simd[kNodeWidth];
            float scalar[kNodeWidth];
            const uint32_t hits = boxHitsSimd(node, box, 0.0f, 2.0f, simd);
            ASSERT_EQ(hits, boxHitsScalar(node, box, 0.0f, 2.0f, scalar));
            for (int k = 0; k < kNodeWidth; ++k) {
                if (hits & (1u << k)) { ASSERT_EQ(simd[k], scalar[k]); }
            }
        }
        for (const TriangleCluster& cluster : mesh->clusters) {
            TriangleHit a{kInfinity, 0, 0, kNone};
            TriangleHit b = a;
            const bool hitA = intersectClusterSimd<false, false>(cluster, shear, 0.0f, &a);
            const bool hitB = intersectClusterScalar<false, false>(cluster, shear, 0.0f, &b);
            ASSERT_EQ(hitA, hitB);
            ASSERT_EQ(a.primitive, b.primitive);
            ASSERT_EQ(a.t, b.t);
            ASSERT_EQ(a.b1, b.b1);
            ASSERT_EQ(a.b2, b.b2);
        }
    }
#else
    GTEST_SKIP() << "compiled without AVX2";
#endif
}

TEST(Intersect, DegenerateTrianglesNeverHitAndNeverDisturb) {
    auto data = std::make_shared<MeshData>(*generated("sphere", 2000));
    const uint32_t good = data->triangleCount();
    for (int i = 0; i < 500; ++i) {
        data->indices.insert(data->indices.end(), {7u, 7u, 7u});
        data->indices.insert(data->indices.end(), {3u, 9u, 3u});
    }
    const GeometryScene scene = makeScene({makeObject(ShapeKind::Mesh, {}, 0)}, {data});
    Random random(13);
    for (int i = 0; i < 20'000; ++i) {
        Hit hit{};
        ASSERT_TRUE(intersect<kAllFeatures>(scene.view, {random.box(0.5f), random.direction()}, &hit));
        EXPECT_LT(hit.primitive, good);
    }
}

TEST(Intersect, ManyIdenticalTrianglesAreFound) {
    auto data = std::make_shared<MeshData>();
    data->positions = {Vec3(-1, -1, 0), Vec3(1, -1, 0), Vec3(0, 1, 0)};
    for (int i = 0; i < 20'000; ++i) {
        data->indices.insert(data->indices.end(), {0u, 1u, 2u});
    }
    const GeometryScene scene = makeScene({makeObject(ShapeKind::Mesh, {}, 0)}, {data});
    Hit hit{};
    ASSERT_TRUE(intersect<kAllFeatures>(scene.view, {Vec3(0, 0, 2), Vec3(0, 0, -1)}, &hit));
    EXPECT_EQ(hit.t, 2.0f);
}

}  // namespace
}  // namespace glint
