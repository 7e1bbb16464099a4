// Directions that light sampling finds are distributed as their density says: for every kind of emitter, from
// near, far and inside. Chi-square at significance 1e-6 each; the expected counts integrate the density of
// pdfEmitterShape() over directions that the scene's own intersection says meet the emitter's lit side.

#include "engine/kernels/light_sampling.h"

#include <algorithm>
#include <numbers>

#include <gtest/gtest.h>

#include "engine/kernels/intersect.h"
#include "engine/kernels/surface.h"
#include "engine/math/color.h"
#include "tests/support/light_scene.h"
#include "tests/support/statistics.h"
#include "tests/support/uniform_numbers.h"

namespace glint {
namespace {

using test::chiSquare;
using test::ChiSquare;
using test::LightScene;
using test::UniformNumbers;

constexpr int kBinsCos = 20;
constexpr int kBinsPhi = 20;
constexpr int kSubdivisions = 40;
constexpr int kSamples = 200000;

struct Case {
    const char* name;
    ShapeKind shape;
    Affine transform;
    Vec3 from;
    bool bothSides = false;
};

SceneDescription sceneOf(const Case& c) {
    SceneDescription scene;
    scene.materials.push_back(emissiveMaterial(Vec3(1.0f), c.bothSides));
    Object object;
    object.shape = c.shape;
    object.objectToWorld = c.transform;
    if (c.shape == ShapeKind::Mesh) {
        auto mesh = std::make_shared<MeshData>();
        mesh->positions = {{-1.0f, -0.7f, 0.0f}, {1.0f, -0.4f, 0.0f}, {0.2f, 1.0f, 0.0f}};
        mesh->indices = {0, 1, 2};
        scene.meshes.push_back({"triangle", {}, mesh});
        object.mesh = 0;
    }
    scene.objects.push_back(object);
    return scene;
}

Affine shear() {
    Affine a;
    a.linear = Mat3(Vec3(1.0f, 0.1f, 0.0f), Vec3(0.6f, 0.8f, 0.2f), Vec3(0.3f, -0.2f, 0.5f));
    a.translation = {0.3f, 0.1f, -0.2f};
    return a;
}

std::vector<Case> cases() {
    const Affine tilt = rotate({1, 2, 0.5f}, 0.7f);
    return {
        {"sphere, far", ShapeKind::Sphere, scale(Vec3(0.5f)), {10, 20, -30}},
        {"sphere, very far", ShapeKind::Sphere, scale(Vec3(0.01f)), {100, 0, 0}},
        {"sphere, near", ShapeKind::Sphere, translate({1, 2, 3}) * scale(Vec3(2.0f)), {1, 2.1f, 5.05f}},
        {"sphere, tiny world", ShapeKind::Sphere, scale(Vec3(1e-6f)), {0, 3e-6f, 1e-6f}},
        {"sphere, huge world", ShapeKind::Sphere, scale(Vec3(1e6f)), {0, 3e6f, 1e6f}},
        {"sphere, inside", ShapeKind::Sphere, tilt * scale(Vec3(2.0f)), {0.5f, -0.9f, 0.7f}, true},
        {"ellipsoid, outside", ShapeKind::Sphere, scale({1.0f, 0.2f, 0.5f}), {1.5f, 0.7f, -0.4f}},
        {"ellipsoid, sheared", ShapeKind::Sphere, shear(), {2, 2, 1}},
        {"ellipsoid, mirrored", ShapeKind::Sphere, scale({-1.0f, 0.2f, 0.5f}), {1.5f, 0.7f, -0.4f}},
        {"ellipsoid, inside", ShapeKind::Sphere, shear(), {0.4f, 0.2f, -0.2f}, true},
        {"rectangle, near", ShapeKind::Rectangle, tilt * scale({1.0f, 0.5f, 1.0f}),
         tilt.point({0.8f, -0.6f, 0.2f})},
        {"rectangle, above", ShapeKind::Rectangle, tilt, tilt.point({0.1f, 0.2f, 0.02f})},
        {"rectangle, far", ShapeKind::Rectangle, scale(Vec3(0.3f)), {4, 3, 5}},
        {"rectangle, behind", ShapeKind::Rectangle, scale(Vec3(0.7f)), {0.5f, 0.4f, -0.6f}, true},
        {"rectangle, mirrored", ShapeKind::Rectangle, scale({1.0f, -1.0f, 1.0f}), {0.5f, 0.4f, 0.6f}},
        {"parallelogram", ShapeKind::Rectangle, shear(), shear().point({0.2f, 0.4f, 1.0f})},
        {"disc", ShapeKind::Disc, tilt, tilt.point({0.3f, 0.9f, 0.7f})},
        {"elliptical disc", ShapeKind::Disc, shear(), shear().point({0.2f, 0.4f, 1.0f})},
        {"triangle, near", ShapeKind::Mesh, tilt, tilt.point({0.2f, 0.1f, 0.3f})},
        {"triangle, far", ShapeKind::Mesh, shear(), shear().point({3.0f, 4.0f, 12.0f})},
        {"triangle, mirrored", ShapeKind::Mesh, scale({1, 1, -1}), {0.2f, 0.1f, -0.3f}},
    };
}

/// Cells over a cone of directions around an axis, equal in solid angle.
struct ConeGrid {
    Frame frame;
    double oneMinusCosMax;

    Vec3 direction(double cosPart, double phiPart) const {
        const double oneMinusCos = cosPart * oneMinusCosMax;
        const double r = std::sqrt(std::max(0.0, oneMinusCos * (2.0 - oneMinusCos)));
        const double phi = 2.0 * std::numbers::pi * phiPart;
        const glm::dvec3 w = r * std::cos(phi) * glm::dvec3(frame.s) +
                             r * std::sin(phi) * glm::dvec3(frame.t) +
                             (1.0 - oneMinusCos) * glm::dvec3(frame.n);
        return Vec3(glm::normalize(w));
    }
    size_t cell(const Vec3& w) const {
        const double x = glm::dot(glm::dvec3(w), glm::dvec3(frame.s)),
                     y = glm::dot(glm::dvec3(w), glm::dvec3(frame.t));
        const double z = glm::dot(glm::dvec3(w), glm::dvec3(frame.n));
        const double oneMinusCos = z > 0.0 ? (x * x + y * y) / (1.0 + z) : 1.0 - z;
        const double phi = std::atan2(y, x) / (2.0 * std::numbers::pi);
        const int i = std::clamp(static_cast<int>(oneMinusCos / oneMinusCosMax * kBinsCos), 0, kBinsCos - 1);
        const int j = std::clamp(static_cast<int>((phi < 0.0 ? phi + 1.0 : phi) * kBinsPhi), 0, kBinsPhi - 1);
        return static_cast<size_t>(i * kBinsPhi + j);
    }
    double cellSolidAngle() const { return 2.0 * std::numbers::pi * oneMinusCosMax / (kBinsCos * kBinsPhi); }
};

/// Counts a stratified integral of `density` over every cell would expect.
template <class Density>
std::vector<double> expectedCounts(const ConeGrid& grid, UniformNumbers& random, int samples,
                                   const Density& density) {
    std::vector<double> expected(kBinsCos * kBinsPhi, 0.0);
    constexpr double kShare = 1.0 / (kSubdivisions * kSubdivisions);
    for (int i = 0; i < kBinsCos * kSubdivisions; ++i) {
        for (int j = 0; j < kBinsPhi * kSubdivisions; ++j) {
            const double a = (i + static_cast<double>(random.next())) / (kBinsCos * kSubdivisions);
            const double b = (j + static_cast<double>(random.next())) / (kBinsPhi * kSubdivisions);
            const auto cell = static_cast<size_t>(i / kSubdivisions * kBinsPhi + j / kSubdivisions);
            expected[cell] += samples * density(grid.direction(a, b)) * grid.cellSolidAngle() * kShare;
        }
    }
    return expected;
}

/// The cone around the light's directions that the samples fill, a little wider.
ConeGrid gridAround(const std::vector<Vec3>& directions) {
    glm::dvec3 mean(0.0);
    for (const Vec3& w : directions) {
        mean += glm::dvec3(w);
    }
    const bool everywhere = glm::length(mean) < 0.3 * static_cast<double>(directions.size());
    ConeGrid grid{Frame::fromNormal(Vec3(glm::normalize(mean))), 2.0};
    if (everywhere) { return grid; }
    double most = 0.0;
    for (const Vec3& w : directions) {
        const glm::dvec3 across = glm::cross(glm::dvec3(w), glm::dvec3(grid.frame.n));
        const double z = glm::dot(glm::dvec3(w), glm::dvec3(grid.frame.n));
        most = std::max(most, z > 0.0 ? glm::dot(across, across) / (1.0 + z) : 1.0 - z);
    }
    grid.oneMinusCosMax = std::min(2.0, 1.02 * most);
    return grid;
}

class EmitterShape : public testing::TestWithParam<Case> {};

TEST_P(EmitterShape, DirectionsFollowTheirDensity) {
    const Case& c = GetParam();
    const LightScene scene(sceneOf(c));
    ASSERT_EQ(scene.view.lights.emitters.count, 1u);
    const LightContext at{c.from, Vec3(0, 0, 1), true};
    UniformNumbers random(7);

    std::vector<Vec3> directions;
    int rejected = 0;
    for (int i = 0; i < kSamples; ++i) {
        const LightSample s = sampleLight<kAllFeatures>(scene.view, at, random.next(), random.next2());
        if (!(s.pdfSolidAngle > 0.0f)) {
            ++rejected;
            continue;
        }
        ASSERT_NEAR(glm::length(s.wiWorld), 1.0f, 1e-5f);
        ASSERT_EQ(s.radiance, Vec3(1.0f));
        const float pdf = pdfLightSurface<kAllFeatures>(scene.view, at, 0, s.point);
        ASSERT_NEAR(pdf / s.pdfSolidAngle, 1.0f, 1e-3f) << "sample " << i;
        directions.push_back(s.wiWorld);
    }
    EXPECT_LE(rejected, kSamples / 1000);

    const ConeGrid grid = gridAround(directions);
    std::vector<double> counts(kBinsCos * kBinsPhi, 0.0);
    for (const Vec3& w : directions) {
        counts[grid.cell(w)] += 1.0;
    }
    const auto density = [&](const Vec3& w) -> double {
        const Ray ray{c.from, w};
        Hit hit;
        if (!intersect<kAllFeatures>(scene.view, ray, &hit)) { return 0.0; }
        const SurfacePoint surface = surfaceAt<kAllFeatures>(scene.view, ray, hit);
        if (!c.bothSides && glm::dot(surface.ng, w) >= 0.0f) { return 0.0; }
        return static_cast<double>(pdfLightSurface<kAllFeatures>(scene.view, at, 0, surface.p));
    };
    const std::vector<double> expected = expectedCounts(grid, random, kSamples, density);
    double total = 0.0;
    for (const double e : expected) {
        total += e;
    }
    EXPECT_NEAR(total / kSamples, 1.0, 5e-3);
    const ChiSquare result = chiSquare(counts, expected, 20.0);
    EXPECT_TRUE(result.passes()) << result.statistic << " > " << result.critical() << " (" << result.degrees
                                 << ")";
}

INSTANTIATE_TEST_SUITE_P(Light, EmitterShape, testing::ValuesIn(cases()), [](const auto& tested) {
    std::string name = tested.param.name;
    std::erase_if(name, [](char ch) { return ch == ' ' || ch == ','; });
    return name;
});

/// A dark image with a bright texel, a bright corner at the seam and some texture.
SceneImage spottedImage() {
    auto image = std::make_shared<ImageF>();
    image->width = 16;
    image->height = 8;
    image->rgb.assign(16 * 8 * 3, 0.0f);
    const auto set = [&](int x, int y, float value) {
        for (int c = 0; c < 3; ++c) {
            image->rgb[static_cast<size_t>(3 * (y * 16 + x) + c)] = value;
        }
    };
    for (int x = 0; x < 16; ++x) {
        set(x, 5, 0.5f + 0.1f * static_cast<float>(x % 3));
    }
    set(4, 2, 50.0f);
    set(15, 6, 20.0f);
    set(7, 0, 10.0f);
    return {.floats = image};
}

SceneDescription environmentScene(bool image, float rotationDeg) {
    SceneDescription scene;
    scene.environment.color = Vec3(2.0f);
    scene.environment.rotationDeg = rotationDeg;
    if (image) {
        scene.environmentImages.push_back(spottedImage());
        scene.environment.image = 0;
    }
    return scene;
}

void checkEnvironment(const SceneDescription& description, const LightContext& at) {
    const LightScene scene(description);
    UniformNumbers random(11);
    const ConeGrid grid{Frame::fromNormal(glm::normalize(Vec3(0.2f, 0.9f, -0.3f))), 2.0};
    std::vector<double> counts(kBinsCos * kBinsPhi, 0.0);
    constexpr int kImageSamples = 40000;
    for (int i = 0; i < kImageSamples; ++i) {
        const LightSample s = sampleLight<kAllFeatures>(scene.view, at, random.next(), random.next2());
        ASSERT_GT(s.pdfSolidAngle, 0.0f);
        EXPECT_NEAR(pdfLightEnvironment<kAllFeatures>(scene.view, at, s.wiWorld) / s.pdfSolidAngle, 1.0f,
                    2e-2f)
            << "at a cell's edge both sides are right, but hardly ever: sample " << i;
        EXPECT_GE(minComponent(s.radiance), 0.0f);
        counts[grid.cell(s.wiWorld)] += 1.0;
    }
    const auto density = [&](const Vec3& w) {
        return static_cast<double>(pdfLightEnvironment<kAllFeatures>(scene.view, at, w));
    };
    const ChiSquare result = chiSquare(counts, expectedCounts(grid, random, kImageSamples, density));
    EXPECT_TRUE(result.passes()) << result.statistic << " > " << result.critical();
}

TEST(Environment, ImageDirectionsFollowTheirDensity) {
    checkEnvironment(environmentScene(true, 0.0f), {Vec3(0.0f), Vec3(0, 1, 0), false});
    checkEnvironment(environmentScene(true, 77.0f), {Vec3(0.0f), Vec3(0, 1, 0), true});
}

TEST(Environment, ConstantDirectionsFollowTheirDensity) {
    checkEnvironment(environmentScene(false, 0.0f), {Vec3(0.0f), glm::normalize(Vec3(1, 1, 0.3f)), false});
    checkEnvironment(environmentScene(false, 0.0f), {Vec3(0.0f), glm::normalize(Vec3(1, 1, 0.3f)), true});
}

TEST(Environment, EveryBrightDirectionHasDensity) {
    const LightScene scene(environmentScene(true, 30.0f));
    const LightContext at{Vec3(0.0f), Vec3(0, 1, 0), true};
    UniformNumbers random(3);
    int bright = 0;
    for (int i = 0; i < 100000; ++i) {
        const Vec3 w = sampleSphere(random.next2());
        if (luminance(environmentRadiance<kAllFeatures>(scene.view, w)) <= 1e-4f) { continue; }
        ++bright;
        EXPECT_GT(pdfLightEnvironment<kAllFeatures>(scene.view, at, w), 0.0f);
    }
    EXPECT_GT(bright, 1000);
}

TEST(Environment, MiddleLooksAlongMinusZAndRotationTurnsCounterClockwise) {
    SceneDescription scene = environmentScene(true, 0.0f);
    auto image = std::make_shared<ImageF>();
    image->width = 4;
    image->height = 1;
    image->rgb = {1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 4};
    scene.environmentImages[0].floats = image;
    scene.environment.color = Vec3(1.0f);
    // Column centres lie at -135, -45, 45 and 135 degrees from -z towards +x.
    const Vec3 right45 = glm::normalize(Vec3(1, 0, -1));
    const Vec3 left45 = glm::normalize(Vec3(-1, 0, -1));
    EXPECT_NEAR(environmentRadiance<kAllFeatures>(LightScene(scene).view, right45).x, 3.0f, 1e-4f);
    EXPECT_NEAR(environmentRadiance<kAllFeatures>(LightScene(scene).view, left45).x, 2.0f, 1e-4f);
    // Seen from above, counter-clockwise takes +x to -z: what was at right45 moves to left45.
    scene.environment.rotationDeg = 90.0f;
    EXPECT_NEAR(environmentRadiance<kAllFeatures>(LightScene(scene).view, left45).x, 3.0f, 1e-4f);
}

}  // namespace
}  // namespace glint
