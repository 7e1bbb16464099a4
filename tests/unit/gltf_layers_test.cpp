// Principled materials written as glTF and opened again.
#include <gmock/gmock.h>

#include "engine/io/gltf_images.h"
#include "tests/support/gltf_export_test.h"

namespace glint::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class GltfLayers : public GltfExportTest {
  protected:
    static Material paintOf() {
        Material paint;
        paint.kind = MaterialKind::Principled;
        paint.color.value = {0.75f, 0.25f, 0.125f};
        paint.metallic.value = 0.5f;
        paint.roughness.value = 0.25f;
        paint.ior.value = 1.25f;
        paint.specular.value = 0.5f;
        paint.specularTint.value = {1.0f, 0.5f, 0.25f};
        paint.clearcoat.value = 0.75f;
        paint.clearcoatRoughness.value = 0.0625f;
        paint.sheenColor.value = {0.5f, 0.25f, 0.0f};
        paint.sheenRoughness.value = 0.5625f;
        return paint;
    }
};

TEST_F(GltfLayers, LayersKeepTheirInputs) {
    SceneDescription scene = square();
    const Material paint = paintOf();
    scene.materials[0] = paint;
    const Material opened = exported(scene).materials.at(0);
    EXPECT_THAT(warnings, IsEmpty());
    EXPECT_EQ(opened.kind, MaterialKind::Principled);
    EXPECT_EQ(opened.color, paint.color);
    forEachModelInput(
        [](const InputInfo& info, const auto& now, const auto& before) {
            if ((info.kinds & kindBit(MaterialKind::Principled)) != 0) { EXPECT_EQ(now, before) << info.key; }
        },
        opened, paint);
}

TEST_F(GltfLayers, RoughnessAndMetalnessAreOnePicture) {
    SceneDescription scene = square();
    Material& paint = scene.materials[0] = paintOf();
    const Image8 image{2, 1, {0, 100, 255, 0, 200, 51}, {}};
    paint.metallic.texture = addTexture(&scene, image, ColorEncoding::Linear, TextureChannel::Blue);
    paint.roughness.texture = addTexture(&scene, image, ColorEncoding::Linear, TextureChannel::Green);
    scene.textures.back().exponent = 2.0f;
    const SceneDescription textured = exported(scene);
    EXPECT_THAT(warnings, IsEmpty());
    const Texture& metal = textured.textures.at(static_cast<size_t>(textured.materials[0].metallic.texture));
    EXPECT_EQ(metal.channel, TextureChannel::Blue);
    ASSERT_TRUE(metal.image.bytes);
    EXPECT_THAT(metal.image.bytes->rgb, ElementsAre(255, 100, 255, 255, 200, 51));
    EXPECT_EQ(textured.textures.at(static_cast<size_t>(textured.materials[0].roughness.texture)).exponent,
              2.0f);
}

/// Shares are multiplied by the factor, roughness is squared behind it, each by the channel that glTF has
/// it in.
TEST_F(GltfLayers, PicturesOfLayersAreKept) {
    SceneDescription scene = square();
    Material& paint = scene.materials[0] = paintOf();
    const Image8 image{2, 1, {0, 100, 255, 40, 200, 51}, {}};
    const auto add = [&](TextureChannel channel, float gain, float exponent) {
        const int index = addTexture(&scene, image, ColorEncoding::Linear, channel);
        scene.textures.back().gain = gain;
        scene.textures.back().exponent = exponent;
        return index;
    };
    paint.specular.texture = add(TextureChannel::Green, 0.5f, 1.0f);
    paint.clearcoat.texture = add(TextureChannel::Blue, 0.75f, 1.0f);
    paint.clearcoatRoughness.texture = add(TextureChannel::Green, 0.5f, 2.0f);
    paint.sheenRoughness.texture = add(TextureChannel::Red, 1.0f, 1.0f);
    paint.specularTint.texture = addTexture(&scene, image, ColorEncoding::Srgb);
    paint.sheenColor.texture = addTexture(&scene, image, ColorEncoding::Srgb);
    const SceneDescription opened = exported(scene);
    EXPECT_THAT(warnings, IsEmpty());
    ASSERT_EQ(opened.materials.size(), 1u);
    int compared = 0;
    forEachModelInput(
        [&](const InputInfo& info, const auto& now, const auto& before) {
            if (before.texture < 0) { return; }
            ASSERT_GE(now.texture, 0) << info.key;
            const Texture &after = opened.textures[static_cast<size_t>(now.texture)],
                          &from = scene.textures[static_cast<size_t>(before.texture)];
            ++compared;
            for (size_t pixel = 0; pixel < 2; ++pixel) {
                if constexpr (std::is_same_v<std::decay_t<decltype(now)>, NumberInput>) {
                    EXPECT_NEAR(shownNumber(after, pixel), shownNumber(from, pixel), 3e-3f) << info.key;
                } else {
                    for (size_t c = 0; c < 3; ++c) {
                        EXPECT_EQ(after.image.bytes->rgb[3 * pixel + c], image.rgb[3 * pixel + c])
                            << info.key;
                    }
                }
            }
        },
        opened.materials[0], scene.materials[0]);
    EXPECT_EQ(compared, 6);
    const Texture& share = opened.textures[static_cast<size_t>(opened.materials[0].clearcoat.texture)];
    EXPECT_FLOAT_EQ(share.gain, 0.75f) << "its factor";
}

/// A film of no thickness changes nothing; one of a quarter wave of green whose index is the root of glass'
/// reflects none of it, and more of red and blue.
TEST_F(GltfLayers, IridescenceIsTheColourOfItsFilm) {
    const auto filmed = [this](const std::string& base, const std::string& film) {
        const SceneDescription scene = load(gltf(material(
            "\"pbrMetallicRoughness\": {" + base +
            "}, \"extensions\": {\"KHR_materials_iridescence\": {\"iridescenceFactor\": 1, " + film + "}}")));
        EXPECT_THAT(scene.warnings, testing::Contains(testing::HasSubstr("approximated: iridescence")));
        return scene.materials.at(0);
    };
    const Material thin = filmed("\"metallicFactor\": 0", "\"iridescenceThicknessMaximum\": 0");
    EXPECT_NEAR(thin.ior.value, 1.5f, 2e-3f);
    EXPECT_GT(minComponent(thin.specularTint.value), 0.99f);
    const Material quarter = filmed("\"metallicFactor\": 0",
                                    "\"iridescenceIor\": 1.224745, \"iridescenceThicknessMaximum\": 112.27");
    EXPECT_LT(quarter.ior.value, 1.2f);
    EXPECT_LT(quarter.specularTint.value.y, 0.2f * quarter.specularTint.value.z);
    EXPECT_LT(quarter.specularTint.value.y, 0.5f * quarter.specularTint.value.x);
    const Material metal = filmed(R"("baseColorFactor": [0.9, 0.9, 0.9, 1])",
                                  "\"iridescenceIor\": 1.8, \"iridescenceThicknessMaximum\": 300");
    EXPECT_GT(maxComponent(metal.color.value) - minComponent(metal.color.value), 0.02f);
    EXPECT_EQ(metal.ior.value, 1.5f);
}

}  // namespace
}  // namespace glint::test
