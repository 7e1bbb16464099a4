// Bumps and normal maps: normals against closed forms, shading against surfaces that are really tilted,
// energy, and photons against camera paths.
#include <cmath>

#include <gtest/gtest.h>

#include "engine/builders/built_scene.h"
#include "engine/kernels/intersect.h"
#include "engine/kernels/surface.h"
#include "tests/support/relief_scenes.h"
#include "tests/support/render_scene.h"
#include "tests/support/sppm_render.h"
#include "tests/support/uniform_numbers.h"

namespace glint::test {
namespace {

constexpr FeatureMask kMask = kAllFeatures | kFeatureTangents;
constexpr FeatureMask kFlat = kMask & ~kFeatureBumps;

/// An object of the shape alone; a mesh is a square of two triangles with texture coordinates.
SceneDescription sceneOf(ShapeKind shape, const Affine& transform, const Material& material) {
    SceneDescription scene = emptyScene({0.0f, 0.0f, 5.0f}, Vec3(0.0f), 30.0f, 16);
    if (shape == ShapeKind::Mesh) {
        MeshData mesh;
        addQuad(&mesh, {-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0});
        for (const Vec3& p : mesh.positions) {
            mesh.uvs.push_back(Vec2(0.7f * p.x + 0.1f * p.y, 0.4f * p.y));
        }
        addMeshObject(&scene, mesh, transform, material);
    } else {
        addObject(&scene, shape, transform, material);
    }
    if (shape == ShapeKind::Revolved) {
        scene.objects.back().profile = {{0.0f, -0.8f}, {1.4f, -0.5f}, {0.6f, 0.4f}, {0.0f, 0.8f}};
    }
    return scene;
}

struct BumpCase {
    const char* name;
    ShapeKind shape;
};

class BumpShapes : public testing::TestWithParam<BumpCase> {};

/// Blinn's formula with the exact derivatives of h = a sin(2 pi u) + b cos(2 pi v), on both sides, under
/// transforms that shear and mirror.
TEST_P(BumpShapes, HaveTheNormalsOfTheirHeights) {
    constexpr int kSize = 512;
    constexpr float kHeight = 0.05f;
    const auto heights = greyImage(kSize, kSize, [](int x, int y) {
        const float u = (static_cast<float>(x) + 0.5f) / kSize,
                    v = 1.0f - (static_cast<float>(y) + 0.5f) / kSize;
        return 0.5f + 0.3f * std::sin(2.0f * kPi * u) + 0.2f * std::cos(2.0f * kPi * v);
    });
    UniformNumbers random(3);
    for (const Affine& transform :
         {Affine{}, translate({0.3f, 0.1f, 0.2f}) * rotate({1, 2, 0}, 0.7f) * scale({1.5f, 0.8f, 1.2f}),
          rotate({0, 1, 1}, 2.0f) * scale({-1.0f, 1.3f, 1.0f})}) {
        Material material = diffuseMaterial(0.5f);
        material.bumpHeight = kHeight;
        material.bump.texture = 0;
        SceneDescription scene = sceneOf(GetParam().shape, transform, material);
        addTexture(&scene, heights);
        const auto built = buildAll(scene);
        ASSERT_TRUE(built);
        const SceneView view = built->view();
        int compared = 0;
        for (int i = 0; i < 400; ++i) {
            const Vec3 to(0.7f * (random.next2() * 2.0f - 1.0f), 0.0f);
            const Vec3 from = to + Vec3(random.next2() - 0.5f, i % 2 == 0 ? 3.0f : -3.0f);
            const Ray ray{transform.point(from), transform.point(to) - transform.point(from)};
            Hit hit;
            if (!intersect<kMask>(view, ray, &hit)) { continue; }
            const SurfacePoint flat = surfaceAt<kFlat>(view, ray, hit);
            const SurfacePoint bumped = surfaceAt<kMask>(view, ray, hit);
            ASSERT_EQ(flat.ns, flat.ng);
            if (GetParam().shape == ShapeKind::Sphere && std::fabs(flat.uv.y - 0.5f) > 0.4f) { continue; }
            const float du = kHeight * 0.6f * kPi * std::cos(2.0f * kPi * flat.uv.x);
            const float dv = kHeight * -0.4f * kPi * std::sin(2.0f * kPi * flat.uv.y);
            Vec3 expected = glm::normalize(glm::cross(flat.dpdu + du * flat.ng, flat.dpdv + dv * flat.ng));
            if (glm::dot(expected, flat.ng) < 0.0f) { expected = -expected; }
            ASSERT_LT(glm::length(bumped.ns - expected), 1e-3f)
                << GetParam().name << " at " << flat.uv.x << " " << flat.uv.y;
            ASSERT_EQ(bumped.ng, flat.ng);
            ++compared;
        }
        EXPECT_GT(compared, 100) << GetParam().name;
    }
}

INSTANTIATE_TEST_SUITE_P(Shapes, BumpShapes,
                         testing::Values(BumpCase{"Sphere", ShapeKind::Sphere},
                                         BumpCase{"Plane", ShapeKind::Plane},
                                         BumpCase{"Rectangle", ShapeKind::Rectangle},
                                         BumpCase{"Disc", ShapeKind::Disc}, BumpCase{"Mesh", ShapeKind::Mesh},
                                         BumpCase{"Revolved", ShapeKind::Revolved}),
                         [](const auto& bumpCase) { return std::string(bumpCase.param.name); });

/// Steep noise, up to the poles and over the seam.
TEST(Bumps, OfAnySteepnessStayOnTheirSide) {
    UniformNumbers random(5);
    Material material = diffuseMaterial(0.5f);
    material.bumpHeight = 10.0f;
    material.bump.texture = 0;
    SceneDescription scene = sceneOf(ShapeKind::Sphere, Affine{}, material);
    addTexture(&scene, greyImage(64, 32, [&](int, int) { return random.next(); }));
    const auto built = buildAll(scene);
    const SceneView view = built->view();
    for (int i = 0; i < 20000; ++i) {
        const Vec3 to = i < 10 ? Vec3(0.0f) : 0.2f * Vec3(random.next2(), random.next());
        const Ray ray{Vec3(0.0f, i % 2 == 0 ? 3.0f : -3.0f, 0.0f),
                      to - Vec3(0.0f, i % 2 == 0 ? 3.0f : -3.0f, 0.0f)};
        Hit hit;
        ASSERT_TRUE(intersect<kMask>(view, ray, &hit));
        const SurfacePoint s = surfaceAt<kMask>(view, ray, hit);
        ASSERT_GE(glm::dot(s.ns, s.ng), 0.02f - 1e-5f);
        ASSERT_NEAR(glm::length(s.ns), 1.0f, 1e-4f);
    }
}

/// A white square with a constant coded normal that leans by `leanDeg` to the image's right, or one that
/// really leans, under a light that falls straight down on it.
double litMean(float leanDeg, bool isReal, float strength = 1.0f) {
    const float angle = leanDeg * kPi / 180.0f;
    Material material = diffuseMaterial(0.8f);
    material.normalStrength = strength;
    if (!isReal) { material.normalMap.texture = 0; }
    SceneDescription scene =
        sceneOf(ShapeKind::Rectangle, isReal ? rotate({0, 1, 0}, angle) : Affine{}, material);
    auto code = std::make_shared<ImageF>(
        ImageF{1, 1, {0.5f + 0.5f * std::sin(angle), 0.5f, 0.5f + 0.5f * std::cos(angle)}});
    addTexture(&scene, code);
    scene.camera.verticalFovDeg = 5.0f;
    scene.lights.push_back(directionalLight({0, 0, -1}));
    return meanLuminance(renderFilm(scene, 4)).mean;
}

TEST(NormalMaps, OfOneTiltShadeAsATiltedSurface) {
    const double flat = litMean(0.0f, true);
    for (const float leanDeg : {0.0f, 10.0f, 25.0f, 40.0f}) {
        EXPECT_NEAR(litMean(leanDeg, false), litMean(leanDeg, true), 1e-4 * flat) << leanDeg;
    }
    EXPECT_LT(litMean(40.0f, false), 0.8 * flat);
    EXPECT_NEAR(litMean(40.0f, false, 0.0f), flat, 1e-4 * flat) << "no strength, no tilt";
}

TEST(NormalMaps, TurnWithTheirImage) {
    for (const float turnDeg : {0.0f, 90.0f, 30.0f}) {
        for (const bool flipV : {false, true}) {
            Material material = diffuseMaterial(0.5f);
            material.normalMap.texture = 0;
            SceneDescription scene = sceneOf(ShapeKind::Plane, Affine{}, material);
            const int index = addTexture(
                &scene, std::make_shared<ImageF>(ImageF{1, 1, {0.5f + 0.3f, 0.5f + 0.2f, 0.5f + 0.3464f}}));
            scene.textures[static_cast<size_t>(index)].rotationDeg = turnDeg;
            scene.textures[static_cast<size_t>(index)].flipV = flipV;
            const auto built = buildAll(scene);
            const Ray ray{Vec3(0.2f, 0.3f, 2.0f), Vec3(0.0f, 0.0f, -1.0f)};
            Hit hit;
            ASSERT_TRUE(intersect<kMask>(built->view(), ray, &hit));
            const Vec3 ns = surfaceAt<kMask>(built->view(), ray, hit).ns;
            // uv turned by the angle are the image's place: its axes lie turned back on the plane.
            const float c = std::cos(turnDeg * kPi / 180.0f), s = std::sin(turnDeg * kPi / 180.0f);
            const Vec2 right(c, -s), top = Vec2(s, c) * (flipV ? -1.0f : 1.0f);
            const Vec2 expected = 0.6f * right + 0.4f * top;
            EXPECT_NEAR(ns.x, expected.x, 1e-3f) << turnDeg << flipV;
            EXPECT_NEAR(ns.y, expected.y, 1e-3f) << turnDeg << flipV;
        }
    }
}

/// White things in white light, every pixel of them: nothing gains light, and no spot is black.
TEST(Bumps, GainNoLightAndTurnNothingBlack) {
    UniformNumbers random(9);
    const auto noise = greyImage(64, 32, [&](int, int) { return random.next(); });
    for (const MaterialKind kind :
         {MaterialKind::Diffuse, MaterialKind::Mirror, MaterialKind::Conductor, MaterialKind::Dielectric,
          MaterialKind::Plastic, MaterialKind::Mixture, MaterialKind::Principled}) {
        Material material = diffuseMaterial(1.0f);
        material.kind = kind;
        material.roughness.value = 0.3f;
        material.metal.clear();
        material.eta.value = Vec3(1e-3f);  // reflects all but nothing
        material.k.value = Vec3(100.0f);
        material.mixtureWeights.value = Vec3(0.4f, 0.3f, 0.3f);
        material.metallic.value = 0.5f;
        material.clearcoat.value = 1.0f;
        material.sheenColor.value = Vec3(0.5f);
        material.bump.texture = 0;
        material.bumpHeight = 0.2f;
        SceneDescription scene = sceneOf(ShapeKind::Sphere, Affine{}, material);
        addTexture(&scene, noise);
        scene.environment.color = Vec3(1.0f);
        scene.options.maxDepth = 64;
        scene.camera.verticalFovDeg = 20.0f;
        const Film film = renderFilm(scene, 256);
        for (int y = 4; y < 12; y += 2) {
            for (int x = 4; x < 12; x += 2) {
                const Estimate block = meanLuminance(film, x, y, x + 2, y + 2);
                EXPECT_LE(block.mean, 1.001 + kNormalQuantile * block.standardError)
                    << static_cast<int>(kind) << " " << x << " " << y;
                EXPECT_GE(block.mean, 0.3) << static_cast<int>(kind) << " " << x << " " << y;
            }
        }
        EXPECT_EQ(film.faults().size(), 0u);
    }
}

TEST(Bumps, CostNothingWhereThereAreNone) {
    const auto featuresOf = [](float height, bool isChosen) {
        Material material = diffuseMaterial(0.5f);
        material.bumpHeight = height;
        material.bump.texture = isChosen ? 0 : -1;
        SceneDescription scene = sceneOf(ShapeKind::Sphere, Affine{}, material);
        addTexture(&scene, waves(8, 1));
        return buildAll(scene)->features;
    };
    EXPECT_EQ(featuresOf(0.1f, false) & (kFeatureBumps | kFeatureTextures), FeatureMask{0});
    EXPECT_EQ(featuresOf(0.0f, true) & kFeatureBumps, FeatureMask{0});
    EXPECT_NE(featuresOf(0.1f, true) & kFeatureBumps, FeatureMask{0});
}

}  // namespace
}  // namespace glint::test
