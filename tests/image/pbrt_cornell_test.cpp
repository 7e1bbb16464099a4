// The grey Cornell box as a pbrt scene, beside pbrt's own picture of it (tests/data/references): the camera's
// handedness, lamps, depths and filters are all those of pbrt.
#include <cmath>

#include "engine/io/exr_io.h"
#include "tests/support/pbrt_test.h"
#include "tests/support/render_scene.h"

namespace glint::test {
namespace {

const std::string kBox = R"(LookAt 0 1 3.9  0 1 0  0 1 0
Camera "perspective" "float fov" 39
Film "rgb" "integer xresolution" 128 "integer yresolution" 128
PixelFilter "box" "float xradius" 0.5 "float yradius" 0.5
Integrator "path" "integer maxdepth" 10
WorldBegin
Material "diffuse" "rgb reflectance" [0.73 0.73 0.73]
Shape "trianglemesh" "point3 P" [-1 0 -1  1 0 -1  1 0 1  -1 0 1] "integer indices" [0 1 2 0 2 3]
Shape "bilinearmesh" "point3 P" [-1 2 -1  1 2 -1  -1 2 1  1 2 1]
Shape "bilinearmesh" "point3 P" [-1 0 -1  1 0 -1  -1 2 -1  1 2 -1]
AttributeBegin
Translate 0.4 0.4 0.3 Shape "sphere" "float radius" 0.4
Translate -0.8 0 -0.6 Shape "sphere" "float radius" 0.4
AttributeEnd
Material "diffuse" "rgb reflectance" [0.25 0.25 0.25]
Shape "bilinearmesh" "point3 P" [-1 0 -1  -1 2 -1  -1 0 1  -1 2 1]
Material "diffuse" "rgb reflectance" [0.5 0.5 0.5]
Shape "bilinearmesh" "point3 P" [1 0 -1  1 2 -1  1 0 1  1 2 1]
Material "diffuse" "rgb reflectance" [0 0 0]
AreaLightSource "diffuse" "rgb L" [15 15 15]
Translate 0 1.99 0 Rotate 90 1 0 0 Scale 0.25 0.25 0.25
Shape "bilinearmesh" "point3 P" [-1 -1 0  1 -1 0  -1 1 0  1 1 0]
)";

TEST(PbrtCornell, LooksAsInPbrt) {
    const TempFolder folder;
    auto scene = loadScene(folder.write("box.pbrt", kBox));
    ASSERT_TRUE(scene) << scene.error().format();
    EXPECT_THAT(scene->warnings, testing::IsEmpty());
    const auto first = loadExrColor(GLINT_SOURCE_DIR "/tests/data/references/grey_cornell_seed1.exr");
    const auto second = loadExrColor(GLINT_SOURCE_DIR "/tests/data/references/grey_cornell_seed2.exr");
    ASSERT_TRUE(first && second);
    const ImageF &a = first->color, &b = second->color;
    ASSERT_EQ(scene->resolution, (Resolution{a.width, a.height}));
    constexpr int kBlock = 16;
    const Film film = renderFilm(*scene, 64);
    for (int block = 0; block < a.width * a.height / (kBlock * kBlock); ++block) {
        const int x = block % (a.width / kBlock) * kBlock, y = block / (a.width / kBlock) * kBlock;
        double mean = 0.0, squares = 0.0;
        for (int k = 0; k < kBlock * kBlock; ++k) {
            const auto pixel = static_cast<size_t>((y + k / kBlock) * a.width + x + k % kBlock);
            const double va = static_cast<double>(a.rgb[3 * pixel + 1]),
                         vb = static_cast<double>(b.rgb[3 * pixel + 1]);
            mean += 0.5 * (va + vb) / (kBlock * kBlock);
            squares += 0.25 * (va - vb) * (va - vb);
        }
        const Estimate reference{mean, std::sqrt(squares) / (kBlock * kBlock)};
        const Estimate found = meanLuminance(film, x, y, x + kBlock, y + kBlock);
        // Half floats and pbrt's spectra leave up to a thousandth.
        EXPECT_TRUE(agree(found, reference, 2e-3))
            << x << "," << y << ": " << found.mean << ", pbrt has " << reference.mean;
    }
}

}  // namespace
}  // namespace glint::test
