// Mitsuba's environment maps of 8 bits: laid out anew as floats are.
#include "engine/io/image_io.h"
#include "tests/support/mitsuba_test.h"

namespace glint::test {
namespace {

using MitsubaEnvironment = MitsubaTest;

TEST_F(MitsubaEnvironment, MapsMayHaveEightBits) {
    ASSERT_TRUE(savePng(folder.path("sky.png"), {8, 4, std::vector<uint8_t>(96, 255)}));
    const SceneDescription scene =
        load("<emitter type='envmap'><string name='filename' value='sky.png'/></emitter>");
    ASSERT_EQ(scene.environment.image, 0);
    const SceneImage& map = scene.environmentImages.at(0);
    ASSERT_TRUE(map.isRead());
    EXPECT_NEAR(linearColors(map)->rgb.at(0), 1.0f, 1e-3f);
}

}  // namespace
}  // namespace glint::test
