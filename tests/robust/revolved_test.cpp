// Surfaces of revolution against a slow solver in long double (engine/stress/revolved_truth.h): all hits of
// random rays, the stiff cases, caps, and the search that is known to lose hits.
#include "engine/kernels/shapes/revolved.h"

#include <algorithm>
#include <numbers>

#include <gtest/gtest.h>

#include "engine/kernels/surface.h"
#include "engine/stress/revolved_truth.h"
#include "tests/support/profile_tables.h"
#include "tests/support/uniform_numbers.h"

namespace glint::test {
namespace {

class Revolved : public testing::TestWithParam<NamedProfile> {};

TEST_P(Revolved, AllHitsOfRandomRays) {
    for (const float scale : {1.0f, 1e-4f, 1e5f}) {
        const TestedProfile profile(GetParam().object(scale), static_cast<double>(scale));
        UniformNumbers random(3);
        RevolvedTally tally;
        for (int i = 0; i < 2000; ++i) {
            const std::array<float, 6> u{random.next(), random.next(), random.next(),
                                         random.next(), random.next(), random.next()};
            compareHits(profile, profile.ray(u, i % 3 == 0 ? 1.0 : 30.0, i % 2 == 0 ? 1.0f : 1e-3f), &tally);
        }
        EXPECT_EQ(tally.wrong, 0) << tally.firstWrong;
        EXPECT_GT(tally.hits, 500);
        EXPECT_LT(tally.skipped, tally.rays / 5);
    }
}

/// From horizontal to far from it, through both solutions.
TEST_P(Revolved, RaysThatAreNearlyHorizontalOrVertical) {
    const TestedProfile profile(GetParam().object(), 1.0);
    UniformNumbers random(5);
    RevolvedTally tally;
    for (const float slope : {0.0f, 1e-9f, 1e-7f, 3e-6f, 9e-6f, 1.1e-5f, 1e-4f, 1e-3f, 1e2f, 1e4f, 1e7f}) {
        for (int i = 0; i < 40; ++i) {
            const float turn = kTwoPi * random.next();
            const Vec3 direction(std::cos(turn), random.next() < 0.5f ? slope : -slope, std::sin(turn));
            const Vec3 through = {1.2f * random.next() - 0.6f, 1.8f * random.next() - 0.9f,
                                  1.2f * random.next() - 0.6f};
            compareHits(profile, Ray{through - 3.0f * glm::normalize(direction), direction, 0.0f, kInfinity},
                        &tally);
        }
    }
    EXPECT_EQ(tally.wrong, 0) << tally.firstWrong;
    EXPECT_LT(tally.skipped, tally.rays / 4);
}

/// A root that rounding puts beyond the end of its part of the profile, by little of the parameter and much
/// of the ray, which rises by a millionth.
TEST(RevolvedShape, RootsAtTheEndsOfTheirPartsAreExact) {
    const TestedProfile profile(namedProfiles()[5].object(), 1.0);
    RevolvedTally tally;
    compareHits(
        profile,
        Ray{{2.7406201f, -0.9276794f, 1.0850893f}, {-0.88190144f, 1e-6f, -0.4714338f}, 0.0f, kInfinity},
        &tally);
    EXPECT_EQ(tally.hits, 2);
    EXPECT_EQ(tally.wrong, 0) << tally.firstWrong;
}

INSTANTIATE_TEST_SUITE_P(All, Revolved, testing::ValuesIn(namedProfiles()), [](const auto& each) {
    std::string name = each.param.name;
    std::ranges::replace(name, ' ', '_');
    return name;
});

/// A Bézier curve close to a quarter circle is within 3e-4 of the sphere.
TEST(RevolvedShape, AlongTheAxisThePoleIsMet) {
    const ProfileTable table = builtProfile(profileNamed("dome").object());
    Hit hit;
    EXPECT_TRUE((RevolvedShape::intersect<false, false>(table.view(0),
                                                        Ray{{0, 5, 0}, {0, -1, 0}, 0.0f, kInfinity}, &hit)));
    EXPECT_FLOAT_EQ(hit.t, 4.0f);
    for (const float x : {1e-30f, 1e-12f, 1e-6f, 1e-3f}) {
        EXPECT_TRUE((RevolvedShape::intersect<false, false>(
            table.view(0), Ray{{x, 5, 0}, {0, -1, 0}, 0.0f, kInfinity}, &hit)));
        EXPECT_NEAR(hit.t, 4.0f, 1e-5f);
    }
}

TEST(RevolvedShape, NoRayPassesBetweenNeighbouringCurves) {
    const ProfileTable table = builtProfile(profileNamed("wine glass").object());
    UniformNumbers random(9);
    const std::vector<ProfileCurve>& curves = table.curves;
    for (size_t i = 0; i + 1 < curves.size(); ++i) {
        const ProfileCurve& curve = curves[i];
        const double x = curve.x[curve.degree], y = curve.y[curve.degree];
        if (x < 0.05) { continue; }
        for (int k = 0; k < 2000; ++k) {
            const float turn = kTwoPi * random.next();
            const Vec3 joint(static_cast<float>(x) * std::cos(turn), static_cast<float>(y),
                             static_cast<float>(x) * std::sin(turn));
            const Vec3 from = joint + Vec3(2.0f * random.next() - 1.0f, 2.0f * random.next() - 1.0f,
                                           2.0f * random.next() - 1.0f);
            // Steep enough that it goes through and does not graze.
            const double rise = curve.y[curve.degree] - curve.y[curve.degree - 1],
                         run = curve.x[curve.degree] - curve.x[curve.degree - 1];
            const Vec3 normal =
                glm::normalize(Vec3(static_cast<float>(rise) * std::cos(turn), -static_cast<float>(run),
                                    static_cast<float>(rise) * std::sin(turn)));
            const Vec3 direction = joint - from;
            if (std::fabs(glm::dot(glm::normalize(direction), normal)) < 0.3f) { continue; }
            const Ray ray{from, direction, 0.98f, 1.02f};
            Hit hit;
            ASSERT_TRUE((RevolvedShape::intersect<true, false>(table.view(0), ray, &hit))) << i << " " << k;
        }
    }
}

/// Positions, normals and tangents against differences of neighbouring points; the next ray does not meet the
/// place again.
TEST(RevolvedShape, SurfacePointsLieOnTheSurfaceAndTheirFrontIsOutside) {
    for (const NamedProfile& c : namedProfiles()) {
        Object object = c.object();
        for (const bool reversed : {false, true}) {
            if (reversed && c.curve == CurveKind::Bezier) { std::ranges::reverse(object.profile); }
            const ProfileTable table = builtProfile(object);
            UniformNumbers random(1);
            for (int i = 0; i < 500; ++i) {
                const Vec3 from = 4.0f * glm::normalize(Vec3(random.next() - 0.5f, random.next() - 0.5f,
                                                             random.next() - 0.5f));
                const Vec3 to(random.next() - 0.5f, 1.6f * random.next() - 0.8f, random.next() - 0.5f);
                const Ray ray{from, to - from, 0.0f, kInfinity};
                Hit hit;
                if (!RevolvedShape::intersect<false, false>(table.view(0), ray, &hit)) { continue; }
                const ObjectPoint point =
                    RevolvedShape::surface<kAllFeatures>(table.view(0), hit, ray.at(hit.t));
                EXPECT_LT(glm::length(point.p - ray.at(hit.t)), 2e-5f) << c.name;
                const Tangents t = RevolvedShape::tangents(table.view(0), hit, point.p);
                const Vec3 normal = glm::normalize(point.ng);
                EXPECT_NEAR(glm::dot(normal, t.dpdu), 0.0f, 1e-4f * glm::length(t.dpdu));
                EXPECT_NEAR(glm::dot(normal, t.dpdv), 0.0f, 1e-4f * glm::length(t.dpdv));
                // Closed solids without a hollow: what a ray from outside meets first is the front.
                const std::string name = c.name;
                if (name == "ring" || name == "flat base") {
                    EXPECT_LT(glm::dot(normal, ray.direction), 0.0f) << name << reversed;
                }
            }
        }
    }
}

Object tube(bool capped) {
    Object object;
    object.shape = ShapeKind::Revolved;
    object.profile = {{0.5f, -1.0f}, {0.5f, 1.0f}};
    object.capped = capped;
    return object;
}

TEST(RevolvedCaps, CloseATubeAndShineAndLeaveItsTextureAlone) {
    const ProfileTable open = builtProfile(tube(false)), closed = builtProfile(tube(true));
    Hit hit;
    const Ray down{{0.2f, 5.0f, 0.1f}, {0.0f, -1.0f, 0.0f}, 0.0f, kInfinity};
    EXPECT_FALSE((RevolvedShape::intersect<false, false>(open.view(0), down, &hit)));
    for (const float tMin : {0.0f, 4.5f}) {
        Ray ray = down;
        ray.tMin = tMin;
        ASSERT_TRUE((RevolvedShape::intersect<false, false>(closed.view(0), ray, &hit)));
        EXPECT_FLOAT_EQ(hit.t, tMin > 0.0f ? 6.0f : 4.0f);
        const ObjectPoint at = RevolvedShape::surface<kAllFeatures>(closed.view(0), hit, ray.at(hit.t));
        EXPECT_GT(at.ng.y * (tMin > 0.0f ? -1.0f : 1.0f), 0.0f) << "outside is the front";
        EXPECT_EQ((RevolvedShape::intersect<false, true>(closed.view(0), ray, &hit)), tMin == 0.0f);
    }
    const Ray across{{5.0f, 0.3f, 0.1f}, {-1.0f, 0.0f, 0.0f}, 0.0f, kInfinity};
    Vec2 uv[2];
    for (const ProfileTable* table : {&open, &closed}) {
        ASSERT_TRUE((RevolvedShape::intersect<false, false>(table->view(0), across, &hit)));
        uv[table == &closed ? 1 : 0] =
            RevolvedShape::surface<kAllFeatures>(table->view(0), hit, across.at(hit.t)).uv;
    }
    EXPECT_EQ(uv[0], uv[1]);
    EXPECT_NEAR(open.profiles[0].area, 2.0f * kPi, 1e-5f);
    EXPECT_NEAR(closed.profiles[0].area, 2.5f * kPi, 1e-5f);
}

/// What one search finds is there, but much is missing, and whatever lies behind the first hit.
TEST(ClampedSearch, LosesHitsThatTheOtherFinds) {
    Object object = profileNamed("wine glass").object();
    const TestedProfile whole(object, 1.0);
    object.clampsSearch = true;
    const ProfileTable clamped = builtProfile(object);
    UniformNumbers random(4);
    int found = 0, lost = 0, invented = 0;
    for (int i = 0; i < 4000; ++i) {
        const std::array<float, 6> u{random.next(), random.next(), random.next(),
                                     random.next(), random.next(), random.next()};
        const Ray ray = whole.ray(u, 3.0, 1.0f);
        const std::vector<long double> hits = whole.slow.hits(ray);
        Hit hit;
        const bool meets = RevolvedShape::intersect<false, false>(clamped.view(0), ray, &hit);
        lost += static_cast<int>(!hits.empty() && !meets);
        found += static_cast<int>(meets);
        invented +=
            static_cast<int>(meets && std::ranges::none_of(hits, [&](long double t) {
                                 return std::fabs(static_cast<double>(t) - static_cast<double>(hit.t)) < 1e-2;
                             }));
    }
    EXPECT_GT(found, 400);
    EXPECT_GT(lost, found / 20);
    EXPECT_LT(invented, found / 50);
}

TEST(RevolvedShape, CountingStepsChangesNoHit) {
    const ProfileTable table = builtProfile(profileNamed("degree 15").object());
    const TestedProfile profile(profileNamed("degree 15").object(), 1.0);
    UniformNumbers random(6);
    TestCounts counts;
    for (int i = 0; i < 500; ++i) {
        const std::array<float, 6> u{random.next(), random.next(), random.next(),
                                     random.next(), random.next(), random.next()};
        const Ray ray = profile.ray(u, 3.0, 1.0f);
        Hit plain{}, counted{};
        const bool meets = RevolvedShape::intersect<false, false>(table.view(0), ray, &plain);
        ASSERT_EQ(meets, (RevolvedShape::intersect<false, false>(table.view(0), ray, &counted,
                                                                 CountTests{&counts})));
        if (meets) { EXPECT_EQ(plain.t, counted.t); }
    }
    EXPECT_GT(counts.newtonSteps, 100u);
    EXPECT_GT(counts.primitives, 100u);
    EXPECT_LT(counts.primitives, 500u * table.profiles[0].pieceCount / 4);
}

}  // namespace
}  // namespace glint::test
