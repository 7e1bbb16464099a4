// `glint beside`: two pictures of one scene at equal tone.
#include <gtest/gtest.h>

#include "engine/io/image_io.h"
#include "tests/support/program_test.h"

namespace glint {
namespace {

using test::ProgramRun;
using test::runProgram;
using test::says;

class BesideCommand : public test::ProgramTest {
  protected:
    std::string scene() {
        return folder.write("ball.txt",
                            "PerspectiveCamera { center 0 0 5 direction 0 0 -1 up 0 1 0 angle 40 "
                            "width 24 height 24 }\n"
                            "Background { color 0.4 0.4 0.4 }\n"
                            "Materials { numMaterials 1 Material { color 0.8 0.2 0.2 } }\n"
                            "Group { numObjects 1 Sphere { center 0 0 0 radius 1 } }\n");
    }
};

TEST_F(BesideCommand, FindsTheStopsBetweenThemAndShowsBothAlike) {
    const std::string published = folder.path("published.png"), out = folder.path("both.png");
    ASSERT_EQ(runProgram({"render", scene(), "-o", published, "--as-original", "--exposure", "-1", "--size",
                          "40x30", "--passes", "64"})
                  .exitCode,
              0);
    const ProgramRun run = runProgram({"beside", published, scene(), "-o", out});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    EXPECT_TRUE(says(run.out, "shown -1.00 stops brighter"));
    const auto image = loadImage8(out);
    ASSERT_TRUE(image) << image.error().format();
    ASSERT_EQ((*image)->width, 84);
    ASSERT_EQ((*image)->height, 30);
    const auto at = [&](int x, int y, int c) {
        return static_cast<int>((*image)->rgb[static_cast<size_t>(3 * (y * 84 + x) + c)]);
    };
    EXPECT_NEAR(at(0, 0, 0), 124, 2) << "0.2, sRGB-encoded";
    for (const int x : {0, 20, 39}) {
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(at(x, 15, c), at(x + 44, 15, c), 6) << x;
        }
    }
    EXPECT_GT(at(20, 15, 0), at(20, 15, 1) + 30) << "the ball is red on both sides";
}

TEST_F(BesideCommand, ReducesToMeansOfSquares) {
    const std::string picture = folder.path("stripes.png"), out = folder.path("both.png");
    Image8 stripes{40, 31, {}};
    for (int i = 0; i < 40 * 31; ++i) {
        stripes.rgb.insert(stripes.rgb.end(), 3, i % 2 == 0 ? uint8_t{102} : uint8_t{0});
    }
    ASSERT_TRUE(savePng(picture, stripes));
    ASSERT_EQ(runProgram({"beside", picture, scene(), "-o", out, "--reduce", "2", "--passes", "1"}).exitCode,
              0);
    const auto image = loadImage8(out);
    ASSERT_TRUE(image) << image.error().format();
    EXPECT_EQ((*image)->width, 44);
    EXPECT_EQ((*image)->height, 15);
    EXPECT_NEAR((*image)->rgb[0], 124, 1) << "0.2, sRGB-encoded";
    EXPECT_EQ(runProgram({"beside", picture, scene(), "-o", out, "--reduce", "40"}).exitCode, 1);
}

TEST_F(BesideCommand, RefusesWhatIsNoPictureAndKeepsItsInputs) {
    const std::string text = scene();
    EXPECT_TRUE(says(runProgram({"beside", text, text, "-o", folder.path("o.png")}).err, "is not an image"));
    const std::string picture = folder.path("p.png");
    ASSERT_TRUE(savePng(picture, {8, 8, std::vector<uint8_t>(192, 99)}));
    const ProgramRun run = runProgram({"beside", picture, text, "-o", picture});
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_TRUE(says(run.err, "is the picture, which is read"));
}

}  // namespace
}  // namespace glint
