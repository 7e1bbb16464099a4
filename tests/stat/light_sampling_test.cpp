// Directions that light sampling finds are distributed as their density says: for every kind of emitter, from
// near, far and inside. Chi-square at significance 1e-6 each; the expected counts integrate the density of
// pdfEmitterShape() over directions that the scene's own intersection says meet the emitter's lit side.

#include "engine/kernels/light_sampling.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "engine/kernels/intersect.h"
#include "engine/kernels/surface.h"
#include "engine/math/color.h"
#include "tests/support/cone_grid.h"
#include "tests/support/light_scene.h"
#include "tests/support/statistics.h"
#include "tests/support/uniform_numbers.h"

namespace glint {
namespace {

using test::chiSquare;
using test::ChiSquare;
using test::ConeGrid;
using test::expectedCounts;
using test::LightScene;
using test::UniformNumbers;

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
    std::vector<double> counts(ConeGrid::kCells, 0.0);
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

}  // namespace
}  // namespace glint
