// `glint render --resume` of scenes with parameters.
#include "tests/support/program_test.h"

namespace glint {
namespace {

using test::ProgramRun;
using test::runProgram;
using test::says;
using test::TempFolder;

using ResumeCommand = test::ProgramTest;

TEST_F(ResumeCommand, ResumingKeepsTheParametersOfTheScene) {
    const std::string scene =
        folder.write("a.xml", R"(<scene version="3.0.0"><default name="grey" value="0.1"/>
<shape type="sphere"><bsdf type="diffuse"><rgb name="reflectance" value="$grey"/></bsdf></shape>
<emitter type="constant"/></scene>)");
    const std::string film = folder.path("a.film"), resumed = folder.path("a.hdr"),
                      whole = folder.path("b.hdr");
    const auto render = [&](const std::string& image, std::vector<std::string> more) {
        std::vector<std::string> all = {"--verbose", "render", scene, "-o", image, "--size", "16x16"};
        all.insert(all.end(), more.begin(), more.end());
        const ProgramRun run = runProgram(all);
        EXPECT_EQ(run.exitCode, 0) << run.err;
        return run;
    };
    render(resumed, {"-D", "grey=0.8", "--passes", "2", "--checkpoint", film});
    EXPECT_TRUE(says(render(resumed, {"--resume", film, "--passes", "5"}).err, "-D grey=0.8"));
    render(whole, {"-D", "grey=0.8", "--passes", "5"});
    EXPECT_EQ(TempFolder::read(resumed), TempFolder::read(whole));
    const ProgramRun other =
        runProgram({"render", scene, "-o", resumed, "--size", "16x16", "--resume", film, "-D", "grey=0.7"});
    EXPECT_EQ(other.exitCode, 1) << "what is given counts";
    EXPECT_TRUE(says(other.err, "the materials differ"));
}

}  // namespace
}  // namespace glint
