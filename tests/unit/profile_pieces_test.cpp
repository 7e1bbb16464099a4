// Pieces of a profile beside the curves that they are parts of: their degree is lower where that changes
// nothing that a ray could tell.
#include <gtest/gtest.h>

#include "engine/builders/bernstein_forms.h"
#include "engine/kernels/shapes/profile_roots.h"
#include "engine/math/bernstein.h"
#include "engine/scene/scene.h"
#include "tests/support/profile_tables.h"
#include "tests/support/uniform_numbers.h"

namespace glint::test {
namespace {

ProfileTable tableOf(int degree, std::vector<Vec2> points) {
    Object object;
    object.shape = ShapeKind::Revolved;
    object.curve = CurveKind::Bezier;
    object.curveDegree = degree;
    object.profile = std::move(points);
    return builtProfile(object);
}

/// The farthest that any piece is from its curve, of the profile's size.
double farthestOff(const ProfileTable& table) {
    constexpr int kPlaces = 200;
    const ProfileData& profile = table.profiles[0];
    double most = 0.0;
    for (const ProfilePiece& piece : table.pieces) {
        const ProfileCurve& curve = table.curves[piece.curve];
        for (int i = 0; i <= kPlaces; ++i) {
            const double share = static_cast<double>(i) / kPlaces, s = piece.begin + share * piece.width;
            const detail::ProfilePoint point = detail::pointOf(piece, share);
            const double x = evaluateBernstein<kMaxProfileDegree>(curve.x, curve.degree, s).value;
            const double y = evaluateBernstein<kMaxProfileDegree>(curve.y, curve.degree, s).value;
            most = std::max(most, std::hypot(point.x.value - x, point.y.value - (y - profile.middle)));
        }
    }
    return most / profile.size();
}

/// Neighbours agree about the place between them, so that no ray passes there.
void expectToJoin(const ProfileTable& table) {
    for (size_t i = 0; i + 1 < table.pieces.size(); ++i) {
        const ProfilePiece &piece = table.pieces[i], &next = table.pieces[i + 1];
        if (piece.curve != next.curve) { continue; }
        EXPECT_EQ(piece.xSquared[2 * piece.degree], next.xSquared[0]) << "piece " << i;
        EXPECT_EQ(piece.yRaised[2 * piece.degree], next.yRaised[0]) << "piece " << i;
    }
}

/// Both coordinates by 1e-11 of the size (kLowerDegreeError), and what evaluating in double loses.
constexpr double kMostOff = 1.5e-11;

TEST(ProfilePieces, LowerTheirDegreeAndStayWithTheCurve) {
    const ProfileTable wave = builtProfile(profileNamed("degree 15").object());
    int lower = 0;
    for (const ProfilePiece& piece : wave.pieces) {
        lower += static_cast<int>(piece.degree < 15);
    }
    EXPECT_GT(lower, static_cast<int>(wave.pieces.size()) / 2);
    EXPECT_LT(farthestOff(wave), kMostOff);
    expectToJoin(wave);
}

/// What is lost is at most the bound, and at least cos(pi/8) = 0.92 of it, since it is sampled.
TEST(BernsteinForms, LowerDegreesWithinTheBoundThatTheyTell) {
    UniformNumbers random(1);
    for (int degree = 2; degree <= kMaxProfileDegree; ++degree) {
        SCOPED_TRACE(degree);
        double f[kMaxProfileDegree + 1], low[kMaxProfileDegree + 1];
        for (int i = 0; i <= degree; ++i) {
            f[i] = low[i] = static_cast<double>(random.next());
        }
        const double bound = lowerBernsteinDegree(low, degree);
        double most = 0.0;
        for (int i = 0; i <= 10'000; ++i) {
            const double s = 1e-4 * i;
            const double off = evaluateBernstein<kMaxProfileDegree>(low, degree - 1, s).value -
                               evaluateBernstein<kMaxProfileDegree>(f, degree, s).value;
            most = std::max(most, std::fabs(off));
        }
        EXPECT_LE(most, bound + 1e-13);
        EXPECT_GE(most, 0.92 * bound);
        EXPECT_EQ(low[0], f[0]);
        EXPECT_EQ(low[degree - 1], f[degree]);
    }
}

TEST(ProfilePieces, OfAnyDegreeStayWithTheCurve) {
    for (int degree = 1; degree <= kMaxProfileDegree; ++degree) {
        std::vector<Vec2> points;
        for (int i = 0; i <= degree; ++i) {
            points.emplace_back(3.0f + 2.0f * std::sin(37.0f * static_cast<float>(i * i)),
                                100.0f + static_cast<float>(i));
        }
        SCOPED_TRACE(degree);
        const ProfileTable table = tableOf(degree, points);
        EXPECT_LT(farthestOff(table), kMostOff);
        expectToJoin(table);
    }
}

/// What is a line, however many points it has, costs a ray what a line does.
TEST(ProfilePieces, OfALineWithManyPointsAreLines) {
    std::vector<Vec2> points;
    for (int i = 0; i <= 15; ++i) {
        points.emplace_back(1.0f + 0.125f * static_cast<float>(i), 0.25f * static_cast<float>(i));
    }
    const ProfileTable line = tableOf(15, points);
    for (const ProfilePiece& piece : line.pieces) {
        EXPECT_EQ(piece.degree, 1);
    }
    EXPECT_LT(farthestOff(line), 1e-14);
}

TEST(ProfilePieces, LieEndToEndAndFillGroups) {
    NamedProfile wavy = profileNamed("degree 15");
    wavy.name = "wavy";
    wavy.curve = CurveKind::Bspline;
    wavy.degree = 3;
    wavy.points.clear();
    for (int i = 0; i < 40; ++i) {
        wavy.points.emplace_back(i % 2 == 0 ? 0.3f : 0.7f, 0.1f * static_cast<float>(i));
    }
    std::vector<NamedProfile> profiles = namedProfiles();
    profiles.push_back(wavy);
    for (const NamedProfile& profile : profiles) {
        const ProfileTable table = builtProfile(profile.object());
        uint32_t curve = 0;
        double end = 0.0;
        for (const ProfilePiece& piece : table.pieces) {
            if (piece.curve != curve) {
                EXPECT_EQ(piece.curve, curve + 1) << profile.name;
                EXPECT_NEAR(end, 1.0, 1e-15) << profile.name;
                curve = piece.curve;
                end = 0.0;
            }
            EXPECT_NEAR(piece.begin, end, 1e-15) << profile.name;
            EXPECT_GT(piece.width, 0.0) << profile.name;
            end = piece.begin + piece.width;
        }
        EXPECT_NEAR(end, 1.0, 1e-15) << profile.name;
        EXPECT_EQ(curve + 1, table.curves.size()) << profile.name;
        EXPECT_EQ(table.groups.size(), (table.pieces.size() + kGroupPieces - 1) / kGroupPieces)
            << profile.name;
    }
    // Each of its 37 curves has a turn, so that 74 parts are the least; flat ones would be more than
    // three groups.
    EXPECT_EQ(builtProfile(wavy.object()).pieces.size(), 3 * kGroupPieces);
}

}  // namespace
}  // namespace glint::test
