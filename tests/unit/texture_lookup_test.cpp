// What exporters see of a texture is what kernels show.
#include "engine/io/texture_lookup.h"

#include <gtest/gtest.h>

#include "engine/builders/texture_table.h"
#include "engine/kernels/texture.h"
#include "engine/scene/scene_building.h"
#include "tests/support/test_scenes.h"
#include "tests/support/uniform_numbers.h"

namespace glint::test {
namespace {

TEST(TextureLookup, ShowsWhatKernelsShow) {
    UniformNumbers random(2);
    for (int i = 0; i < 48; ++i) {
        Texture texture;
        texture.image = checkerImage(5, 3, i % 2 == 0);
        texture.encoding = i % 3 == 0 ? ColorEncoding::Linear : ColorEncoding::Srgb;
        texture.flipV = i % 5 == 0;
        texture.filter = i % 4 == 1 ? TexelFilter::Nearest : TexelFilter::Bilinear;
        texture.wrapU = static_cast<WrapMode>(i % 3);
        texture.wrapV = static_cast<WrapMode>(i / 3 % 3);
        if (i % 4 >= 2) {
            texture.scale = {-1.0f, 2.0f};
            texture.offset = {1.0f, 0.3f};
            texture.rotationDeg = 30.0f;
            texture.base = 0.2f;
            texture.gain = 0.7f;
            texture.exponent = 2.0f;
        }
        SceneDescription scene = emptyScene(Vec3(0.0f), Vec3(0, 0, -1), 40.0f, 8);
        scene.textures.push_back(texture);
        Material material = diffuseMaterial(0.5f);
        material.color.texture = 0;
        addObject(&scene, ShapeKind::Sphere, Affine(), material);
        const auto table = buildTextureTable(scene, nullptr);
        ASSERT_TRUE(table);
        const TextureLookup lookup(texture);
        for (int k = 0; k < 100; ++k) {
            const Vec2 uv = 3.0f * random.next2() - Vec2(1.0f);
            const Vec3 shown = sampleTexture((*table)->textures[0], uv), seen = lookup.at(uv);
            EXPECT_LT(glm::length(shown - seen), 1e-3f) << i << ": " << uv.x << ' ' << uv.y;
        }
    }
}

}  // namespace
}  // namespace glint::test
