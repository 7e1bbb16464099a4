// Cut-outs: the share of rays that pass, for rays of every kind and every shape.
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

Material veil(float opacity, float albedo = 0.0f) {
    Material material = diffuseMaterial(albedo);
    material.opacity.value = opacity;
    return material;
}

/// The expected value lies within the confidence interval.
void expectMean(const SceneDescription& scene, double expected, const char* what) {
    const Estimate seen = meanLuminance(renderFilm(scene, 256));
    EXPECT_GT(seen.standardError, 0.0) << what;
    EXPECT_LT(seen.standardError, 0.02 * expected + 1e-3) << what;
    EXPECT_NEAR(seen.mean, expected, kNormalQuantile * seen.standardError + 1e-4) << what;
}

/// Nothing but a sky of 1 behind what the camera is to see.
SceneDescription beforeTheSky() {
    SceneDescription scene = emptyScene({0.0f, 0.0f, 4.0f}, Vec3(0.0f), 10.0f, 16);
    scene.environment.color = Vec3(1.0f);
    return scene;
}

TEST(Cutouts, ShowWhatIsBehindThem) {
    for (const float opacity : {0.25f, 0.9f}) {
        SceneDescription scene = beforeTheSky();
        addObject(&scene, ShapeKind::Rectangle, Affine{}, veil(opacity));
        expectMean(scene, 1.0 - static_cast<double>(opacity), "a square");
    }
    SceneDescription layers = beforeTheSky();
    const int material = addMaterial(&layers, veil(0.5f));
    for (const float z : {0.0f, 0.1f, 1.0f}) {
        addObject(&layers, ShapeKind::Rectangle, translate({0, 0, z}), material);
    }
    expectMean(layers, 0.125, "three squares");
    SceneDescription sphere = beforeTheSky();
    addObject(&sphere, ShapeKind::Sphere, Affine{}, veil(0.5f));
    expectMean(sphere, 0.25, "both sides of a sphere");
    SceneDescription revolved = beforeTheSky();
    addObject(&revolved, ShapeKind::Revolved, Affine{}, veil(0.5f));
    revolved.objects.back().profile = {{0.5f, -1.0f}, {0.5f, 1.0f}};
    revolved.camera.verticalFovDeg = 5.0f;
    expectMean(revolved, 0.25, "both sides of a tube");
}

/// base + gain x of the alpha decides where the texture says so, as glTF's masks do.
TEST(Cutouts, HaveAThreshold) {
    SceneDescription scene = beforeTheSky();
    addObject(&scene, ShapeKind::Rectangle, Affine{}, veil(1.0f));
    Texture texture;
    texture.image.bytes = std::make_shared<const Image8>(Image8{1, 1, {255, 255, 255}, {102}});
    scene.textures.push_back(texture);
    scene.materials.back().opacity.texture = 0;
    expectMean(scene, 0.6, "alpha as it is");
    for (const float threshold : {0.3f, 0.5f}) {
        scene.textures[0].gain = 1e4f;
        scene.textures[0].base = -1e4f * threshold;
        const Estimate seen = meanLuminance(renderFilm(scene, 16));
        EXPECT_NEAR(seen.mean, threshold < 0.4f ? 0.0 : 1.0, 1e-6);
    }
}

/// A floor under a veil above the camera, which sees the floor alone.
SceneDescription underAVeil(float opacity) {
    SceneDescription scene = emptyScene({0.0f, 1.0f, 0.01f}, Vec3(0.0f), 10.0f, 16);
    scene.options.maxDepth = 1;
    addObject(&scene, ShapeKind::Plane, rotate({1, 0, 0}, -0.5f * kPi), diffuseMaterial(0.5f));
    addObject(&scene, ShapeKind::Rectangle, translate({0, 2, 0}) * rotate({1, 0, 0}, 0.5f * kPi),
              veil(opacity));
    return scene;
}

TEST(Cutouts, ThrowThatMuchShadow) {
    SceneDescription scene = underAVeil(0.25f);
    scene.lights.push_back(directionalLight({0, -1, 0}));
    expectMean(scene, 0.75 * 0.5 / 3.14159265, "a directional light");
    Light point;
    point.position = {0, 4, 0};
    point.strength = 16.0f;
    scene.lights = {point};
    expectMean(scene, 0.75 * 0.5 / 3.14159265, "a point light");
}

TEST(Cutouts, ShineAsMuchAsIsThere) {
    for (const DirectLightTag tag :
         {DirectLightTag::Mis, DirectLightTag::LightOnly, DirectLightTag::BsdfOnly}) {
        Estimate lit[2];
        for (const bool isWhole : {false, true}) {
            SceneDescription scene = underAVeil(0.0f);
            Material lamp = emissiveMaterial(Vec3(3.0f), true);
            lamp.opacity.value = isWhole ? 1.0f : 0.25f;
            addObject(&scene, ShapeKind::Rectangle, translate({0, 1.6f, 0}) * rotate({1, 0, 0}, 0.5f * kPi),
                      lamp);
            lit[isWhole] = meanLuminance(renderFilm(scene, 512, tag));
        }
        EXPECT_GT(lit[1].mean, 0.1);
        EXPECT_NEAR(lit[0].mean, 0.25 * lit[1].mean,
                    kNormalQuantile * std::hypot(lit[0].standardError, lit[1].standardError))
            << static_cast<int>(tag);
    }
}

/// A hard edge at u = 0.5, seen by rays of both kinds on every shape.
TEST(Cutouts, OfAnImageAreWhereItSays) {
    const auto half = greyImage(2, 1, [](int x, int) { return x == 0 ? 0.0f : 1.0f; });
    for (const ShapeKind shape : {ShapeKind::Sphere, ShapeKind::Plane, ShapeKind::Rectangle, ShapeKind::Disc,
                                  ShapeKind::Mesh, ShapeKind::Revolved}) {
        SceneDescription scene = beforeTheSky();
        Material material = diffuseMaterial(0.5f);
        material.opacity.texture = addTexture(&scene, half);
        scene.textures[0].filter = TexelFilter::Nearest;
        const Affine transform = rotate({1, 2, 3}, 0.8f) * scale({1.2f, 0.7f, 1.0f});
        if (shape == ShapeKind::Mesh) {
            MeshData box;
            addBox(&box, Vec3(-1.0f), Vec3(1.0f), false);
            for (const Vec3& p : box.positions) {
                box.uvs.push_back(Vec2(0.5f * p.x + 0.25f * p.z + 0.5f, p.y));
            }
            addMeshObject(&scene, box, transform, material);
        } else {
            addObject(&scene, shape, transform, material);
            scene.objects.back().profile = {{0.0f, -1.0f}, {1.5f, -1.0f}, {1.0f, 1.0f}, {0.0f, 1.0f}};
        }
        const auto built = buildAll(scene);
        const SceneView view = built->view();
        UniformNumbers random(1);
        int hits = 0, passed = 0;
        for (int i = 0; i < 4000; ++i) {
            const Vec3 from(6.0f * random.next2() - Vec2(3.0f), 3.0f);
            const Vec3 to(2.0f * random.next2() - Vec2(1.0f), random.next() - 0.5f);
            const Ray ray{from, to - from};
            Hit whole, hit;
            const bool meets = intersect<kAllFeatures & ~kFeatureCutouts>(view, ray, &whole);
            const bool found = intersect<kAllFeatures>(view, ray, &hit);
            ASSERT_EQ(occluded<kAllFeatures>(view, ray), found);
            if (found) {
                const SurfacePoint s = surfaceAt<kAllFeatures>(view, ray, hit);
                ASSERT_GE(s.uv.x - std::floor(s.uv.x), 0.5f) << static_cast<int>(shape);
                ASSERT_TRUE(meets);
                ASSERT_GE(hit.t, whole.t);
                Ray shorter = ray;
                shorter.tMax = 0.9999f * hit.t;
                ASSERT_FALSE(occluded<kAllFeatures>(view, shorter))
                    << static_cast<int>(shape) << " " << hit.t << " " << whole.t << " " << s.uv.x;
            }
            hits += found;
            passed += meets && (!found || hit.t > whole.t);
        }
        EXPECT_GT(hits, 200) << static_cast<int>(shape);
        EXPECT_GT(passed, 200) << static_cast<int>(shape);
    }
}

TEST(Cutouts, ByTheAlphaOfTheColour) {
    for (const bool cutsOut : {true, false}) {
        SceneDescription scene = beforeTheSky();
        scene.options.maxDepth = 0;
        Texture texture;
        texture.image.bytes = std::make_shared<Image8>(Image8{1, 1, {9, 9, 9}, {51}});  // a fifth
        scene.textures.push_back(texture);
        Material material = diffuseMaterial(0.5f);
        material.color.texture = 0;
        material.alphaCutsOut = cutsOut;
        addObject(&scene, ShapeKind::Rectangle, Affine{}, material);
        EXPECT_EQ((buildAll(scene)->features & kFeatureCutouts) != 0, cutsOut);
        if (cutsOut) {
            expectMean(scene, 0.8, "alpha");
        } else {
            EXPECT_EQ(meanLuminance(renderFilm(scene, 4)).mean, 0.0);
        }
    }
}

/// Photons that are stored on what is half there count for all of it.
TEST(Cutouts, LookAlikeByPhotons) {
    SceneDescription scene = reliefRoom(diffuseMaterial(0.7f));
    addObject(&scene, ShapeKind::Rectangle,
              placeFlatShape({0.2f, 0.8f, 0.3f}, {0.0f, 1.0f, 0.3f}, 1.0f, 0.8f), veil(0.3f, 0.8f));
    SppmParams params;
    params.photonsPerPass = 40000;
    params.radiusFootprints = 3.0f;
    for (const bool direct : {true, false}) {
        params.sampleDirectLight = direct;
        const std::vector<Vec3> photons = renderSppm(scene, params, 32).image;
        const std::vector<Vec3> paths = renderPaths(scene, 1, 256);
        for (int y = 0; y < 32; y += 8) {
            for (int x = 0; x < 32; x += 8) {
                const double expected = blockMean(paths, 32, x, y, 8);
                EXPECT_NEAR(blockMean(photons, 32, x, y, 8), expected, 0.05 * expected)
                    << x << " " << y << (direct ? " sampled" : " photons");
            }
        }
    }
}

}  // namespace
}  // namespace glint::test
