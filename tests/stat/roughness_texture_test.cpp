// A plate whose roughness is a texture of two halves looks like two plates of constant roughness, by path
// tracing and by photons. Same random numbers: the pictures differ by the rounding of the plates' edges and
// by the texture's filter along the seam, which is left out.
#include <gtest/gtest.h>

#include "engine/render/pass_params.h"
#include "tests/support/render_scene.h"
#include "tests/support/sppm_render.h"

namespace glint::test {
namespace {

constexpr int kSize = 32;
constexpr float kSharp = 0.08f, kDull = 0.9f;

Material plate(MaterialKind kind, float roughness) {
    Material material;
    material.kind = kind;
    material.color.value = kind == MaterialKind::Conductor ? Vec3(1.0f) : Vec3(0.6f, 0.3f, 0.1f);
    material.roughness.value = roughness;
    return material;
}

/// The plate is in the camera's plane z = 0, 2 wide; without any material it is for the caller to add.
SceneDescription litRoom() {
    SceneDescription scene = emptyScene({0.0f, 0.0f, 4.0f}, Vec3(0.0f), 26.0f, kSize);
    scene.options.maxDepth = 4;
    scene.sppm.photonsPerPass = 20000;
    addObject(&scene, ShapeKind::Sphere, translate({0.4f, 1.0f, 3.0f}) * scale(Vec3(0.5f)),
              emissiveMaterial(Vec3(8.0f)));
    addObject(&scene, ShapeKind::Rectangle,
              placeFlatShape({0.0f, -1.3f, 1.0f}, {0.0f, 1.0f, 0.0f}, 2.0f, 2.0f), diffuseMaterial(0.7f));
    return scene;
}

SceneDescription twoPlates(MaterialKind kind, float left, float right) {
    SceneDescription scene = litRoom();
    for (const bool isLeft : {true, false}) {
        addObject(&scene, ShapeKind::Rectangle,
                  translate({isLeft ? -0.5f : 0.5f, 0.0f, 0.0f}) * scale({0.5f, 1.0f, 1.0f}),
                  plate(kind, isLeft ? left : right));
    }
    return scene;
}

SceneDescription texturedPlate(MaterialKind kind) {
    SceneDescription scene = litRoom();
    auto image = std::make_shared<ImageF>();
    image->width = 256;
    image->height = 1;
    for (int x = 0; x < image->width; ++x) {
        image->rgb.insert(image->rgb.end(), 3, x < image->width / 2 ? kSharp : kDull);
    }
    Texture texture;
    texture.name = "halves";
    texture.image.floats = image;
    scene.textures.push_back(texture);
    Material material = plate(kind, 0.3f);
    material.roughness.texture = 0;
    addObject(&scene, ShapeKind::Rectangle, Affine{}, material);
    return scene;
}

std::vector<Vec3> render(const SceneDescription& scene, bool photons) {
    return photons ? renderSppm(scene, sppmParamsOf(scene), 8).image : renderPaths(scene, 0, 32);
}

double halfMean(const std::vector<Vec3>& image, bool left) {
    return blockMean(image, kSize, left ? 2 : kSize / 2 + 2, kSize / 4, kSize / 2 - 4);
}

class RoughnessTexture : public testing::TestWithParam<std::tuple<MaterialKind, bool>> {};

TEST_P(RoughnessTexture, OfTwoHalvesIsTwoPlates) {
    const auto [kind, photons] = GetParam();
    const std::vector<Vec3> textured = render(texturedPlate(kind), photons);
    const std::vector<Vec3> constant = render(twoPlates(kind, kSharp, kDull), photons);
    const std::vector<Vec3> swapped = render(twoPlates(kind, kDull, kSharp), photons);
    for (const bool left : {true, false}) {
        const double expected = halfMean(constant, left);
        EXPECT_NEAR(halfMean(textured, left), expected, 0.01 * expected);
        EXPECT_GT(std::fabs(halfMean(swapped, left) - expected), 0.03 * expected) << "else nothing is tested";
    }
}

INSTANTIATE_TEST_SUITE_P(All, RoughnessTexture,
                         testing::Combine(testing::Values(MaterialKind::Conductor, MaterialKind::Plastic,
                                                          MaterialKind::Principled),
                                          testing::Bool()));

}  // namespace
}  // namespace glint::test
