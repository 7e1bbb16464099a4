// Pictures whose values are known in closed form: furnaces, and single lights over a plane. Each comparison
// at significance 1e-6 with the error estimated from the film.

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/light_scene.h"
#include "tests/support/render_scene.h"

namespace glint {
namespace {

using test::agree;
using test::Estimate;
using test::renderFilm;

constexpr DirectLightTag kStrategies[] = {DirectLightTag::Mis, DirectLightTag::LightOnly,
                                          DirectLightTag::BsdfOnly};

std::string describe(const Estimate& e) {
    return std::to_string(e.mean) + " +- " + std::to_string(e.standardError);
}

void expectMean(const Film& film, double expected, double slack = 1e-4) {
    const Estimate found = test::meanLuminance(film);
    EXPECT_TRUE(agree(found, {expected, 0.0}, slack)) << describe(found) << ", expected " << expected;
}

/// From inside a closed sphere that emits 1 and reflects `albedo`, everything looks alike.
SceneDescription closedSphere(float albedo, int maxDepth, int rouletteStartDepth) {
    SceneDescription scene = emptyScene({0.2f, -0.3f, 0.1f}, {1, 0, 0}, 60, 16);
    Material material = emissiveMaterial(Vec3(1.0f), true);
    material.color.value = Vec3(albedo);
    addObject(&scene, ShapeKind::Sphere, scale(Vec3(2.0f)), material);
    scene.options.maxDepth = maxDepth;
    scene.options.rouletteStartDepth = rouletteStartDepth;
    return scene;
}

TEST(Furnace, ClosedSphereShowsTheGeometricSeries) {
    for (const float albedo : {0.1f, 0.5f, 0.8f}) {
        for (const DirectLightTag strategy : kStrategies) {
            SCOPED_TRACE("albedo " + std::to_string(albedo) + " strategy " +
                         std::to_string(static_cast<int>(strategy)));
            expectMean(renderFilm(closedSphere(albedo, 200, 4), 32, strategy),
                       1.0 / (1.0 - static_cast<double>(albedo)));
        }
    }
}

TEST(Furnace, MaximumDepthCutsTheSeriesOff) {
    double sum = 0.0;
    for (int depth = 0; depth <= 4; ++depth) {
        sum += std::pow(0.5, depth);
        SCOPED_TRACE(depth);
        for (const DirectLightTag strategy : kStrategies) {
            expectMean(renderFilm(closedSphere(0.5f, depth, 100), 16, strategy), sum);
            expectMean(renderFilm(closedSphere(0.5f, depth, 0), 64, strategy), sum);
        }
    }
}

/// Triangles much larger than what is seen of them, whose height is exact: their own rays must leave them.
TEST(Furnace, MeshFloorsDoNotShadowThemselves) {
    for (const float halfSize : {1.0f, 100.0f, 1e6f}) {
        for (const float height : {0.0f, 0.3f}) {
            SCOPED_TRACE(std::to_string(halfSize) + " at " + std::to_string(height));
            SceneDescription scene = emptyScene({0.05f, height + 0.5f, 0.02f}, {0.03f, height, 0.1f}, 10, 16);
            scene.environment.color = Vec3(1.0f);
            scene.options.maxDepth = 1;
            auto mesh = std::make_shared<MeshData>();
            const float s = halfSize;
            mesh->positions = {{-s, height, -s}, {-s, height, s}, {s, height, s}, {s, height, -s}};
            mesh->indices = {0, 1, 2, 0, 2, 3};
            addMeshObject(&scene, *mesh, {}, diffuseMaterial(0.5f));
            for (const DirectLightTag strategy : kStrategies) {
                expectMean(renderFilm(scene, 16, strategy), 0.5);
            }
        }
    }
}

/// A lamp whose triangles are in its mesh twice shines as it would with each of them once.
TEST(Furnace, RepeatedEmitterTrianglesCountOnce) {
    const auto lit = [](std::vector<uint32_t> indices, DirectLightTag strategy) {
        SceneDescription scene = emptyScene({0.3f, 0.5f, 0.4f}, {0, 0, 0}, 0.05f, 16);
        scene.options.maxDepth = 1;
        addObject(&scene, ShapeKind::Plane, placeFlatShape({0, 0, 0}, {0, 1, 0}, 1, 1),
                  diffuseMaterial(0.5f));
        auto mesh = std::make_shared<MeshData>();
        mesh->positions = {{-1, 1, -1}, {1, 1, -1}, {1, 1, 1}, {-1, 1, 1}};
        mesh->indices = std::move(indices);
        addMeshObject(&scene, *mesh, {}, emissiveMaterial(Vec3(1.0f), false));
        return test::meanLuminance(renderFilm(scene, 128, strategy));
    };
    for (const DirectLightTag strategy : kStrategies) {
        const Estimate once = lit({0, 1, 2, 0, 2, 3}, strategy);
        const Estimate twice = lit({0, 1, 2, 0, 2, 3, 1, 2, 0, 0, 2, 3}, strategy);
        EXPECT_GT(once.mean, 0.1);
        EXPECT_TRUE(agree(twice, once)) << describe(twice) << " " << describe(once);
    }
}

Material shinyMaterial(MaterialKind kind, float roughness, bool thin = false) {
    Material material = diffuseMaterial(1.0f);
    material.kind = kind;
    material.roughness.value = roughness;
    material.thin = thin;
    material.metal.clear();
    return material;
}

/// A sphere of the material in a uniform environment of radiance 1, filling the picture.
SceneDescription whiteFurnace(const Material& material) {
    SceneDescription scene = emptyScene({0, 0, 4}, {0, 0, 0}, 20, 16);
    scene.environment.color = Vec3(1.0f);
    scene.options.maxDepth = 400;
    addObject(&scene, ShapeKind::Sphere, Affine{}, material);
    return scene;
}

TEST(Furnace, WhiteMaterialsVanish) {
    Material mixture = shinyMaterial(MaterialKind::Mixture, 0.0f);
    mixture.mixtureWeights.value = {1, 2, 3};
    const Material materials[] = {diffuseMaterial(1.0f), shinyMaterial(MaterialKind::Mirror, 0.0f),
                                  shinyMaterial(MaterialKind::Dielectric, 0.0f),
                                  shinyMaterial(MaterialKind::Dielectric, 0.0f, true), mixture};
    for (const Material& material : materials) {
        SCOPED_TRACE(static_cast<int>(material.kind));
        for (const DirectLightTag strategy : kStrategies) {
            expectMean(renderFilm(whiteFurnace(material), 32, strategy), 1.0);
        }
    }
}

/// Their models leave out light that bounces more than once between facets, so that they may lose some, but
/// never gain.
TEST(Furnace, RoughAndCoatedMaterialsNeverGain) {
    Material conductor = shinyMaterial(MaterialKind::Conductor, 0.5f);
    conductor.eta.value = Vec3(0.01f);
    conductor.k.value = Vec3(1000.0f);
    Material cloth = shinyMaterial(MaterialKind::Principled, 0.5f);
    cloth.metallic.value = 0.3f;
    cloth.sheenColor.value = Vec3(1.0f);
    Material paint = shinyMaterial(MaterialKind::Principled, 0.4f);
    paint.metallic.value = 0.5f;
    paint.clearcoat.value = 1.0f;
    const Material materials[] = {
        conductor, shinyMaterial(MaterialKind::Dielectric, 0.3f), cloth,
        paint,     shinyMaterial(MaterialKind::Plastic, 0.0f),    shinyMaterial(MaterialKind::Plastic, 0.3f)};
    for (const Material& material : materials) {
        SCOPED_TRACE(static_cast<int>(material.kind));
        Estimate byStrategy[3];
        for (size_t i = 0; i < 3; ++i) {
            byStrategy[i] = test::meanLuminance(renderFilm(whiteFurnace(material), 64, kStrategies[i]));
            EXPECT_LE(byStrategy[i].mean, 1.0 + 1e-4 + test::kNormalQuantile * byStrategy[i].standardError);
            EXPECT_GT(byStrategy[i].mean, 0.6);
            EXPECT_TRUE(agree(byStrategy[i], byStrategy[0]))
                << describe(byStrategy[i]) << " " << describe(byStrategy[0]);
        }
    }
}

/// A plane of albedo 0.5 at y = 0 seen from above in a picture that covers next to nothing: radiance at
/// the origin.
SceneDescription spotOnPlane() {
    SceneDescription scene = emptyScene({0.1f, 1.0f, 0.7f}, {0, 0, 0}, 0.05f, 16);
    addObject(&scene, ShapeKind::Plane, placeFlatShape({0, 0, 0}, {0, 1, 0}, 1, 1), diffuseMaterial(0.5f));
    scene.options.maxDepth = 1;
    return scene;
}

double reflected(double irradiance) { return irradiance * 0.5 / static_cast<double>(kPi); }

TEST(LightOverPlane, Disc) {
    SceneDescription scene = spotOnPlane();
    addObject(&scene, ShapeKind::Disc, placeFlatShape({0, 1.5f, 0}, {0, -1, 0}, 0.8f, 0.8f),
              emissiveMaterial(Vec3(3.0f), false));
    const double irradiance = static_cast<double>(kPi) * 3.0 * 0.64 / (0.64 + 2.25);
    for (const DirectLightTag strategy : kStrategies) {
        expectMean(renderFilm(scene, 256, strategy), reflected(irradiance), 1e-3);
    }
}

TEST(LightOverPlane, DiscFacingAwayIsDark) {
    SceneDescription scene = spotOnPlane();
    addObject(&scene, ShapeKind::Disc, placeFlatShape({0, 1.5f, 0}, {0, 1, 0}, 0.8f, 0.8f),
              emissiveMaterial(Vec3(3.0f), false));
    for (const DirectLightTag strategy : kStrategies) {
        EXPECT_EQ(test::meanLuminance(renderFilm(scene, 64, strategy)).mean, 0.0);
    }
}

TEST(LightOverPlane, Sphere) {
    SceneDescription scene = spotOnPlane();
    addObject(&scene, ShapeKind::Sphere, translate({0, 2, 0}) * scale(Vec3(0.5f)),
              emissiveMaterial(Vec3(3.0f), false));
    const double irradiance = static_cast<double>(kPi) * 3.0 * 0.25 / 4.0;
    for (const DirectLightTag strategy : kStrategies) {
        expectMean(renderFilm(scene, 256, strategy), reflected(irradiance), 1e-3);
    }
}

/// Seen from below its middle, a rectangle's irradiance is 2 L (a/A atan(b/A) + b/B atan(a/B)), A = sqrt(h^2
/// + a^2) and B = sqrt(h^2 + b^2), with half edges a, b (four times the corner's form factor).
TEST(LightOverPlane, Rectangle) {
    const double a = 0.6, b = 0.9, h = 0.8;
    const double rootA = std::hypot(a, h), rootB = std::hypot(b, h);
    const double irradiance =
        2.0 * 3.0 * (a / rootA * std::atan(b / rootA) + b / rootB * std::atan(a / rootB));
    SceneDescription scene = spotOnPlane();
    addObject(&scene, ShapeKind::Rectangle, placeFlatShape({0, 0.8f, 0}, {0, -1, 0}, 0.6f, 0.9f),
              emissiveMaterial(Vec3(3.0f), false));
    scene.camera.position = {0.2f, 0.5f, 0.3f};
    for (const DirectLightTag strategy : kStrategies) {
        expectMean(renderFilm(scene, 256, strategy), reflected(irradiance), 1e-3);
    }

    // The same lamp as two triangles, and as an instance of a mesh under a non-uniform transform.
    auto mesh = std::make_shared<MeshData>();
    mesh->positions = {{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}};
    mesh->indices = {0, 1, 2, 0, 2, 3};
    scene.objects.pop_back();
    addMeshObject(&scene, *mesh, translate({0, 0.8f, 0}) * glint::scale(Vec3(0.6f, 5.0f, 0.9f)),
                  emissiveMaterial(Vec3(3.0f), false));
    for (const DirectLightTag strategy : kStrategies) {
        expectMean(renderFilm(scene, 256, strategy), reflected(irradiance), 1e-3);
    }
}

Light lightOf(LightKind kind, const Vec3& position, const Vec3& direction) {
    Light light;
    light.kind = kind;
    light.position = position;
    light.direction = direction;
    light.color = Vec3(2.0f);
    light.strength = 3.0f;
    return light;
}

TEST(LightOverPlane, PointFallsOffWithDistanceSquaredAndCosine) {
    for (const Vec3& position : {Vec3(0, 1, 0), Vec3(0, 2, 0), Vec3(3, 2, -1)}) {
        SceneDescription scene = spotOnPlane();
        scene.lights.push_back(lightOf(LightKind::Point, position, {0, -1, 0}));
        const double distance = static_cast<double>(glm::length(position));
        expectMean(renderFilm(scene, 4),
                   reflected(6.0 * static_cast<double>(position.y) / std::pow(distance, 3.0)), 2e-3);
    }
}

TEST(LightOverPlane, DirectionalHasItsIrradianceFacingIt) {
    SceneDescription scene = spotOnPlane();
    scene.lights.push_back(lightOf(LightKind::Directional, {}, {3, -4, 0}));
    expectMean(renderFilm(scene, 4), reflected(6.0 * 0.8), 1e-4);
    scene.lights[0].direction = {3, 4, 0};
    EXPECT_EQ(test::meanLuminance(renderFilm(scene, 4)).mean, 0.0);
}

TEST(LightOverPlane, SpotFallsOffBetweenItsCones) {
    const auto valueAt = [](float angleDeg) {
        SceneDescription scene = spotOnPlane();
        const float angle = angleDeg * kPi / 180.0f;
        Light light = lightOf(LightKind::Spot, {0, 1, 0}, {std::sin(angle), -std::cos(angle), 0});
        light.coneAngleDeg = 40.0f;
        light.coneFalloffStartDeg = 30.0f;
        scene.lights.push_back(light);
        return test::meanLuminance(renderFilm(scene, 4)).mean;
    };
    EXPECT_NEAR(valueAt(0.0f), reflected(6.0), 2e-3);
    EXPECT_NEAR(valueAt(29.0f), reflected(6.0), 2e-3);
    EXPECT_EQ(valueAt(41.0f), 0.0);
    // Halfway in the cosine between the cones a smooth step is at one half.
    const double middle =
        std::acos(0.5 * (std::cos(30.0 / 180.0 * 3.14159265) + std::cos(40.0 / 180.0 * 3.14159265)));
    EXPECT_NEAR(valueAt(static_cast<float>(middle * 180.0 / 3.14159265)), reflected(3.0), 2e-2);
}

TEST(LightOverPlane, EmissivePlaneIsSeenThoughItCannotBeSampled) {
    SceneDescription scene = spotOnPlane();
    addObject(&scene, ShapeKind::Plane, placeFlatShape({0, 3, 0}, {0, -1, 0}, 1, 1),
              emissiveMaterial(Vec3(3.0f), false));
    for (const DirectLightTag strategy : kStrategies) {
        expectMean(renderFilm(scene, 16, strategy), 1.5, 1e-3);
    }
}

}  // namespace
}  // namespace glint
