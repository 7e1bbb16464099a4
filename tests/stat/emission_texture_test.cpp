// What shines with a texture: light that sampling finds at a point of an emitter is the light that a ray
// which hits that point sees, for every shape; photons carry the texture's power; nothing that shines is
// never chosen.
#include <gtest/gtest.h>

#include "engine/builders/light_table.h"
#include "engine/builders/power_distribution.h"
#include "engine/builders/scene_builder.h"
#include "engine/kernels/intersect.h"
#include "engine/kernels/photon_emission.h"
#include "engine/math/color.h"
#include "tests/support/render_scene.h"
#include "tests/support/statistics.h"
#include "tests/support/uniform_numbers.h"

namespace glint::test {
namespace {

constexpr float kStrength = 3.0f;

/// Linear in u (red) and v (green) but for the seam, and more than 1 in places.
Texture slopes(int size) {
    auto image = std::make_shared<ImageF>();
    image->width = size;
    image->height = size;
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const float u = (static_cast<float>(x) + 0.5f) / static_cast<float>(size);
            const float v = 1.0f - (static_cast<float>(y) + 0.5f) / static_cast<float>(size);
            image->rgb.insert(image->rgb.end(), {2.0f * u, v, 0.25f});
        }
    }
    Texture texture;
    texture.name = "slopes";
    texture.image.floats = image;
    return texture;
}

struct Case {
    const char* name;
    ShapeKind shape;
    Affine transform;
    Vec3 from;
};

Affine shear() {
    Affine a;
    a.linear = Mat3(Vec3(1.0f, 0.1f, 0.0f), Vec3(0.6f, 0.8f, 0.2f), Vec3(0.3f, -0.2f, 0.5f));
    a.translation = {0.3f, 0.1f, -0.2f};
    return a;
}

std::shared_ptr<const MeshData> twoTriangles(bool uvs) {
    auto mesh = std::make_shared<MeshData>();
    mesh->positions = {{-1.0f, -0.7f, 0.0f}, {1.0f, -0.4f, 0.0f}, {0.2f, 1.0f, 0.0f}, {1.5f, 1.2f, 0.3f}};
    mesh->indices = {0, 1, 2, 2, 1, 3};
    if (uvs) { mesh->uvs = {{0.1f, 0.2f}, {0.9f, 0.1f}, {0.3f, 0.8f}, {0.7f, 0.9f}}; }
    return mesh;
}

SceneDescription sceneOf(ShapeKind shape, const Affine& transform, bool uvs = true) {
    SceneDescription scene = emptyScene({0.0f, 0.0f, 4.0f}, Vec3(0.0f), 40.0f, 8);
    scene.textures.push_back(slopes(256));
    Material material = emissiveMaterial(Vec3(0.0f), true);
    material.emission.texture = 0;
    material.emissionStrength = kStrength;
    addObject(&scene, shape, transform, material);
    if (shape == ShapeKind::Mesh) { scene.objects.back().mesh = addMesh(&scene, twoTriangles(uvs)); }
    return scene;
}

class EmissionTexture : public testing::TestWithParam<Case> {};

/// The texture coordinates of both ways differ by rounding: 1e-4 of a texture's width is 200 of their units
/// in the last place, and a fortieth of a texel.
TEST_P(EmissionTexture, SampledLightIsWhatARaySees) {
    const auto built = buildAll(sceneOf(GetParam().shape, GetParam().transform));
    const SceneView view = built->view();
    LightContext at;
    at.p = GetParam().from;
    at.bothSides = true;
    UniformNumbers random(7);
    int seen = 0;
    for (int i = 0; i < 20000; ++i) {
        const LightSample light = sampleLight<kAllFeatures>(view, at, random.next(), random.next2());
        if (!(light.pdfSolidAngle > 0.0f)) { continue; }
        const Ray ray{at.p, light.wiWorld, 0.0f, kInfinity};
        Hit hit;
        if (!intersect<kAllFeatures>(view, ray, &hit)) { continue; }
        const SurfacePoint surface = surfaceAt<kAllFeatures>(view, ray, hit);
        if (glm::length(surface.p - light.point) > 1e-3f) { continue; }
        const bool onSeam =
            surface.uv.x < 0.01f || surface.uv.x > 0.99f || surface.uv.y < 0.01f || surface.uv.y > 0.99f;
        if (onSeam) { continue; }
        const Vec3 expected = emittedRadiance<kAllFeatures>(view, surface, -light.wiWorld);
        EXPECT_NEAR(expected.x, 2.0f * kStrength * surface.uv.x, 1e-4f) << "else the texture is not read";
        ASSERT_LT(maxComponent(absVec(light.radiance - expected)), 2e-4f * kStrength) << surface.uv.x;
        ++seen;
    }
    EXPECT_GT(seen, 5000);
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, EmissionTexture,
    testing::Values(Case{"sphere", ShapeKind::Sphere, translate({1, 2, 3}) * scale(Vec3(2.0f)), {4, 2, 6}},
                    Case{"ellipsoid", ShapeKind::Sphere, shear(), {2, 2, 1}},
                    Case{"rectangle", ShapeKind::Rectangle, shear(), shear().point({0.2f, 0.4f, 1.0f})},
                    Case{"disc", ShapeKind::Disc, shear(), shear().point({0.2f, 0.4f, 1.0f})},
                    Case{"mesh", ShapeKind::Mesh, shear(), shear().point({0.2f, 0.1f, 0.6f})},
                    Case{"mirrored", ShapeKind::Mesh, scale({1, 1, -1}), {0.2f, 0.1f, -0.9f}}),
    [](const auto& each) { return each.param.name; });

/// pi times the integral of the radiance over the area, on both sides.
TEST(EmissionTexture, PhotonsCarryItsPower) {
    for (const bool uvs : {true, false}) {
        SceneDescription scene = sceneOf(ShapeKind::Mesh, shear(), uvs);
        // Without uvs a corner has the coordinates (1, 0), where an image that repeats has its seam.
        scene.textures[0].wrapU = scene.textures[0].wrapV = WrapMode::Clamp;
        const auto built = buildAll(scene);
        const PowerDistribution power = buildPowerDistribution(built->view());
        UniformNumbers random(11);
        RunningMean red;
        for (int i = 0; i < 200000; ++i) {
            red.add(static_cast<double>(emitPhoton<kAllFeatures>(built->view(), power.view(), random.next(),
                                                                 random.next2(), random.next2())
                                            .flux.x));
        }
        const MeshData& mesh = *scene.meshes[0].data;
        double expected = 0.0;
        for (size_t i = 0; i < 2; ++i) {
            Vec3 p[3];
            float u = uvs ? 0.0f : 1.0f / 3.0f;  // linear over the triangle: the mean is the centroid's
            for (size_t corner = 0; corner < 3; ++corner) {
                const uint32_t index = mesh.indices[3 * i + corner];
                p[corner] = shear().point(mesh.positions[index]);
                u += uvs ? mesh.uvs[index].x / 3.0f : 0.0f;
            }
            const float area = 0.5f * glm::length(glm::cross(p[1] - p[0], p[2] - p[0]));
            expected += 2.0 * static_cast<double>(kPi * area * kStrength * 2.0f * u);
        }
        EXPECT_NEAR(red.mean(), expected, kNormalQuantile * red.standardError());
    }
}

/// A texture of one bright texel between the places that the mean looks at.
TEST(EmissionTexture, WhatShinesIsChosen) {
    Texture texture = slopes(1024);
    auto image = std::make_shared<ImageF>(*texture.image.floats);
    std::fill(image->rgb.begin(), image->rgb.end(), 0.0f);
    for (int y = 0; y < 24; ++y) {
        for (size_t x = 0; x < 24; ++x) {
            image->rgb[3 * (static_cast<size_t>(500 + y) * 1024 + 500 + x)] = 1.0f;
        }
    }
    texture.image.floats = image;
    SceneDescription scene = sceneOf(ShapeKind::Mesh, Affine{});
    scene.textures[0] = texture;
    const auto built = buildAll(scene);
    for (const EmitterData& e : built->lights->emitters) {
        EXPECT_GT(luminance(e.radiance), 0.0f);
    }
}

TEST(EmissionTexture, AnotherImageIsSeenByTheLights) {
    SceneDescription scene = sceneOf(ShapeKind::Rectangle, Affine{});
    const auto before = buildAll(scene);
    scene.textures[0].scale = Vec2(0.25f);
    SceneEdit edit;
    edit.scene = std::make_shared<SceneDescription>(scene);
    edit.kinds = EditKind::MaterialKind;
    const auto after = buildScene(edit, before.get(), 1, nullptr, nullptr);
    ASSERT_TRUE(after);
    EXPECT_LT((*after)->lights->emitters[0].radiance.x, 0.5f * before->lights->emitters[0].radiance.x);
}

}  // namespace
}  // namespace glint::test
