// Surfaces of revolution against a slow solver in long double: all hits of random rays, and the stiff cases.
// The solver knows nothing of the polynomial: at each parameter of the profile the ray meets the ring's
// cylinder twice, and a hit is where such a meeting has the ring's height. It walks the parameter in small
// steps.
#include "engine/kernels/shapes/revolved.h"

#include <algorithm>
#include <numbers>

#include <gtest/gtest.h>

#include "engine/builders/profile_builder.h"
#include "tests/support/uniform_numbers.h"

namespace glint::test {
namespace {

using Real = long double;

constexpr int kSteps = 800;  // of the slow solver, on each curve

struct ProfileCase {
    const char* name;
    CurveKind curve;
    int degree;
    std::vector<Vec2> points;
};

std::vector<ProfileCase> profiles() {
    return {
        {"cone", CurveKind::Bezier, 1, {{0.0f, 1.0f}, {1.0f, -1.0f}}},
        {"cylinder", CurveKind::Bezier, 1, {{0.7f, -1.0f}, {0.7f, 1.0f}}},
        {"dome", CurveKind::Bezier, 3, {{0.0f, 1.0f}, {0.55f, 1.0f}, {1.0f, 0.55f}, {1.0f, 0.0f}}},
        {"vase",
         CurveKind::Bezier,
         6,
         {{0.3f, -1.0f},
          {1.6f, -0.6f},
          {0.1f, 0.0f},
          {-0.1f, 0.2f},
          {0.4f, 0.5f},
          {0.9f, 0.8f},
          {0.5f, 1.0f}}},
        {"degree 15",
         CurveKind::Bezier,
         0,
         {{0.2f, -1.0f},
          {1.1f, -0.9f},
          {0.2f, -0.8f},
          {1.3f, -0.6f},
          {0.1f, -0.5f},
          {1.2f, -0.3f},
          {0.4f, -0.2f},
          {0.9f, 0.0f},
          {0.2f, 0.1f},
          {1.4f, 0.2f},
          {0.3f, 0.4f},
          {0.8f, 0.5f},
          {0.1f, 0.6f},
          {1.0f, 0.8f},
          {0.6f, 0.9f},
          {0.3f, 1.0f}}},
        {"wine glass",
         CurveKind::Bspline,
         3,
         {{0.0f, -1.0f},
          {0.0f, -1.0f},
          {0.6f, -1.0f},
          {0.6f, -0.95f},
          {0.1f, -0.9f},
          {0.08f, -0.3f},
          {0.5f, 0.0f},
          {0.55f, 0.9f},
          {0.5f, 0.9f},
          {0.45f, 0.05f},
          {0.0f, -0.2f},
          {0.0f, -0.2f},
          {0.0f, -0.2f}}},
        {"ring",
         CurveKind::Bspline,
         3,
         {{0.8f, -0.2f},
          {1.0f, 0.0f},
          {0.8f, 0.2f},
          {0.6f, 0.0f},
          {0.8f, -0.2f},
          {1.0f, 0.0f},
          {0.8f, 0.2f}}},
        {"crosses the axis",
         CurveKind::Bezier,
         3,
         {{0.8f, -1.0f}, {-1.5f, -0.3f}, {1.5f, 0.3f}, {-0.8f, 1.0f}}},
        {"cusp", CurveKind::Bezier, 3, {{0.2f, -0.5f}, {1.2f, 0.5f}, {0.2f, 0.5f}, {1.2f, -0.5f}}},
        {"flat base", CurveKind::Bezier, 1, {{0.0f, -1.0f}, {1.0f, -1.0f}, {1.0f, 0.5f}, {0.0f, 0.5f}}},
    };
}

Object objectOf(const ProfileCase& c, float scale = 1.0f) {
    Object object;
    object.shape = ShapeKind::Revolved;
    object.curve = c.curve;
    object.curveDegree = c.degree;
    for (const Vec2& p : c.points) {
        object.profile.push_back(scale * p);
    }
    return object;
}

Real valueOf(const double* coefficients, int degree, Real s) {
    Real b[kMaxProfileDegree + 1] = {};
    std::copy(coefficients, coefficients + degree + 1, b);
    for (int left = degree; left > 0; --left) {
        for (int i = 0; i < left; ++i) {
            b[i] += s * (b[i + 1] - b[i]);
        }
    }
    return b[0];
}

class SlowSolver {
  public:
    SlowSolver(const ProfileCurve& curve, const Ray& ray) : curve_(curve) {
        for (int axis = 0; axis < 3; ++axis) {
            o_[axis] = static_cast<Real>(ray.origin[axis]);
            d_[axis] = static_cast<Real>(ray.direction[axis]);
        }
        flat2_ = d_[0] * d_[0] + d_[2] * d_[2];
        middle_ = -(o_[0] * d_[0] + o_[2] * d_[2]) / flat2_;
        const Real across = o_[0] * d_[2] - o_[2] * d_[0];
        nearest2_ = across * across / flat2_;
    }

    void findAll(std::vector<Real>* hits) {
        for (const int side : {-1, 1}) {
            for (int i = 0; i < kSteps; ++i) {
                const Real a = static_cast<Real>(i) / kSteps, b = static_cast<Real>(i + 1) / kSteps;
                findBetween(side, a, b, hits);
            }
        }
    }

  private:
    Real roomAt(Real s) const {
        const Real x = valueOf(curve_.x, curve_.degree, s);
        return x * x - nearest2_;
    }
    Real tAt(int side, Real s) const {
        return middle_ + side * std::sqrt(std::max<Real>(0.0L, roomAt(s)) / flat2_);
    }
    Real missAt(int side, Real s) const {
        return valueOf(curve_.y, curve_.degree, s) - o_[1] - tAt(side, s) * d_[1];
    }

    template <class Function>
    static Real bisect(const Function& f, Real a, Real b) {
        const bool negative = f(a) < 0.0L;
        for (int i = 0; i < 80; ++i) {
            const Real c = 0.5L * (a + b);
            ((f(c) < 0.0L) == negative ? a : b) = c;
        }
        return 0.5L * (a + b);
    }

    void findBetween(int side, Real a, Real b, std::vector<Real>* hits) const {
        const bool roomA = roomAt(a) >= 0.0L, roomB = roomAt(b) >= 0.0L;
        if (!roomA && !roomB) { return; }
        if (roomA != roomB) {
            const Real edge = bisect([&](Real s) { return roomAt(s); }, a, b);
            (roomA ? b : a) = edge;
        }
        if ((missAt(side, a) < 0.0L) == (missAt(side, b) < 0.0L)) { return; }
        hits->push_back(tAt(side, bisect([&](Real s) { return missAt(side, s); }, a, b)));
    }

    const ProfileCurve& curve_;
    Real o_[3], d_[3], flat2_, middle_, nearest2_;
};

std::vector<Real> slowHits(const std::vector<ProfileCurve>& curves, const Ray& ray) {
    std::vector<Real> hits;
    for (const ProfileCurve& curve : curves) {
        SlowSolver(curve, ray).findAll(&hits);
    }
    std::erase_if(
        hits, [&](Real t) { return !(t > static_cast<Real>(ray.tMin) && t < static_cast<Real>(ray.tMax)); });
    std::ranges::sort(hits);
    return hits;
}

std::vector<double> fastHits(const std::vector<ProfileCurve>& curves, Ray ray, double gap) {
    std::vector<double> hits;
    Hit hit;
    while (hits.size() < 64 && RevolvedShape::intersect<false, false>(curves.data(), ray, &hit)) {
        hits.push_back(static_cast<double>(hit.t));
        ray.tMin = static_cast<float>(static_cast<double>(hit.t) + gap);
    }
    return hits;
}

/// Hits that are clear of each other, so that a grazing ray is not asked for.
bool isClear(const std::vector<Real>& hits, double gap) {
    for (size_t i = 1; i < hits.size(); ++i) {
        if (hits[i] - hits[i - 1] < 4.0L * static_cast<Real>(gap)) { return false; }
    }
    return true;
}

struct Tally {
    int rays = 0, hits = 0, wrong = 0, skipped = 0;
};

void compare(const std::vector<ProfileCurve>& curves, const Ray& ray, double size, Tally* tally) {
    const double gap = 2e-3 * size / static_cast<double>(glm::length(ray.direction));
    const std::vector<Real> slow = slowHits(curves, ray);
    ++tally->rays;
    if (!isClear(slow, gap)) {
        ++tally->skipped;
        return;
    }
    const std::vector<double> fast = fastHits(curves, ray, gap);
    const double far = static_cast<double>(glm::length(ray.origin)) + size;
    bool same = fast.size() == slow.size();
    for (size_t i = 0; same && i < slow.size(); ++i) {
        const double t = static_cast<double>(slow[i]);
        // t is rounded to a float, and the origin's digits end where they end.
        same = std::fabs(fast[i] - t) <=
               1e-6 * (std::fabs(t) + far / static_cast<double>(glm::length(ray.direction)));
    }
    tally->hits += static_cast<int>(slow.size());
    tally->wrong += static_cast<int>(!same);
    if (!same && tally->wrong < 4) {
        std::string text;
        for (const Real t : slow) {
            text += " " + std::to_string(static_cast<double>(t));
        }
        text += "; found";
        for (const double t : fast) {
            text += " " + std::to_string(t);
        }
        ADD_FAILURE() << "origin " << ray.origin.x << " " << ray.origin.y << " " << ray.origin.z
                      << ", direction " << ray.direction.x << " " << ray.direction.y << " " << ray.direction.z
                      << ": expected" << text;
    }
}

class Revolved : public testing::TestWithParam<ProfileCase> {};

TEST_P(Revolved, AllHitsOfRandomRays) {
    for (const float scale : {1.0f, 1e-4f, 1e5f}) {
        const std::vector<ProfileCurve> curves = buildProfile(objectOf(GetParam(), scale));
        UniformNumbers random(3);
        const auto point = [&](float reach) {
            return reach * scale *
                   Vec3(2.0f * random.next() - 1.0f, 2.0f * random.next() - 1.0f,
                        2.0f * random.next() - 1.0f);
        };
        Tally tally;
        for (int i = 0; i < 300; ++i) {
            const Vec3 from = point(i % 3 == 0 ? 1.0f : 30.0f);
            const Vec3 to = point(1.0f);
            compare(curves, Ray{from, (to - from) * (i % 2 == 0 ? 1.0f : 1e-3f), 0.0f, kInfinity},
                    static_cast<double>(scale), &tally);
        }
        EXPECT_EQ(tally.wrong, 0);
        EXPECT_GT(tally.hits, 50);
        EXPECT_LT(tally.skipped, tally.rays / 5);
    }
}

/// From horizontal to far from it, through both solutions.
TEST_P(Revolved, RaysThatAreNearlyHorizontalOrVertical) {
    const std::vector<ProfileCurve> curves = buildProfile(objectOf(GetParam()));
    UniformNumbers random(5);
    Tally tally;
    for (const float slope : {0.0f, 1e-9f, 1e-7f, 3e-6f, 9e-6f, 1.1e-5f, 1e-4f, 1e-3f, 1e2f, 1e4f, 1e7f}) {
        for (int i = 0; i < 40; ++i) {
            const float turn = kTwoPi * random.next();
            const Vec3 direction(std::cos(turn), random.next() < 0.5f ? slope : -slope, std::sin(turn));
            const Vec3 through = {1.2f * random.next() - 0.6f, 1.8f * random.next() - 0.9f,
                                  1.2f * random.next() - 0.6f};
            compare(curves, Ray{through - 3.0f * glm::normalize(direction), direction, 0.0f, kInfinity}, 1.0,
                    &tally);
        }
    }
    EXPECT_EQ(tally.wrong, 0);
    EXPECT_LT(tally.skipped, tally.rays / 4);
}

INSTANTIATE_TEST_SUITE_P(All, Revolved, testing::ValuesIn(profiles()), [](const auto& each) {
    std::string name = each.param.name;
    std::ranges::replace(name, ' ', '_');
    return name;
});

/// A Bézier curve close to a quarter circle is within 3e-4 of the sphere.
TEST(RevolvedShape, AlongTheAxisThePoleIsMet) {
    const std::vector<ProfileCurve> curves = buildProfile(objectOf(profiles()[2]));
    Hit hit;
    EXPECT_TRUE((RevolvedShape::intersect<false, false>(curves.data(),
                                                        Ray{{0, 5, 0}, {0, -1, 0}, 0.0f, kInfinity}, &hit)));
    EXPECT_FLOAT_EQ(hit.t, 4.0f);
    for (const float x : {1e-30f, 1e-12f, 1e-6f, 1e-3f}) {
        EXPECT_TRUE((RevolvedShape::intersect<false, false>(
            curves.data(), Ray{{x, 5, 0}, {0, -1, 0}, 0.0f, kInfinity}, &hit)));
        EXPECT_NEAR(hit.t, 4.0f, 1e-5f);
    }
}

TEST(RevolvedShape, NoRayPassesBetweenNeighbouringCurves) {
    const std::vector<ProfileCurve> curves = buildProfile(objectOf(profiles()[5]));
    UniformNumbers random(9);
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
            ASSERT_TRUE((RevolvedShape::intersect<true, false>(curves.data(), ray, &hit))) << i << " " << k;
        }
    }
}

/// Positions, normals and tangents against differences of neighbouring points; the next ray does not meet the
/// place again.
TEST(RevolvedShape, SurfacePointsLieOnTheSurfaceAndTheirFrontIsOutside) {
    for (const ProfileCase& c : profiles()) {
        Object object = objectOf(c);
        for (const bool reversed : {false, true}) {
            if (reversed && c.curve == CurveKind::Bezier) { std::ranges::reverse(object.profile); }
            const std::vector<ProfileCurve> curves = buildProfile(object);
            UniformNumbers random(1);
            for (int i = 0; i < 500; ++i) {
                const Vec3 from = 4.0f * glm::normalize(Vec3(random.next() - 0.5f, random.next() - 0.5f,
                                                             random.next() - 0.5f));
                const Vec3 to(random.next() - 0.5f, 1.6f * random.next() - 0.8f, random.next() - 0.5f);
                const Ray ray{from, to - from, 0.0f, kInfinity};
                Hit hit;
                if (!RevolvedShape::intersect<false, false>(curves.data(), ray, &hit)) { continue; }
                const ObjectPoint point =
                    RevolvedShape::surface<kAllFeatures>(curves.data(), hit, ray.at(hit.t));
                EXPECT_LT(glm::length(point.p - ray.at(hit.t)), 2e-5f) << c.name;
                const Tangents t = RevolvedShape::tangents(curves.data(), hit, point.p);
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

}  // namespace
}  // namespace glint::test
