// `glint render --white-balance`, `--tint` and `--dither`: PNGs alone change, and only where they are
// asked for.
#include <cstdlib>

#include <gtest/gtest.h>

#include "engine/io/image_io.h"
#include "tests/support/program_test.h"

namespace glint {
namespace {

using test::ProgramRun;
using test::runProgram;
using test::says;
using test::TempFolder;

class LookCommand : public test::ProgramTest {
  protected:
    std::string render(const std::string& name, const std::vector<std::string>& more) {
        std::vector<std::string> words{"render",   GLINT_SOURCE_DIR "/scenes/cornell.json",
                                       "-o",       folder.path(name),
                                       "--size",   "48x36",
                                       "--passes", "2"};
        words.insert(words.end(), more.begin(), more.end());
        const ProgramRun run = runProgram(words);
        EXPECT_EQ(run.exitCode, 0) << run.err;
        return folder.path(name);
    }
};

TEST_F(LookCommand, NeutralKeepsEveryBitAndOthersDoNot) {
    const std::string plain = TempFolder::read(render("plain.png", {}));
    EXPECT_EQ(TempFolder::read(render("neutral.png", {"--white-balance", "6504", "--tint", "0"})), plain);
    const auto before = loadImage8(folder.path("plain.png"));
    const auto warm = loadImage8(render("warm.png", {"--white-balance", "3500"}));
    const auto dithered = loadImage8(render("dithered.png", {"--dither"}));
    ASSERT_TRUE(before && warm && dithered);
    double red = 0.0, blue = 0.0;
    size_t changed = 0;
    for (size_t i = 0; i < (*before)->rgb.size(); ++i) {
        const int miss = (*dithered)->rgb[i] - (*before)->rgb[i];
        EXPECT_LE(std::abs(miss), 1);
        changed += miss != 0 ? 1 : 0;
        (i % 3 == 0 ? red : blue) += i % 3 == 1 ? 0.0 : (*warm)->rgb[i] - (*before)->rgb[i];
    }
    EXPECT_GT(changed, (*before)->rgb.size() / 20);
    EXPECT_LT(red, 0.0) << "what is lit by a warm light loses red";
    EXPECT_GT(blue, 0.0);
    const ProgramRun refused = runProgram({"render", GLINT_SOURCE_DIR "/scenes/cornell.json", "-o",
                                           folder.path("x.png"), "--white-balance", "500"});
    EXPECT_EQ(refused.exitCode, 1);
    EXPECT_TRUE(says(refused.err, "--white-balance"));
}

}  // namespace
}  // namespace glint
