// Surfaces of revolution as surfaces: closed ones let no ray out, and fronts and next rays are right where
// the profile crosses the axis.
#include <gtest/gtest.h>

#include "engine/kernels/shapes/revolved.h"
#include "engine/kernels/surface.h"
#include "tests/support/profile_tables.h"
#include "tests/support/uniform_numbers.h"

namespace glint::test {
namespace {

TEST(RevolvedShape, NearlyHorizontalRaysLeaveNoClosedSurface) {
    NamedProfile round = profileNamed("degree 15");
    round.name = "round";
    round.curve = CurveKind::Bezier;
    round.degree = 3;
    round.points = {{0.0f, -1.0f}, {0.55f, -1.0f}, {1.0f, -0.55f}, {1.0f, 0.0f},
                    {1.0f, 0.55f}, {0.55f, 1.0f},  {0.0f, 1.0f}};
    NamedProfile straight = round;
    straight.name = "straight";
    straight.degree = 1;
    straight.points = {{0.0f, -1.0f}, {0.8f, -0.5f}, {0.4f, 0.0f}, {0.7f, 0.0f}, {0.9f, 0.5f}, {0.0f, 1.0f}};
    for (const NamedProfile& profile : {round, straight}) {
        const ProfileTable table = builtProfile(profile.object());
        const float radius = profile.points[3].x;
        for (const float slope : {0.0f, 1e-9f, -1e-8f, 1e-7f, 5e-7f, -9e-7f, 1.5e-6f, 9e-6f, 1.5e-5f}) {
            for (int i = -40; i <= 40; ++i) {
                // The joint's height is the ray's at up to twice the radius from its middle.
                const float height = 0.05f * static_cast<float>(i) * slope * radius;
                const float angle = 0.7f * static_cast<float>(i);
                for (const float beside : {0.0f, 0.1f}) {
                    const Vec3 along(std::cos(angle), slope, -std::sin(angle));
                    const Vec3 middle = Vec3(0.0f, height, 0.0f) + beside * Vec3(-along.z, 0.0f, along.x);
                    Hit hit;
                    EXPECT_TRUE(
                        (RevolvedShape::intersect<false, false>(table.view(0), {middle, along}, &hit)))
                        << profile.name << " from within, slope " << slope << ", " << i;
                    ASSERT_TRUE((RevolvedShape::intersect<false, false>(
                        table.view(0), {middle - 3.0f * along, along}, &hit)))
                        << profile.name << " from outside, slope " << slope << ", " << i;
                    EXPECT_LT(hit.t, 3.0f) << profile.name << ", slope " << slope << ", " << i;
                }
            }
        }
    }
}

TEST(RevolvedShape, NegativeDistancesAreTheSameSurface) {
    for (const NamedProfile& profile : namedProfiles()) {
        NamedProfile mirrored = profile;
        for (Vec2& point : mirrored.points) {
            point.x = -point.x;
        }
        const ProfileTable one = builtProfile(profile.object()), other = builtProfile(mirrored.object());
        const TestedProfile tested(profile.object(), 1.0);
        UniformNumbers random(11);
        int hits = 0;
        for (int i = 0; i < 2000; ++i) {
            const std::array<float, 6> u{random.next(), random.next(), random.next(),
                                         random.next(), random.next(), random.next()};
            const Ray ray = tested.ray(u, 3.0, 1.0f);
            Hit a, b;
            const bool meets = RevolvedShape::intersect<false, true>(one.view(0), ray, &a);
            ASSERT_EQ(meets, (RevolvedShape::intersect<false, true>(other.view(0), ray, &b))) << profile.name;
            if (!meets) { continue; }
            ++hits;
            EXPECT_EQ(a.t, b.t) << profile.name;
            const ObjectPoint p = RevolvedShape::surface<0>(one.view(0), a, ray.at(a.t));
            const ObjectPoint q = RevolvedShape::surface<0>(other.view(0), b, ray.at(b.t));
            EXPECT_EQ(p.ng, q.ng) << profile.name;
            EXPECT_LT(glm::dot(p.ng, ray.direction), 0.0f) << profile.name;
        }
        EXPECT_GT(hits, 100) << profile.name;
    }
}

TEST(RevolvedShape, WhatCrossesTheAxisHasItsFrontOutsideOnBothSides) {
    NamedProfile crossing = profileNamed("degree 15");
    crossing.curve = CurveKind::Bezier;
    crossing.degree = 1;
    crossing.points = {{-0.5f, 0.0f}, {0.5f, 1.0f}};
    const ProfileTable table = builtProfile(crossing.object());
    for (const float height : {0.2f, 0.8f}) {
        const Ray ray{{2.0f, height, 0.0f}, {-1.0f, 0.0f, 0.0f}};
        Hit hit;
        ASSERT_TRUE((RevolvedShape::intersect<false, true>(table.view(0), ray, &hit))) << height;
        EXPECT_NEAR(hit.t, 2.0f - std::fabs(height - 0.5f), 1e-5f);
        EXPECT_GT(RevolvedShape::surface<0>(table.view(0), hit, ray.at(hit.t)).ng.x, 0.0f);
    }
}

/// Where a profile crosses or touches the axis, points of the surface are small numbers, whose own rounding
/// is far below that of a ray's roots: what a mirror sends on must not meet the place that it has left.
TEST(RevolvedShape, NearTheAxisARayDoesNotMeetThePlaceThatItLeaves) {
    NamedProfile crossing = profileNamed("degree 15");
    crossing.curve = CurveKind::Bezier;
    crossing.degree = 3;
    crossing.points = {{0.0f, -1.0f}, {1.5f, -0.6f}, {-1.5f, 0.6f}, {0.0f, 1.0f}};
    const ProfileTable table = builtProfile(crossing.object());
    UniformNumbers random(11);
    int left = 0;
    for (int i = 0; i < 20'000; ++i) {
        const float size = std::pow(10.0f, -1.0f - 4.0f * random.next());
        const Vec3 aim = size * (2.0f * Vec3(random.next(), random.next(), random.next()) - Vec3(1.0f));
        const Vec3 from = 5.0f * glm::normalize(Vec3(random.next(), random.next() - 0.5f, random.next()));
        const Ray ray{from, glm::normalize(aim - from), 0.0f, kInfinity};
        Hit hit;
        if (!RevolvedShape::intersect<false, false>(table.view(0), ray, &hit)) { continue; }
        const ObjectPoint point = RevolvedShape::surface<0>(table.view(0), hit, ray.at(hit.t));
        const Vec3 normal = glm::normalize(point.ng);
        const Vec3 mirrored = ray.direction - 2.0f * glm::dot(ray.direction, normal) * normal;
        const Ray next{detail::offsetPoint(point.p, point.error, normal, mirrored), mirrored};
        ++left;
        if (!RevolvedShape::intersect<false, false>(table.view(0), next, &hit)) { continue; }
        EXPECT_GT(hit.t, 0.01f * glm::length(Vec2(point.p.x, point.p.z))) << i;
    }
    EXPECT_GT(left, 10'000);
}

}  // namespace
}  // namespace glint::test
