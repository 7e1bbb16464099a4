// Roughness of general facets that is a texture.
#include <gtest/gtest.h>

#include "engine/builders/material_table.h"
#include "engine/builders/texture_table.h"
#include "engine/kernels/bsdf/bsdf.h"
#include "tests/support/bsdf_cases.h"

namespace glint::test {
namespace {

/// Without a roughness across, a texture is that in all directions.
TEST(TexturedFacets, AreAlikeInAllDirections) {
    auto image = std::make_shared<ImageF>();
    image->width = image->height = 1;
    image->rgb = {0.5f, 0.5f, 0.5f};
    SceneDescription scene;
    scene.textures.resize(1);
    scene.textures[0].image.floats = image;
    scene.objects.resize(1);
    scene.objects[0].material = 0;
    for (const MaterialKind kind : {MaterialKind::Conductor, MaterialKind::Ward}) {
        Material material;
        material.kind = kind;
        material.distribution = FacetDistribution::Beckmann;
        material.roughness = {0.1f, 0};
        scene.materials = {material};
        const auto textures = *buildTextureTable(scene, nullptr);
        const auto table = buildMaterialTable(scene, *textures, nullptr);
        ASSERT_TRUE(table) << table.error().message;
        SceneView view{};
        view.materials = viewOf((*table)->materials);
        view.textures = viewOf(textures->textures);
        const Bsdf<kAllFeatures> bsdf = makeBsdf<kAllFeatures>(view, TestSurface(), Vec3(0.0f, 0.0f, 1.0f));
        EXPECT_EQ(bsdf.inputs().roughness, 0.5f);
        EXPECT_EQ(bsdf.inputs().crossRoughness, 0.5f);
    }
}

}  // namespace
}  // namespace glint::test
