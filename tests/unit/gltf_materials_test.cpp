// glTF 2.0: what materials and their images become.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/atomic_file.h"
#include "engine/io/image_io.h"
#include "tests/support/gltf_test.h"

namespace glint {
namespace {

using test::base64;
using test::gltf;
using test::material;
using testing::Contains;
using testing::HasSubstr;

using Gltf = test::GltfTest;

TEST_F(Gltf, MaterialsBecomeTheNearestOfGlint) {
    const Material plain = only("");
    EXPECT_EQ(plain.kind, MaterialKind::Principled);
    EXPECT_EQ(plain.metallic.value, 1.0f) << "unless it is said";
    EXPECT_EQ(plain.clearcoat.value, 0.0f);
    EXPECT_EQ(plain.sheenColor.value, Vec3(0.0f));
    const Material plastic =
        only(R"("pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.25, 1, 1], "metallicFactor": 0,
        "roughnessFactor": 0.5}, "extensions": {"KHR_materials_ior": {"ior": 1.3}})");
    EXPECT_EQ(plastic.kind, MaterialKind::Principled);
    EXPECT_EQ(plastic.metallic.value, 0.0f);
    EXPECT_EQ(plastic.color.value, Vec3(0.5f, 0.25f, 1.0f));
    EXPECT_EQ(plastic.roughness.value, 0.25f);
    EXPECT_FLOAT_EQ(plastic.ior.value, 1.3f);
    const std::string passing = R"("pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": 0},
        "extensions": {"KHR_materials_transmission": {"transmissionFactor": 1})";
    EXPECT_EQ(only(passing + "}").kind, MaterialKind::Dielectric);
    EXPECT_TRUE(only(passing + "}").thin);
    EXPECT_FALSE(only(passing + R"(, "KHR_materials_volume": {"thicknessFactor": 0.1}})").thin);
    const Material lamp = only(R"("emissiveFactor": [1, 0.5, 0], "doubleSided": true,
        "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 20}})");
    EXPECT_EQ(lamp.emission.value, Vec3(1.0f, 0.5f, 0.0f));
    EXPECT_EQ(lamp.emissionStrength, 20.0f);
    EXPECT_TRUE(lamp.emitsBothSides);
    const Material older =
        only(R"("extensions": {"KHR_materials_pbrSpecularGlossiness": {"diffuseFactor": [0.5, 0.25, 1, 1],
        "glossinessFactor": 0.5}})");
    EXPECT_EQ(older.kind, MaterialKind::Principled);
    EXPECT_EQ(older.metallic.value, 0.0f);
    EXPECT_EQ(older.color.value, Vec3(0.5f, 0.25f, 1.0f));
    EXPECT_EQ(older.roughness.value, 0.25f);
    const Material unlit = only(R"("pbrMetallicRoughness": {"baseColorFactor": [0.2, 0.4, 0.6, 1]},
        "extensions": {"KHR_materials_unlit": {}})");
    EXPECT_EQ(unlit.emission.value, Vec3(0.2f, 0.4f, 0.6f));
    EXPECT_EQ(unlit.color.value, Vec3(0.0f));
    EXPECT_FALSE(unlit.alphaCutsOut) << "opaque whatever the image's alpha is";
    const Material veil =
        only(R"("alphaMode": "BLEND", "pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 0.25]})");
    EXPECT_TRUE(veil.alphaCutsOut);
    EXPECT_EQ(veil.opacity.value, 0.25f);
}

/// KHR_materials_specular, _clearcoat and _sheen, by their factors.
TEST_F(Gltf, LayersAreThoseOfTheExtensions) {
    const Material layered = only(R"("pbrMetallicRoughness": {"metallicFactor": 0.25}, "extensions": {
        "KHR_materials_specular": {"specularFactor": 0.5, "specularColorFactor": [1, 0.5, 0.25]},
        "KHR_materials_clearcoat": {"clearcoatFactor": 0.75, "clearcoatRoughnessFactor": 0.5},
        "KHR_materials_sheen": {"sheenColorFactor": [0.1, 0.2, 0.3], "sheenRoughnessFactor": 0.5}})");
    EXPECT_EQ(layered.kind, MaterialKind::Principled);
    EXPECT_EQ(layered.metallic.value, 0.25f);
    EXPECT_EQ(layered.specular.value, 0.5f);
    EXPECT_EQ(layered.specularTint.value, Vec3(1.0f, 0.5f, 0.25f));
    EXPECT_EQ(layered.clearcoat.value, 0.75f);
    EXPECT_EQ(layered.clearcoatRoughness.value, 0.25f) << "alpha is the square";
    EXPECT_EQ(layered.sheenColor.value, Vec3(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(layered.sheenRoughness.value, 0.25f);
}

TEST_F(Gltf, LayersHaveImages) {
    ASSERT_TRUE(savePng(folder.path("t.png"), {2, 1, {9, 51, 255, 9, 204, 0}, {255, 51}}));
    const SceneDescription scene = load(gltf(R"("materials": [{"extensions": {
        "KHR_materials_specular": {"specularFactor": 0.5, "specularTexture": {"index": 0}},
        "KHR_materials_clearcoat": {"clearcoatFactor": 1, "clearcoatTexture": {"index": 0},
        "clearcoatRoughnessFactor": 0.5, "clearcoatRoughnessTexture": {"index": 0}},
        "KHR_materials_sheen": {"sheenColorFactor": [0.5, 0.5, 0.5], "sheenColorTexture": {"index": 0}}},
        "pbrMetallicRoughness": {"metallicFactor": 0.5, "metallicRoughnessTexture": {"index": 0}}}],
        "textures": [{"source": 0}], "images": [{"uri": "t.png"}])"));
    const Material& material = scene.materials[0];
    const auto expectShown = [&](int index, TextureChannel channel, float gain, float exponent) {
        ASSERT_GE(index, 0);
        const Texture& texture = scene.textures.at(static_cast<size_t>(index));
        EXPECT_EQ(texture.channel, channel);
        EXPECT_EQ(texture.encoding, ColorEncoding::Linear);
        EXPECT_EQ(texture.gain, gain);
        EXPECT_EQ(texture.exponent, exponent);
    };
    expectShown(material.metallic.texture, TextureChannel::Blue, 0.5f, 1.0f);
    expectShown(material.specular.texture, TextureChannel::Alpha, 0.5f, 1.0f);
    expectShown(material.clearcoat.texture, TextureChannel::Red, 1.0f, 1.0f);
    expectShown(material.clearcoatRoughness.texture, TextureChannel::Green, 0.5f, 2.0f);
    ASSERT_GE(material.sheenColor.texture, 0);
    EXPECT_EQ(scene.textures.at(static_cast<size_t>(material.sheenColor.texture)).encoding,
              ColorEncoding::Srgb);
}

/// Metal, tints, layers and roughness of sheets are more than glass has.
TEST_F(Gltf, LightPassesInPart) {
    const auto passing = [&](const std::string& pbr, const std::string& more) {
        return only(R"("pbrMetallicRoughness": {)" + pbr +
                    R"(}, "extensions": {"KHR_materials_transmission": {)" + more);
    };
    const Material veil =
        passing(R"("metallicFactor": 0.5, "roughnessFactor": 0.5)", R"("transmissionFactor": 0.25}})");
    EXPECT_EQ(veil.kind, MaterialKind::Principled);
    EXPECT_EQ(veil.specularTransmission.value, 0.25f);
    EXPECT_EQ(veil.metallic.value, 0.5f);
    EXPECT_TRUE(veil.thin);
    EXPECT_FALSE(veil.rootTint);
    const Material bottle =
        passing(R"("metallicFactor": 0, "roughnessFactor": 0, "baseColorFactor": [0.5, 1, 0.5, 1])",
                R"("transmissionFactor": 1}, "KHR_materials_volume": {"thicknessFactor": 1,
                "attenuationDistance": 3, "attenuationColor": [0.25, 0.5, 0.75]}})");
    EXPECT_EQ(bottle.kind, MaterialKind::Principled) << "its reflection has no colour";
    EXPECT_EQ(bottle.specularTransmission.value, 1.0f);
    EXPECT_FALSE(bottle.thin);
    EXPECT_EQ(bottle.attenuationDistance, 3.0f);
    EXPECT_EQ(passing(R"("metallicFactor": 0, "roughnessFactor": 0.5)", R"("transmissionFactor": 1}})").kind,
              MaterialKind::Principled)
        << "a rough sheet";
    EXPECT_EQ(passing(R"("metallicFactor": 0, "roughnessFactor": 0.5)",
                      R"("transmissionFactor": 1}, "KHR_materials_volume": {"thicknessFactor": 1}})")
                  .kind,
              MaterialKind::Dielectric);
}

TEST_F(Gltf, VolumesAbsorbAndSheetsLetThrough) {
    const std::string volume = R"("extensions": {"KHR_materials_transmission": {"transmissionFactor": 1},
        "KHR_materials_volume": {"thicknessFactor": 0.2, "attenuationColor": [0.5, 0.25, 1])";
    const Material glass = only(volume + R"(, "attenuationDistance": 2}})");
    EXPECT_EQ(glass.attenuationColor, Vec3(0.5f, 0.25f, 1.0f));
    EXPECT_EQ(glass.attenuationDistance, 2.0f);
    EXPECT_EQ(only(volume + "}}").attenuationColor, Vec3(1.0f)) << "the distance is infinite by default";
    const Material sheet =
        only(R"("pbrMetallicRoughness": {"metallicFactor": 0, "baseColorFactor": [0.8, 0.4, 0.2, 1]},
        "extensions": {"KHR_materials_diffuse_transmission": {"diffuseTransmissionFactor": 0.25,
        "diffuseTransmissionColorFactor": [1, 0.5, 0]}})");
    EXPECT_EQ(sheet.kind, MaterialKind::Translucent);
    EXPECT_LT(glm::length(sheet.color.value - Vec3(0.6f, 0.3f, 0.15f)), 1e-6f);
    EXPECT_LT(glm::length(sheet.transmission.value - Vec3(0.25f, 0.125f, 0.0f)), 1e-6f);
}

TEST_F(Gltf, SheetsHaveImagesOfWhatTheyReflectAndPass) {
    ASSERT_TRUE(savePng(folder.path("t.png"), {1, 1, {255, 0, 0}}));
    const SceneDescription scene = load(gltf(R"("images": [{"uri": "t.png"}], "textures": [{"source": 0}],
        "materials": [{"pbrMetallicRoughness": {"metallicFactor": 0, "baseColorTexture": {"index": 0}},
        "extensions": {"KHR_materials_diffuse_transmission": {"diffuseTransmissionFactor": 0.25,
        "diffuseTransmissionColorFactor": [0.5, 0.5, 0.5], "diffuseTransmissionTexture": {"index": 0},
        "diffuseTransmissionColorTexture": {"index": 0}}}}])"));
    ASSERT_EQ(scene.materials.size(), 1u);
    const Material& sheet = scene.materials[0];
    EXPECT_EQ(sheet.kind, MaterialKind::Translucent);
    ASSERT_GE(sheet.color.texture, 0);
    ASSERT_GE(sheet.transmission.texture, 0);
    EXPECT_EQ(scene.textures[static_cast<size_t>(sheet.color.texture)].gain, 0.75f);
    EXPECT_EQ(scene.textures[static_cast<size_t>(sheet.transmission.texture)].gain, 0.125f);
    EXPECT_THAT(scene.warnings, Contains(HasSubstr("how much light a sheet lets pass are left out")));
}

TEST_F(Gltf, TexturesArePlacedAndMultiplied) {
    // The top half of the image is red.
    std::vector<uint8_t> rgb(3 * 4 * 4, 0);
    for (size_t i = 0; i < 8; ++i) {
        rgb[3 * i] = 255;
    }
    ASSERT_TRUE(savePng(folder.path("t.png"), {4, 4, rgb}));
    const std::string more =
        R"("images": [{"uri": "t.png"}], "samplers": [{"wrapS": 33071, "wrapT": 33648, "magFilter": 9728}],
        "textures": [{"source": 0, "sampler": 0}], "materials": [{"pbrMetallicRoughness": {"metallicFactor": 0,
        "baseColorFactor": [0.5, 1, 1, 1], "baseColorTexture": {"index": 0, "extensions": {"KHR_texture_transform":
        {"offset": [0.25, 0.5], "rotation": 1.5707963, "scale": [2, 3]}}}}}])";
    const SceneDescription scene = load(gltf(more));
    ASSERT_EQ(scene.textures.size(), 1u);
    const Texture& texture = scene.textures[0];
    EXPECT_TRUE(texture.flipV) << "v counts from the top row";
    EXPECT_EQ(texture.wrapU, WrapMode::Clamp);
    EXPECT_EQ(texture.wrapV, WrapMode::Mirror);
    EXPECT_EQ(texture.filter, TexelFilter::Nearest);
    EXPECT_EQ(texture.scale, Vec2(2, 3));
    EXPECT_EQ(texture.offset, Vec2(0.25f, 0.5f));
    EXPECT_NEAR(texture.rotationDeg, -90.0f, 1e-3f) << "counter-clockwise as seen with v running down";
    EXPECT_EQ(texture.encoding, ColorEncoding::Srgb);
    EXPECT_EQ(scene.meshes[0].data->colors[0], Vec3(0.5f, 1.0f, 1.0f)) << "the factor, on the vertices";
    // In a data URI, and in the buffer; a missing one is a warning.
    const std::string png = base64(readFile(folder.path("t.png")).value());
    std::string inside = more;
    inside.replace(inside.find("t.png"), 5, "data:image/png;base64," + png);
    EXPECT_TRUE(load(gltf(inside)).textures.at(0).image.isRead());
    std::string gone = more;
    gone.replace(gone.find("t.png"), 5, "gone.png");
    const SceneDescription without = load(gltf(gone));
    EXPECT_THAT(without.warnings, Contains(HasSubstr("images cannot be read")));
    EXPECT_EQ(without.materials[0].color.texture, -1);
}

TEST_F(Gltf, RoughnessIsTheImagesGreenTimesItsFactorSquared) {
    const std::string text = gltf(R"("materials": [{"pbrMetallicRoughness": {"roughnessFactor": 0.5,
        "metallicRoughnessTexture": {"index": 0}}}], "textures": [{"source": 0}], "images": [{"uri": "t.png"}])");
    ASSERT_TRUE(savePng(folder.path("t.png"), {2, 1, {9, 51, 255, 9, 204, 255}}));
    const SceneDescription scene = load(text);
    EXPECT_EQ(scene.materials[0].metallic.value, 1.0f);
    EXPECT_EQ(scene.materials[0].metallic.texture, -1) << "metal everywhere";
    ASSERT_GE(scene.materials[0].roughness.texture, 0);
    const Texture& map = scene.textures[static_cast<size_t>(scene.materials[0].roughness.texture)];
    EXPECT_EQ(map.encoding, ColorEncoding::Linear);
    EXPECT_EQ(map.channel, TextureChannel::Green);
    EXPECT_EQ(map.gain, 0.5f);
    EXPECT_EQ(map.exponent, 2.0f);
    EXPECT_EQ(map.base, 0.0f);
    EXPECT_FALSE(scene.meshes[0].data->uvs.empty());
    ASSERT_TRUE(savePng(folder.path("t.png"), {2, 1, {9, 51, 255, 9, 51, 255}}));
    const SceneDescription even = load(text);
    EXPECT_EQ(even.materials[0].roughness.texture, -1) << "one roughness needs no image";
    EXPECT_NEAR(even.materials[0].roughness.value, 0.01f, 1e-6f);
}

TEST_F(Gltf, MasksHaveALimit) {
    ASSERT_TRUE(savePng(folder.path("t.png"), {1, 1, {9, 9, 9}, {100}}));
    const SceneDescription scene = load(gltf(R"("materials": [{"alphaMode": "MASK", "alphaCutoff": 0.25,
        "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, "baseColorFactor": [1, 1, 1, 0.5]}}],
        "textures": [{"source": 0}], "images": [{"uri": "t.png"}])"));
    const Material& material = scene.materials[0];
    EXPECT_FALSE(material.alphaCutsOut);
    ASSERT_GE(material.opacity.texture, 0);
    const Texture& mask = scene.textures[static_cast<size_t>(material.opacity.texture)];
    EXPECT_EQ(mask.channel, TextureChannel::Alpha);
    // Half of it: an alpha of 0.5 has the limit's.
    EXPECT_LT(mask.base + mask.gain * 0.49f, 0.0f);
    EXPECT_GT(mask.base + mask.gain * 0.51f, 1.0f);
}

TEST_F(Gltf, WhatGlintDoesNotDrawIsSaidOnceOfEachKind) {
    const SceneDescription scene = load(gltf(R"("materials": [{"name": "a", "alphaMode": "MASK",
        "extensions": {"KHR_materials_dispersion": {}}}],
        "animations": [{"channels": [], "samplers": []}])"));
    EXPECT_THAT(scene.warnings,
                Contains(HasSubstr("extensions of materials are left out: \"KHR_materials_dispersion\"")));
    EXPECT_THAT(scene.warnings, Contains(HasSubstr("animations are left out")));
    EXPECT_FALSE(loadScene(scene.path, {.strict = true}));
}

/// Basis alone is left out, where the file does not need it; WebP counts in every place.
TEST_F(Gltf, TexturesWithoutAnImageAreLeftOut) {
    const SceneDescription basis = load(gltf(
        R"("images": [{"uri": "a.ktx2"}], "textures": [{"extensions": {"KHR_texture_basisu": {"source": 0}}}], )" +
        material(
            R"("pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 1], "baseColorTexture": {"index": 0},
            "metallicRoughnessTexture": {"index": 0}})")));
    EXPECT_THAT(basis.warnings, ElementsAre(HasSubstr("textures without an image that Glint reads")));
    EXPECT_EQ(basis.materials.at(0).color, ColorInput{Vec3(1, 0, 0)});
    folder.write("rough.webp", "no picture");
    const SceneDescription webp = load(gltf(
        R"("images": [{"uri": "rough.webp"}], "textures": [{"extensions": {"EXT_texture_webp": {"source": 0}}}], )" +
        material(R"("pbrMetallicRoughness": {"metallicRoughnessTexture": {"index": 0}})")));
    EXPECT_THAT(webp.warnings, ElementsAre(HasSubstr("images of roughness or metalness cannot be read")));
}

}  // namespace
}  // namespace glint
