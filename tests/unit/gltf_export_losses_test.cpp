// What glTF files cannot hold is left out or approximated, and said.
#include <gmock/gmock.h>

#include "tests/support/gltf_export_test.h"

namespace glint::test {
namespace {

using testing::Contains;
using testing::IsEmpty;

class GltfExportLosses : public GltfExportTest {};

TEST_F(GltfExportLosses, WhatGltfDoesNotHaveIsSaid) {
    SceneDescription scene = repositoryScene("cornell.json");
    scene.options.maxDepth = 3;
    scene.camera.apertureDiameter = 0.1f;
    scene.camera.shift = {0.1f, 0.0f};
    scene.camera.horizontalScale = 2.0f;
    scene.environment.color = Vec3(1.0f);
    scene.materials[0].kind = MaterialKind::Mixture;
    scene.objects[0].frontOnly = true;
    scene.lights.emplace_back().kind = LightKind::Spot;
    exported(scene);
    for (const char* what :
         {"integrator, depth and filter are the program's own", "all is in focus", "the lens is not shifted",
          "pixels are square", "there is no light from all around", "mixtures are their heaviest part",
          "what is seen from its front alone is seen from behind",
          "spots fall off by the square of the cosine"}) {
        EXPECT_THAT(warnings, Contains(std::string("approximated: ") + what));
    }
}

TEST_F(GltfExportLosses, LightsOfRayCastingAreLeftOut) {
    SceneDescription scene = square();
    scene.lights.emplace_back().onlyRayCast = true;
    EXPECT_TRUE(exported(scene).lights.empty());
    EXPECT_THAT(warnings, Contains("left out: lights of ray casting alone"));
}

/// A model without a light has the studio's in every program of its own.
TEST_F(GltfExportLosses, TheStudioStaysAtHome) {
    const auto scene = loadScene(folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
    ASSERT_TRUE(scene);
    ASSERT_EQ(scene->objects.size(), 2u) << "with a ground";
    EXPECT_EQ(exported(*scene).objects.size(), 1u);
    EXPECT_THAT(warnings, IsEmpty());
}

}  // namespace
}  // namespace glint::test
