// dp/du and dp/dv against finite differences of the surface itself, under every transform.
#include <gtest/gtest.h>

#include "tests/support/geometry_scene.h"

namespace glint {
namespace {

using namespace testing_support;

constexpr FeatureMask kMask = kAllFeatures | kFeatureTangents;

struct TangentCase {
    const char* name;
    ShapeKind shape;
    std::shared_ptr<const MeshData> mesh;
    float tolerance;  // of the difference of two points, relative; what curvature and rounding make
};

std::shared_ptr<const MeshData> withRandomUvs(const std::shared_ptr<const MeshData>& mesh) {
    Random random(7);
    auto data = std::make_shared<MeshData>(*mesh);
    data->uvs.clear();
    for (size_t i = 0; i < data->positions.size(); ++i) {
        data->uvs.push_back(Vec2(random.uniform(-3.0f, 3.0f), random.uniform(-3.0f, 3.0f)));
    }
    return data;
}

bool surfaceUnder(const GeometryScene& scene, const Ray& ray, SurfacePoint* point) {
    Hit hit{};
    if (!intersect<kMask>(scene.view, ray, &hit)) { return false; }
    *point = surfaceAt<kMask>(scene.view, ray, hit);
    return true;
}

/// Whether the derivatives at `s` carry the coordinates' step from a to b over to the positions'.
void expectStep(const SurfacePoint& s, const SurfacePoint& a, const SurfacePoint& b, const TangentCase& c) {
    const Vec2 duv = b.uv - a.uv;
    const Vec3 dp = b.p - a.p;
    EXPECT_LT(glm::length(dp - (s.dpdu * duv.x + s.dpdv * duv.y)), c.tolerance * glm::length(dp)) << c.name;
}

/// Compares at hits of random rays; answers at how many.
int compareSteps(const TangentCase& c, const Affine& transform, Random* random) {
    constexpr float kStep = 4e-3f;
    const GeometryScene scene = makeScene({makeObject(c.shape, transform, 0)}, {c.mesh});
    int compared = 0;
    for (int i = 0; i < 400; ++i) {
        const Vec3 target = random->box(0.4f) * Vec3(1.0f, 1.0f, c.shape == ShapeKind::Sphere ? 1.0f : 0.1f);
        const Vec3 from = target + random->direction() * 3.0f;
        const auto shifted = [&](const Vec3& by) {
            const Vec3 origin = transform.point(from + by);
            return Ray{origin, transform.point(target + by) - origin};
        };
        SurfacePoint s{};
        if (!surfaceUnder(scene, shifted(Vec3(0.0f)), &s)) { continue; }
        const bool nearPole = c.shape == ShapeKind::Sphere && std::abs(s.uv.y - 0.5f) > 0.4f;
        const bool grazing = std::abs(glm::dot(glm::normalize(shifted(Vec3(0.0f)).direction), s.ng)) < 0.2f;
        if (nearPole || grazing) { continue; }
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 step(0.0f);
            step[axis] = kStep;
            SurfacePoint a{}, b{};
            if (!surfaceUnder(scene, shifted(-step), &a) || !surfaceUnder(scene, shifted(step), &b)) {
                continue;
            }
            const bool overSeam = c.shape == ShapeKind::Sphere && std::abs(b.uv.x - a.uv.x) > 0.5f;
            if (a.primitive != s.primitive || b.primitive != s.primitive || overSeam) { continue; }
            if (glm::length(b.p - a.p) < 0.2f * kStep) { continue; }  // along the ray
            expectStep(s, a, b, c);
            ++compared;
        }
        // Derivatives that span nothing would pass for steps of length 0.
        EXPECT_GT(glm::length(glm::cross(s.dpdu, s.dpdv)), 0.0f) << c.name;
        EXPECT_LT(absDot(glm::normalize(glm::cross(s.dpdu, s.dpdv)), s.ng), 1.0f + 1e-4f) << c.name;
        EXPECT_GT(absDot(glm::normalize(glm::cross(s.dpdu, s.dpdv)), s.ng), 1.0f - 1e-4f) << c.name;
    }
    return compared;
}

TEST(Tangents, AreTheDerivativesOfThePositionUnderEveryTransform) {
    const auto cube = generated("cube", 48);
    const TangentCase cases[] = {{"sphere", ShapeKind::Sphere, cube, 1e-2f},
                                 {"plane", ShapeKind::Plane, cube, 1e-3f},
                                 {"rectangle", ShapeKind::Rectangle, cube, 1e-3f},
                                 {"disc", ShapeKind::Disc, cube, 1e-3f},
                                 {"mesh", ShapeKind::Mesh, cube, 2e-3f},
                                 {"mesh with uvs", ShapeKind::Mesh, withRandomUvs(cube), 2e-3f}};
    Random random(5);
    for (const TangentCase& c : cases) {
        for (int i = 0; i < 7; ++i) {  // the first as it is, the others sheared, half of them mirrored
            const Affine transform = i == 0 ? Affine{} : random.transform(1.0f);
            EXPECT_GT(compareSteps(c, transform, &random), 200) << c.name;
            if (HasFailure()) { return; }
        }
    }
}

TEST(Tangents, SpanTheTriangleWhereItsUvsDoNot) {
    auto data = std::make_shared<MeshData>();
    data->positions = {Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};
    data->indices = {0, 1, 2};
    data->uvs = {Vec2(1, 1), Vec2(2, 2), Vec2(3, 3)};
    SurfacePoint s{};
    ASSERT_TRUE(surfaceUnder(makeScene({makeObject(ShapeKind::Mesh, {}, 0)}, {data}),
                             {Vec3(1, 1, 3), Vec3(0, 0, -1)}, &s));
    EXPECT_EQ(s.dpdu, Vec3(4, 0, 0));
    EXPECT_EQ(s.dpdv, Vec3(0, 4, 0));
}

TEST(Tangents, OfASpherePointEastAndNorth) {
    SurfacePoint s{};
    ASSERT_TRUE(
        surfaceUnder(makeScene({makeObject(ShapeKind::Sphere, {})}), {Vec3(0, 0, 3), Vec3(0, 0, -1)}, &s));
    EXPECT_EQ(s.dpdu, Vec3(kTwoPi, 0, 0));
    EXPECT_EQ(s.dpdv, Vec3(0, kPi, 0));
    ASSERT_TRUE(
        surfaceUnder(makeScene({makeObject(ShapeKind::Sphere, {})}), {Vec3(0, 3, 0), Vec3(0, -1, 0)}, &s));
    EXPECT_EQ(s.dpdu, Vec3(0.0f)) << "at the pole";
    EXPECT_EQ(s.dpdv, Vec3(0, 0, -kPi));
}

}  // namespace
}  // namespace glint
