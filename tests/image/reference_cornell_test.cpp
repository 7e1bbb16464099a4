// A grey Cornell box beside another renderer's picture of it (tests/data/references): block means agree
// within the noise of both. The significance is 1e-6 a block; the reference's noise comes from the difference
// of its two seeds.

#include <gtest/gtest.h>

#include "engine/io/exr_io.h"
#include "tests/support/light_scene.h"
#include "tests/support/render_scene.h"

namespace glint {
namespace {

constexpr int kSize = 128;
constexpr int kBlock = 16;

/// pbrt's camera is left-handed: its +x is the picture's left, so x is mirrored here.
SceneDescription greyCornell() {
    SceneDescription scene = emptyScene({0, 1, 3.9f}, {0, 1, 0}, 39, kSize);
    const auto wall = [&](const Vec3& center, const Vec3& normal, float albedo) {
        addObject(&scene, ShapeKind::Rectangle, placeFlatShape(center, normal, 1, 1),
                  diffuseMaterial(albedo));
    };
    wall({0, 0, 0}, {0, 1, 0}, 0.73f);
    wall({0, 2, 0}, {0, -1, 0}, 0.73f);
    wall({0, 1, -1}, {0, 0, 1}, 0.73f);
    wall({1, 1, 0}, {-1, 0, 0}, 0.25f);
    wall({-1, 1, 0}, {1, 0, 0}, 0.5f);
    addObject(&scene, ShapeKind::Rectangle, placeFlatShape({0, 1.99f, 0}, {0, -1, 0}, 0.25f, 0.25f),
              emissiveMaterial(Vec3(15.0f), false));
    for (const Vec3& center : {Vec3(-0.4f, 0.4f, 0.3f), Vec3(0.4f, 0.4f, -0.3f)}) {
        addObject(&scene, ShapeKind::Sphere, translate(center) * scale(Vec3(0.4f)), diffuseMaterial(0.73f));
    }
    scene.options.maxDepth = 10;
    return scene;
}

TEST(Reference, GreyCornellBox) {
    const auto first = loadExrColor(GLINT_SOURCE_DIR "/tests/data/references/grey_cornell_seed1.exr");
    const auto second = loadExrColor(GLINT_SOURCE_DIR "/tests/data/references/grey_cornell_seed2.exr");
    ASSERT_TRUE(first && second);
    const ImageF* a = &first->color;
    const ImageF* b = &second->color;
    ASSERT_EQ(a->width, kSize);
    ASSERT_EQ(a->height, kSize);
    const Film film = test::renderFilm(greyCornell(), 64);
    for (int y = 0; y < kSize; y += kBlock) {
        for (int x = 0; x < kSize; x += kBlock) {
            double mean = 0.0, squares = 0.0;
            for (int k = 0; k < kBlock * kBlock; ++k) {
                const auto pixel = static_cast<size_t>((y + k / kBlock) * kSize + x + k % kBlock);
                const double va = static_cast<double>(a->rgb[3 * pixel + 1]),
                             vb = static_cast<double>(b->rgb[3 * pixel + 1]);
                mean += 0.5 * (va + vb);
                squares += 0.25 * (va - vb) * (va - vb);
            }
            constexpr double kCount = kBlock * kBlock;
            const test::Estimate reference{mean / kCount, std::sqrt(squares) / kCount};
            const test::Estimate found = test::meanLuminance(film, x, y, x + kBlock, y + kBlock);
            // Half floats and the other renderer's spectra leave up to a thousandth.
            EXPECT_TRUE(test::agree(found, reference, 2e-3))
                << "block " << x << "," << y << ": " << found.mean << " +- " << found.standardError
                << ", reference " << reference.mean << " +- " << reference.standardError;
        }
    }
}

}  // namespace
}  // namespace glint
