// Highlights of brushed surfaces, against closed forms. Seen from a point that also shines, at a height of 1
// over a plane, a facet reflects back where its slope is the place; so the picture of the highlight is the
// distribution of slopes, but for what the distance and the cosines take off at the edge, a per cent or two
// of the widths here.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/render_scene.h"
#include "tests/support/test_scenes.h"

namespace glint::test {
namespace {

constexpr int kSize = 128;
constexpr float kHalfView = 0.5f;  ///< metres, at the plane
constexpr float kSharp = 0.04f, kRough = 0.12f;

Material brushedMetal(FacetDistribution distribution) {
    Material metal;
    metal.kind = MaterialKind::Conductor;
    metal.metal = "silver";
    metal.color.value = Vec3(1.0f);
    metal.roughness.value = kSharp;
    metal.crossRoughness.value = kRough;
    metal.distribution = distribution;
    return metal;
}

/// The surface lies in z = 0, its u along x, and fills the picture.
SceneDescription lampAtTheCamera(const Material& material) {
    SceneDescription scene;
    scene.resolution = {kSize, kSize};
    scene.camera.position = {0.0f, 0.0f, 1.0f};
    scene.camera.target = Vec3(0.0f);
    scene.camera.verticalFovDeg = 2.0f * std::atan(kHalfView) * 180.0f / kPi;
    scene.environment.color = Vec3(0.0f);
    scene.options.maxDepth = 1;
    scene.options.filter = FilterKind::Box;
    scene.options.filterRadius = 0.5f;
    Light lamp;
    lamp.position = scene.camera.position;
    scene.lights.push_back(lamp);
    scene.materials.push_back(material);
    return scene;
}

SceneDescription plate(const Material& material) {
    SceneDescription scene = lampAtTheCamera(material);
    scene.objects.emplace_back();
    scene.objects.back().shape = ShapeKind::Rectangle;
    scene.objects.back().material = 0;
    return scene;
}

/// A disc that was turned on a lathe: u runs around it.
SceneDescription turnedDisc(const Material& material) {
    SceneDescription scene = lampAtTheCamera(material);
    Object disc;
    disc.shape = ShapeKind::Revolved;
    disc.curve = CurveKind::Bezier;
    disc.profile = {{1.0f, 0.0f}, {0.0f, 0.0f}};
    disc.material = 0;
    disc.objectToWorld.linear = Mat3(Vec3(1, 0, 0), Vec3(0, 0, 1), Vec3(0, -1, 0));
    scene.objects.push_back(disc);
    return scene;
}

/// Metres from the middle at which the highlight falls to half its peak, along x or y.
float halfWidth(const SceneDescription& scene, bool alongY) {
    const Film film = renderFilm(scene, 16);
    const auto at = [&](int i) {
        const int middle = kSize / 2, x = alongY ? middle : i, y = alongY ? i : middle;
        return meanLuminance(film, x, y, x + 1, y + 1).mean;
    };
    const double peak = at(kSize / 2);
    EXPECT_GT(peak, 0.0);
    int i = kSize / 2;
    while (i < kSize - 1 && at(i) > 0.5 * peak) {
        ++i;
    }
    const double before = at(i - 1), after = at(i);
    const double pixels = i - 1 + 0.5 - kSize / 2 + (before - 0.5 * peak) / (before - after);
    return static_cast<float>(pixels * 2.0 * static_cast<double>(kHalfView) / kSize);
}

/// In units of alpha: (1 + r^2)^-2 and exp(-r^2) are a half there.
float halfRadius(FacetDistribution distribution) {
    return distribution == FacetDistribution::Ggx ? std::sqrt(std::sqrt(2.0f) - 1.0f)
                                                  : std::sqrt(std::log(2.0f));
}

constexpr FacetDistribution kDistributions[] = {FacetDistribution::Ggx, FacetDistribution::Beckmann};

TEST(Brushed, HighlightsStretchAcrossTheGrooves) {
    for (const FacetDistribution distribution : kDistributions) {
        const float unit = halfRadius(distribution);
        Material metal = brushedMetal(distribution);
        EXPECT_NEAR(halfWidth(plate(metal), false), unit * kSharp, 0.05f * unit * kSharp);
        EXPECT_NEAR(halfWidth(plate(metal), true), unit * kRough, 0.05f * unit * kRough);
        metal.anisotropyRotationDeg = 90.0f;
        EXPECT_NEAR(halfWidth(plate(metal), false), unit * kRough, 0.05f * unit * kRough);
        metal.anisotropyRotationDeg = 0.0f;
        metal.anisotropyDirection.value = {0.5f, 1.0f, 0.5f};
        EXPECT_NEAR(halfWidth(plate(metal), false), unit * kRough, 0.05f * unit * kRough);
    }
}

/// Along v the place is across the grooves everywhere: the highlight is round, and as wide as the cross
/// roughness; turned by a quarter, as wide as the other.
TEST(Brushed, GroovesRunAroundTurnedDiscs) {
    for (const FacetDistribution distribution : kDistributions) {
        const float unit = halfRadius(distribution);
        Material metal = brushedMetal(distribution);
        for (const bool alongY : {false, true}) {
            EXPECT_NEAR(halfWidth(turnedDisc(metal), alongY), unit * kRough, 0.05f * unit * kRough);
        }
        metal.anisotropyRotationDeg = 90.0f;
        for (const bool alongY : {false, true}) {
            EXPECT_NEAR(halfWidth(turnedDisc(metal), alongY), unit * kSharp, 0.07f * unit * kSharp);
        }
    }
}

/// Meshes lie along their texture coordinates, and without any have facets of some direction.
TEST(Brushed, MeshesLieAlongTheirTextureCoordinates) {
    const Material metal = brushedMetal(FacetDistribution::Ggx);
    const float unit = halfRadius(FacetDistribution::Ggx);
    for (const bool isTurned : {false, true}) {
        SceneDescription scene = lampAtTheCamera(metal);
        MeshData mesh;
        mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
        mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
        if (isTurned) { mesh.uvs = {{0, 1}, {0, 0}, {1, 0}, {1, 1}}; }
        mesh.indices = {0, 1, 2, 0, 2, 3};
        scene.meshes.emplace_back();
        scene.meshes.back().data = std::make_shared<const MeshData>(mesh);
        scene.objects.emplace_back();
        scene.objects.back().shape = ShapeKind::Mesh;
        scene.objects.back().mesh = 0;
        scene.objects.back().material = 0;
        const float wanted = unit * (isTurned ? kRough : kSharp);
        EXPECT_NEAR(halfWidth(scene, false), wanted, 0.05f * wanted);
    }
}

}  // namespace
}  // namespace glint::test
