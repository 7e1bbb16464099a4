// More and fewer control points: curves that stay as they are, and what is refused.
#include "viewer/model/profile_edits.h"

#include <gtest/gtest.h>

#include "engine/builders/profile_builder.h"
#include "engine/math/bernstein.h"
#include "engine/scene/profile.h"

namespace glint {
namespace {

Object turned(CurveKind curve, int degree, std::vector<Vec2> points) {
    Object object;
    object.shape = ShapeKind::Revolved;
    object.curve = curve;
    object.curveDegree = degree;
    object.profile = std::move(points);
    return object;
}

/// The profile at a share of all its curves.
Vec2 at(const Object& object, double share) {
    const auto curves = profileCurvesOf(object);
    const double place = share * static_cast<double>(curves.size());
    const size_t i = std::min(static_cast<size_t>(place), curves.size() - 1);
    const double s = place - static_cast<double>(i);
    return {evaluateBernstein<kMaxProfileDegree>(curves[i].x, curves[i].degree, s).value,
            evaluateBernstein<kMaxProfileDegree>(curves[i].y, curves[i].degree, s).value};
}

TEST(ProfileEdits, RaisingTheDegreeKeepsTheCurve) {
    const Object before =
        turned(CurveKind::Bezier, 0, {{0.1f, 0.0f}, {0.9f, 0.3f}, {0.2f, 0.7f}, {0.5f, 1.0f}});
    Object object = before;
    for (size_t count = 5; count <= 16; ++count) {
        ASSERT_TRUE(addProfilePoints(&object, 1));
        ASSERT_EQ(object.profile.size(), count);
        for (double share = 0.0; share <= 1.0; share += 0.125) {
            EXPECT_LT(glm::length(at(object, share) - at(before, share)), 2e-6f);
        }
    }
    const Object most = object;
    EXPECT_FALSE(addProfilePoints(&object, 1)) << "beyond degree 15";
    EXPECT_EQ(object.profile, most.profile);
}

TEST(ProfileEdits, HalvingACurveKeepsIt) {
    const Object before = turned(
        CurveKind::Bezier, 3,
        {{0.1f, 0.0f}, {0.9f, 0.3f}, {0.2f, 0.7f}, {0.5f, 1.0f}, {0.8f, 1.3f}, {0.4f, 1.4f}, {0.0f, 1.5f}});
    Object object = before;
    ASSERT_TRUE(addProfilePoints(&object, 6)) << "the last point is on the last curve";
    ASSERT_EQ(object.profile.size(), 10u);
    for (int i = 0; i < 4; ++i) {
        EXPECT_EQ(object.profile[static_cast<size_t>(i)], before.profile[static_cast<size_t>(i)]);
    }
    for (double s = 0.0; s <= 0.999; s += 0.1) {
        const double share = (1.0 + s) / 2.0;         // of two curves
        const double halves = (1.0 + 2.0 * s) / 3.0;  // of three
        EXPECT_LT(glm::length(at(object, halves) - at(before, share)), 1e-6f) << s;
    }
    ASSERT_TRUE(removeProfilePoints(&object, 9));
    EXPECT_EQ(object.profile.size(), 7u);
    EXPECT_TRUE(profileFault(object).empty());
}

TEST(ProfileEdits, NoEditLeavesAProfileThatIsNone) {
    Object object = turned(CurveKind::Bezier, 0, {{0.1f, 0.0f}, {0.9f, 0.3f}});
    EXPECT_FALSE(moveProfilePoint(&object, 0, {std::numeric_limits<float>::quiet_NaN(), 0.0f}));
    EXPECT_FALSE(moveProfilePoint(&object, 2, {0.0f, 0.0f}));
    EXPECT_FALSE(removeProfilePoints(&object, 0));
    EXPECT_TRUE(moveProfilePoint(&object, 1, {0.5f, 0.6f}));
    EXPECT_EQ(object.profile[1], Vec2(0.5f, 0.6f));
    Object spline = turned(CurveKind::Bspline, 3, {{0.1f, 0}, {0.2f, 1}, {0.3f, 2}, {0.4f, 3}});
    EXPECT_FALSE(removeProfilePoints(&spline, 1)) << "a cubic needs four points";
    EXPECT_TRUE(addProfilePoints(&spline, 3));
    EXPECT_TRUE(removeProfilePoints(&spline, 3));
    EXPECT_EQ(spline.profile.size(), 4u);
}

}  // namespace
}  // namespace glint
