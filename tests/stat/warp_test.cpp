// Maps from the unit square, filters and lenses against their densities: chi-square over cells of equal
// probability, or Kolmogorov's bound. Family-wise level 1e-3 (chi_square.h), fixed seeds.
#include "engine/math/warp.h"

#include <algorithm>
#include <functional>

#include <gtest/gtest.h>

#include "engine/builders/camera_builder.h"
#include "engine/kernels/camera_ray.h"
#include "engine/kernels/filter.h"
#include "tests/support/chi_square.h"

namespace glint::test {
namespace {

constexpr int kSamples = 400000;
constexpr int kGrid = 20;
constexpr int kTests = 20;  // at least as many as chi-square tests in this file

/// `cellOf` maps a sample to the unit square so that the samples should fill it evenly.
void expectEven(const std::function<glm::dvec2(Vec2)>& cellOf, uint64_t seed) {
    Random random(seed);
    std::vector<double> observed(kGrid * kGrid, 0.0);
    for (int i = 0; i < kSamples; ++i) {
        const glm::dvec2 c = cellOf(random.uniform2());
        ASSERT_TRUE(c.x > -1e-6 && c.x < 1.0 + 1e-6 && c.y > -1e-6 && c.y < 1.0 + 1e-6) << c.x << " " << c.y;
        const int column = std::clamp(static_cast<int>(c.x * kGrid), 0, kGrid - 1);
        const int row = std::clamp(static_cast<int>(c.y * kGrid), 0, kGrid - 1);
        observed[static_cast<size_t>(row * kGrid + column)] += 1.0;
    }
    const std::vector<double> expected(kGrid * kGrid, static_cast<double>(kSamples) / (kGrid * kGrid));
    EXPECT_GE(chiSquare(observed, expected).pValue, sidakLevel(kFamilyLevel, kTests));
}

double turns(double y, double x) { return 0.5 + std::atan2(y, x) / (2.0 * M_PI); }

TEST(Warp, SineAndCosine) {
    for (int i = 0; i <= 100000; ++i) {
        const float t = static_cast<float>(i) / 100000.0f;
        const SinCos sc = sinCosTurns(t);
        const double angle = 2.0 * M_PI * static_cast<double>(t);
        ASSERT_NEAR(sc.sin, std::sin(angle), 3e-7) << t;
        ASSERT_NEAR(sc.cos, std::cos(angle), 3e-7) << t;
    }
}

TEST(Warp, Disc) {
    expectEven(
        [](Vec2 u) {
            const glm::dvec2 p(sampleDisc(u));
            return glm::dvec2(glm::dot(p, p), turns(p.y, p.x));
        },
        1);
}

TEST(Warp, CosineHemisphere) {
    expectEven(
        [](Vec2 u) {
            const glm::dvec3 w(sampleCosineHemisphere(u));
            return glm::dvec2(w.z * w.z, turns(w.y, w.x));
        },
        2);
    for (const float u : {0.0f, 0.5f, kOneMinusEpsilon}) {
        for (const float v : {0.0f, 0.5f, kOneMinusEpsilon}) {
            EXPECT_GT(sampleCosineHemisphere(Vec2(u, v)).z, 0.0f) << "a density of 0 would be divided by";
        }
    }
}

TEST(Warp, Sphere) {
    expectEven(
        [](Vec2 u) {
            const glm::dvec3 w(sampleSphere(u));
            return glm::dvec2(0.5 + 0.5 * w.z, turns(w.y, w.x));
        },
        3);
}

TEST(Warp, ConesOfAnyWidth) {
    uint64_t seed = 10;
    for (const float oneMinusCos : {2.0f, 1.0f, 1e-2f, 1e-8f}) {
        expectEven(
            [&](Vec2 u) {
                const glm::dvec3 w(sampleCone(u, oneMinusCos));
                const double sine2 = w.x * w.x + w.y * w.y;
                const double fromAxis = oneMinusCos < 0.1f ? sine2 / (1.0 + w.z) : 1.0 - w.z;
                return glm::dvec2(fromAxis / static_cast<double>(oneMinusCos), turns(w.y, w.x));
            },
            seed++);
    }
}

TEST(Warp, Triangle) {
    expectEven(
        [](Vec2 u) {
            const glm::dvec2 b(sampleTriangle(u));
            const double rest = 1.0 - b.x;  // the second weight is even over [0, rest], whose square is even
            return glm::dvec2(rest * rest, rest > 0.0 ? b.y / rest : 0.0);
        },
        20);
}

/// Where a point of a regular polygon lies: its side (in order) and within the side's triangle.
glm::dvec2 polygonCell(glm::dvec2 p, int sides, double rotation) {
    const double turn = turns(p.y, p.x) - 0.5 - rotation / (2.0 * M_PI);
    const double inTurns = turn - std::floor(turn);
    const double side = std::min(std::floor(inTurns * sides), sides - 1.0);
    const double middle = rotation + (side + 0.5) * 2.0 * M_PI / sides;
    const double height = std::cos(M_PI / sides);
    const double along = glm::dot(p, glm::dvec2(std::cos(middle), std::sin(middle)));
    const double across = glm::dot(p, glm::dvec2(-std::sin(middle), std::cos(middle)));
    const double reach = along * std::tan(M_PI / sides);
    const double place = reach > 0.0 ? 0.5 + 0.5 * across / reach : 0.5;
    return {(along / height) * (along / height), (side + place) / sides};
}

TEST(Lens, RoundAndPolygonal) {
    uint64_t seed = 30;
    for (const int blades : {0, 3, 4, 5, 8}) {
        CameraData camera;
        camera.blades = blades;
        camera.bladeRotationRad = 0.4f;
        expectEven(
            [&](Vec2 u) {
                const glm::dvec2 p(sampleLens(camera, u));
                return blades == 0 ? glm::dvec2(glm::dot(p, p), turns(p.y, p.x))
                                   : polygonCell(p, blades, 0.4);
            },
            seed++);
    }
}

/// The largest distance between the samples' and the given distribution function over [-1, 1].
void expectDistribution(FilterKind filter, const std::function<double(double)>& cumulative) {
    std::vector<double> offsets;
    for (int i = 0; i < kSamples; ++i) {
        const float u = (static_cast<float>(i) + 0.5f) / kSamples;
        const Vec2 offset = sampleFilter(filter, 1.5f, Vec2(u, 0.25f));
        ASSERT_LE(std::fabs(offset.x), 1.5f);
        offsets.push_back(static_cast<double>(offset.x) / 1.5);
    }
    ASSERT_TRUE(
        std::is_sorted(offsets.begin(), offsets.end(), [](double a, double b) { return a < b - 1e-4; }));
    double worst = 0.0;
    for (int i = 0; i < kSamples; ++i) {
        worst =
            std::fmax(worst, std::fabs(cumulative(offsets[static_cast<size_t>(i)]) - (i + 0.5) / kSamples));
    }
    EXPECT_LT(worst, 2e-5);  // u itself has 24 bits; the inversion's own error is about 1e-5
}

TEST(Filter, BoxIsEven) {
    expectDistribution(FilterKind::Box, [](double t) { return 0.5 + 0.5 * t; });
}

TEST(Filter, GaussianIsExact) {
    expectDistribution(FilterKind::Gaussian, [](double t) {
        return 0.5 + 0.5 * std::erf(3.0 * t / std::sqrt(2.0)) / std::erf(3.0 / std::sqrt(2.0));
    });
}

TEST(Filter, BlackmanHarrisIsExact) {
    expectDistribution(FilterKind::BlackmanHarris, [](double t) {
        const double sum = 0.35875 * t + 0.48829 / M_PI * std::sin(M_PI * t) +
                           0.14128 / (2.0 * M_PI) * std::sin(2.0 * M_PI * t) +
                           0.01168 / (3.0 * M_PI) * std::sin(3.0 * M_PI * t);
        return 0.5 + 0.5 * sum / 0.35875;
    });
}

TEST(Filter, EndsAreFinite) {
    for (const FilterKind filter : {FilterKind::Box, FilterKind::Gaussian, FilterKind::BlackmanHarris}) {
        for (const float u : {0.0f, 0x1p-24f, 0.5f, kOneMinusEpsilon}) {
            const Vec2 offset = sampleFilter(filter, 2.0f, Vec2(u, 1.0f - u));
            EXPECT_LE(std::fabs(offset.x), 2.0f);
            EXPECT_LE(std::fabs(offset.y), 2.0f);
        }
    }
}

/// All rays through one point of the picture meet in the plane in focus, wherever they cross the lens.
void expectToMeetInFocus(ProjectionKind kind, const Vec2& shift) {
    Camera camera;
    camera.kind = kind;
    camera.shift = shift;
    camera.position = Vec3(1.0f, 2.0f, 3.0f);
    camera.target = Vec3(-2.0f, 1.0f, -4.0f);
    camera.apertureDiameter = 0.5f;
    camera.focalDistance = 6.0f;
    const CameraData data = *buildCamera(camera, 1.5f);
    Random random(40);
    for (int i = 0; i < 1000; ++i) {
        const Vec2 ndc = 2.0f * random.uniform2() - 1.0f;
        CameraData stopped = data;
        stopped.lensRadius = 0.0f;
        const Ray pinhole = cameraRay<kFeatureCameraArea>(stopped, ndc, Vec2(0.5f));
        const Ray ray = cameraRay<kFeatureCameraArea>(data, ndc, random.uniform2());
        const Vec3 axis = -data.frame.n;
        const Vec3 focus = pinhole.at(6.0f / glm::dot(pinhole.direction, axis));
        const Vec3 reached = ray.at(6.0f / glm::dot(ray.direction, axis));
        ASSERT_LT(glm::length(focus - reached), 2e-5f);
        ASSERT_LE(glm::length(ray.origin - pinhole.origin), 0.25f + 1e-6f);
        ASSERT_NEAR(glm::length(ray.direction), 1.0f, 1e-6f);
    }
}

TEST(Camera, RaysMeetInThePlaneInFocus) {
    for (const ProjectionKind kind : {ProjectionKind::Perspective, ProjectionKind::Orthographic}) {
        expectToMeetInFocus(kind, Vec2(0.0f));
        expectToMeetInFocus(kind, Vec2(0.4f, -1.1f));
    }
}

}  // namespace
}  // namespace glint::test
