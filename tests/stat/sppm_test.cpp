// SPPM against its own formulas, and at its edges: thin walls, mirrors only, no light, one-sided walls,
// memory. Bits over threads, sums over look-ups. Agreement with path tracing is in sppm_agreement_test.cpp,
// photons' power in sppm_energy_test.cpp.
#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include "engine/kernels/sppm_gather_kernel.h"
#include "tests/support/render_scene.h"
#include "tests/support/sppm_render.h"
#include "tests/support/sppm_scenes.h"
#include "tests/support/test_scenes.h"

namespace glint::test {
namespace {

SppmParams quickParams() {
    SppmParams params;
    params.photonsPerPass = 8000;
    params.radiusFootprints = 2.0f;
    return params;
}

TEST(Sppm, StatisticsFollowThePaper) {
    // With M photons every pass: N_i = i alpha M, R_i^2 = R_0^2 prod (N + alpha M) / (N + M).
    constexpr double kAlpha = 2.0 / 3.0;
    SppmPixel pixel;
    pixel.radiusSquared = 4.0;
    double expected = 4.0;
    double n = 0.0;
    for (uint32_t pass = 0; pass < 1000; ++pass) {
        Gathered gathered;
        gathered.count = 1 + pass % 7;
        gathered.flux = Vec3(2.0f, 1.0f, 0.5f) * static_cast<float>(gathered.count);
        updatePixel(gathered, kAlpha, pass, 1.0, &pixel);
        const double m = gathered.count;
        expected *= (n + kAlpha * m) / (n + m);
        n += kAlpha * m;
    }
    EXPECT_NEAR(pixel.radiusSquared, expected, 1e-12 * expected);
    EXPECT_NEAR(pixel.photonCount, n, 1e-9 * n);
    // Every photon brought the same flux from the first disc on, so tau / (pi R^2) stays that of the first
    // pass's density times the number of photons per area: tau = sum of flux kept = flux per photon times N.
    EXPECT_NEAR(pixel.flux[0], 2.0 * n, 1e-9 * n);
}

TEST(Sppm, AMillionPassesStayFiniteAndFollowTheAsymptoticLaw) {
    constexpr double kAlpha = 0.7;
    SppmPixel pixel;
    pixel.radiusSquared = 1.0;
    Gathered gathered;
    gathered.count = 3;
    gathered.flux = Vec3(1.0f);
    double atTenThousand = 0.0;
    for (uint32_t pass = 0; pass < 1000000; ++pass) {
        updatePixel(gathered, kAlpha, pass, 1.0, &pixel);
        if (pass + 1 == 10000) { atTenThousand = pixel.radiusSquared; }
    }
    // The factors are (i + 1) / (i + 1 / alpha), so R^2 falls like passes^(1 - 1 / alpha).
    EXPECT_NEAR(pixel.radiusSquared / atTenThousand, std::pow(100.0, 1.0 - 1.0 / kAlpha), 1e-4);
    EXPECT_TRUE(std::isfinite(pixel.flux[0]) && pixel.flux[0] > 0.0);
}

TEST(Sppm, APassWithoutPhotonsChangesNothing) {
    SppmPixel pixel;
    pixel.radiusSquared = 0.25;
    pixel.photonCount = 7.0;
    pixel.flux[1] = 3.0;
    for (uint32_t pass = 0; pass < 10000; ++pass) {
        updatePixel(Gathered{}, 0.5, pass, 1.0, &pixel);
    }
    EXPECT_EQ(pixel.radiusSquared, 0.25);
    EXPECT_EQ(pixel.photonCount, 7.0);
    EXPECT_EQ(pixel.flux[1], 3.0);
}

bool sameStatistics(const SppmState& a, const SppmState& b) {
    return a.pixels.size() == b.pixels.size() &&
           std::memcmp(a.pixels.data(), b.pixels.data(), a.pixels.size() * sizeof(SppmPixel)) == 0;
}

TEST(Sppm, BitsDoNotDependOnThreads) {
    const SceneDescription scene = small(allMaterials());
    const SppmRender one = renderSppm(scene, quickParams(), 3, 1);
    for (const int threads : {2, 3}) {
        const SppmRender more = renderSppm(scene, quickParams(), 3, threads);
        EXPECT_TRUE(sameStatistics(one.state, more.state)) << threads << " threads";
        EXPECT_EQ(one.image, more.image) << threads << " threads";
    }
}

TEST(Sppm, TreeAndGridGiveTheSameSums) {
    SppmParams params = quickParams();
    const SppmRender grid = renderSppm(roughGlassBox(), params, 3);
    params.lookup = PhotonLookupKind::Tree;
    const SppmRender tree = renderSppm(roughGlassBox(), params, 3);
    size_t lit = 0;
    for (size_t i = 0; i < grid.state.pixels.size(); ++i) {
        const SppmPixel& a = grid.state.pixels[i];
        const SppmPixel& b = tree.state.pixels[i];
        ASSERT_EQ(a.photonCount, b.photonCount) << "pixel " << i;
        // A few hundred float additions in another order.
        ASSERT_NEAR(a.flux[1], b.flux[1], 1e-4 * a.flux[1]) << "pixel " << i;
        lit += a.photonCount > 0.0 ? 1 : 0;
    }
    EXPECT_GT(lit, grid.state.pixels.size() / 2);
}

/// A lamp over a thin wall that shadows a floor: the wall's two faces are nearer than the radius.
SceneDescription thinWall() {
    SceneDescription scene;
    scene.resolution = {16, 16};
    scene.options.maxDepth = 2;
    Material wall;
    wall.name = "wall";
    wall.color.value = Vec3(0.5f);
    Material emitter = wall;
    emitter.name = "lamp";
    emitter.emission.value = Vec3(5.0f);
    scene.materials = {wall, emitter};
    Object plate;
    plate.shape = ShapeKind::Rectangle;
    plate.name = "lower face";
    plate.objectToWorld = rotate(Vec3(1, 0, 0), kPi);  // its front looks down
    plate.objectToWorld.translation = Vec3(0.0f, 0.0f, -0.001f);
    scene.objects.push_back(plate);
    plate.name = "upper face";
    plate.objectToWorld = Affine{};
    scene.objects.push_back(plate);
    Object source;
    source.shape = ShapeKind::Rectangle;
    source.material = 1;
    source.objectToWorld = translate(Vec3(0, 0, 0.5f)) * rotate(Vec3(1, 0, 0), kPi);
    scene.objects.push_back(source);
    scene.camera.position = Vec3(0, 0, -1.5f);
    scene.camera.target = Vec3(0.0f);
    scene.camera.up = Vec3(0, 1, 0);
    scene.camera.verticalFovDeg = 40.0f;
    return scene;
}

TEST(Sppm, ThinWallsDoNotLeak) {
    SppmParams params;
    params.photonsPerPass = 20000;
    params.radiusWorld = 0.1f;  // a hundred times the wall
    params.sampleDirectLight = false;
    const SppmRender below = renderSppm(thinWall(), params, 2);
    for (size_t i = 0; i < below.image.size(); ++i) {
        ASSERT_EQ(below.image[i], Vec3(0.0f)) << "pixel " << i;
        ASSERT_EQ(below.state.pixels[i].photonCount, 0.0);
    }
    SceneDescription fromAbove = thinWall();
    fromAbove.objects.back().objectToWorld.translation.x =
        2.5f;  // aside, so that the camera sees the lit face
    fromAbove.camera.position = Vec3(0, 0, 1.5f);
    const SppmRender above = renderSppm(fromAbove, params, 2);
    EXPECT_GT(blockMean(above.image, 16, 4, 4, 8), 0.0) << "the lit face must be lit";
}

/// A lamp within a closed ball that is seen from without, or the other way round.
SceneDescription ballBetweenLampAndCamera(bool lampWithin, bool asMesh) {
    SceneDescription scene = emptyScene(lampWithin ? Vec3(0, 0, 4) : Vec3(0, 0, 0.5f), Vec3(0.0f), 40.0f, 16);
    scene.options.maxDepth = 4;
    if (asMesh) {
        addMeshObject(&scene, addMesh(&scene, bumpySphere(24, 48, false)), {},
                      addMaterial(&scene, diffuseMaterial(0.8f)));
    } else {
        addObject(&scene, ShapeKind::Sphere, {}, diffuseMaterial(0.8f));
    }
    Light lamp;
    lamp.position = lampWithin ? Vec3(0.4f, 0.2f, 0.0f) : Vec3(0, 0, -4);
    lamp.strength = 100.0f;
    scene.lights.push_back(lamp);
    return scene;
}

TEST(Sppm, ClosedCurvedSurfacesDoNotLeak) {
    SppmParams params;
    params.photonsPerPass = 20000;
    params.radiusWorld = 0.4f;
    params.sampleDirectLight = false;
    for (const bool lampWithin : {true, false}) {
        for (const bool asMesh : {true, false}) {
            const SppmRender render = renderSppm(ballBetweenLampAndCamera(lampWithin, asMesh), params, 2);
            for (size_t i = 0; i < render.image.size(); ++i) {
                ASSERT_EQ(render.image[i], Vec3(0.0f))
                    << "pixel " << i << (lampWithin ? ", lamp within" : "") << (asMesh ? ", mesh" : "");
            }
            EXPECT_GT(render.lastPass.photons.rays, 0u);
        }
    }
}

TEST(Sppm, MirrorsAndEscapesOnly) {
    SceneDescription scene = small(cornellBox());
    scene.objects.resize(1);
    scene.materials[static_cast<size_t>(scene.objects[0].material)].kind = MaterialKind::Mirror;
    scene.environment.color = Vec3(0.5f);
    const SppmRender render = renderSppm(scene, quickParams(), 2);
    for (size_t i = 0; i < render.image.size(); ++i) {
        ASSERT_TRUE(isFinite(render.image[i]));
        ASSERT_EQ(render.state.pixels[i].radiusSquared, 0.0) << "no visible point, no radius";
    }
}

/// Photons would otherwise begin to count anew, and bring light that belongs to much longer paths.
TEST(Sppm, PathsEndWherePhotonsCannotCountFurther) {
    SceneDescription scene = emptyScene({0.0f, 0.5f, 0.3f}, {0.6f, 0.7f, 0.4f}, 40.0f, 8);
    addObject(&scene, ShapeKind::Sphere, {}, diffuseMaterial(1.0f));
    addObject(&scene, ShapeKind::Sphere, scale(Vec3(0.05f)), emissiveMaterial(Vec3(1.0f)));
    SppmParams params = quickParams();
    params.photonsPerPass = 500;
    scene.options.maxDepth = kMostPhotonScatterings;
    const SppmRender most = renderSppm(scene, params, 1);
    EXPECT_GT(most.lastPass.photons.rays, 150u * params.photonsPerPass) << "many live so long";
    scene.options.maxDepth = 2 * kMostPhotonScatterings;
    EXPECT_TRUE(sameStatistics(renderSppm(scene, params, 1).state, most.state));
}

TEST(Sppm, NoLightNoPhotons) {
    const SppmRender render = renderSppm(small(darkness()), quickParams(), 2);
    for (const Vec3& pixel : render.image) {
        ASSERT_EQ(pixel, Vec3(0.0f));
    }
}

TEST(Sppm, MemoryIsPlannedWithinItsBudget) {
    const SppmMemory free = planSppmMemory(1920, 1080, 262144, 4.0, 0);
    EXPECT_EQ(free.photonsPerPass, 262144u);
    EXPECT_LE(free.pixelBytes, 1920u * 1080u * 128u);
    EXPECT_LE(free.photonBytes, 262144u * 4u * 48u);
    const SppmMemory tight = planSppmMemory(1920, 1080, 10000000, 4.0, size_t{512} << 20);
    EXPECT_LT(tight.photonsPerPass, 10000000u);
    EXPECT_GT(tight.photonsPerPass, 1000000u);
    EXPECT_LE(tight.total(), size_t{512} << 20);
}

/// A lamp behind a wall that is seen from its front only, and a floor before it, further than a radius.
SceneDescription emitterBehindOneSidedWall(bool withWall) {
    SceneDescription scene = emptyScene({0, 1, 4}, {0, -1, 1}, 40.0f, 16);
    scene.options.maxDepth = 4;
    addObject(&scene, ShapeKind::Rectangle, placeFlatShape({0, -1, 10.5}, {0, 1, 0}, 10, 10),
              diffuseMaterial(0.8f));
    if (withWall) {
        const size_t wall = addObject(&scene, ShapeKind::Rectangle,
                                      placeFlatShape({0, 0, 0}, {0, 0, 1}, 500, 500), diffuseMaterial(0.8f));
        scene.objects[static_cast<size_t>(wall)].frontOnly = true;
    }
    Light emitter;
    emitter.position = {0, 1, -2};
    emitter.strength = 100.0f;
    scene.lights.push_back(emitter);
    return scene;
}

TEST(Sppm, NoPhotonComesThroughTheBackOfAOneSidedWall) {
    SppmParams params;
    params.photonsPerPass = 20000;
    params.radiusWorld = 0.2f;
    params.sampleDirectLight = false;
    const auto mean = [&](bool withWall) {
        return blockMean(renderSppm(emitterBehindOneSidedWall(withWall), params, 2).image, 16, 0, 0, 16);
    };
    EXPECT_GT(mean(false), 0.0);
    EXPECT_EQ(mean(true), 0.0);
    EXPECT_EQ(blockMean(renderPaths(emitterBehindOneSidedWall(true), 1, 2), 16, 0, 0, 16), 0.0);
}

}  // namespace
}  // namespace glint::test
