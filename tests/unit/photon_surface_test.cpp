// What a photon remembers of its surface, and which surfaces' photons count for each other.
#include "engine/kernels/photon_surface.h"

#include <random>

#include <gtest/gtest.h>

#include "engine/builders/scene_builder.h"
#include "tests/support/render_scene.h"
#include "tests/support/sppm_scenes.h"
#include "tests/support/test_scenes.h"

namespace glint::test {
namespace {

TEST(PhotonLayout, GivesBackWhatWasPacked) {
    std::mt19937 rng(5);
    std::normal_distribution<float> normal;
    const auto direction = [&] { return glm::normalize(Vec3(normal(rng), normal(rng), normal(rng))); };
    for (const PhotonLayout layout : {PhotonLayout{false, false}, PhotonLayout{true, false},
                                      PhotonLayout{false, true}, PhotonLayout{true, true}}) {
        const bool knowsSurface = layout.knowsSurface;
        for (uint32_t i = 0; i < 1000; ++i) {
            const Vec3 wi = direction(), ng = direction();
            const uint32_t depth = i % 256,
                           surface = knowsSurface ? layout.mostSurfaces() - i : kOpaqueSurface;
            const uint32_t band = layout.knowsBand ? i % 16 : 0;
            Photon photon;
            layout.pack(wi, ng, depth, surface, band, &photon);
            ASSERT_LT(glm::length(layout.wi(photon) - wi), knowsSurface ? 1.1e-3f : 7e-5f);
            ASSERT_LT(glm::length(layout.ng(photon) - ng), knowsSurface       ? 0.018f
                                                           : layout.knowsBand ? 4.4e-3f
                                                                              : 1.1e-3f);
            ASSERT_EQ(layout.band(photon), band);
            ASSERT_EQ(layout.depth(photon), depth);
            ASSERT_EQ(layout.surface(photon), surface);
        }
    }
}

SppmParams settledFor(const SceneDescription& scene) {
    const auto built = buildAll(scene);
    SppmParams params;
    params.photonsKnowSurface = true;  // must not stay
    return settledParams(built->view(), params);
}

TEST(PhotonSurface, IsKnownWhereSomethingLetsStoredPhotonsThrough) {
    EXPECT_FALSE(settledFor(cornellBox()).photonsKnowSurface);
    EXPECT_FALSE(settledFor(glassBox()).photonsKnowSurface) << "smooth glass keeps no photons";
    EXPECT_TRUE(settledFor(roughGlassBox()).photonsKnowSurface);
    EXPECT_TRUE(settledFor(texturedInputs()).photonsKnowSurface);
    SceneDescription sharper = roughGlassBox();
    sharper.materials.back().roughness.value = 0.05f;
    EXPECT_FALSE(settledFor(sharper).photonsKnowSurface) << "below storeAlpha";
    sharper.materials.back().kind = MaterialKind::Mixture;
    sharper.materials.back().mixtureWeights.value = Vec3(1.0f, 1.0f, 0.0f);
    EXPECT_FALSE(settledFor(sharper).photonsKnowSurface);
    sharper.materials.back().mixtureWeights.value = Vec3(1.0f, 0.0f, 0.2f);
    EXPECT_TRUE(settledFor(sharper).photonsKnowSurface);
    for (Object& object : sharper.objects) {
        object.material = 0;
    }
    EXPECT_FALSE(settledFor(sharper).photonsKnowSurface) << "nothing has the material";
}

/// The floor, the lamp, a ball in a ball, another ball, and a sheet of two tiles.
TEST(PhotonSurface, SharesByTheRule) {
    const SceneDescription scene = roughGlassInContact();
    const auto built = buildAll(scene);
    const SceneView view = built->view();
    const SppmParams params = settledParams(view, {});
    const auto number = [&](uint32_t instance) {
        return surfaceNumber<kAllFeatures>(view, params, instance);
    };
    const uint32_t floor = number(0), ball = number(2), inner = number(3), tile = number(5), next = number(6);
    EXPECT_EQ(floor, kOpaqueSurface);
    EXPECT_EQ(number(1), kOpaqueSurface);
    EXPECT_NE(ball, inner);
    EXPECT_NE(tile, next);
    EXPECT_TRUE(sharePhotons(view, floor, number(1), false, 0.4f, 1.0f)) << "opaque surfaces, as before";
    EXPECT_TRUE(sharePhotons(view, ball, ball, false, 0.4f, 1.0f));
    EXPECT_FALSE(sharePhotons(view, floor, ball, false, 0.0f, 1.0f));
    EXPECT_FALSE(sharePhotons(view, tile, floor, false, 0.0f, 1.0f));
    EXPECT_TRUE(sharePhotons(view, tile, next, false, 0.01f, 1.0f)) << "tiles of one sheet";
    EXPECT_FALSE(sharePhotons(view, ball, inner, false, 0.03f, 1.0f));
    EXPECT_TRUE(sharePhotons(view, floor, number(1), true, 0.01f, 1.0f)) << "tiles wound in opposite ways";
    EXPECT_FALSE(sharePhotons(view, floor, number(1), true, 0.02f, 1.0f)) << "a sheet over a floor";
    EXPECT_FALSE(sharePhotons(view, tile, next, true, 0.01f, 1.0f)) << "glass has an inside";
    EXPECT_FALSE(sharePhotons(view, ball, ball, true, 0.0f, 1.0f));
}

}  // namespace
}  // namespace glint::test
