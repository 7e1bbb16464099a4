// `glint render` interrupted, and resumed from its checkpoint.
#include <nlohmann/json.hpp>

#include "tests/support/program_test.h"

namespace glint {
namespace {

using test::ProgramRun;
using test::runProgram;
using test::says;
using test::TempFolder;

using ResumeCommand = test::ProgramTest;

const std::string kCornell = GLINT_SOURCE_DIR "/scenes/cornell.json";

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

TEST_F(ResumeCommand, InterruptedRendersSaveAndGoOnBitForBit) {
    const std::string film = folder.path("a.film"), image = folder.path("a.hdr"),
                      whole = folder.path("whole.hdr");
    const std::vector<std::string> settings = {"--size", "96x96"};
    const auto render = [&](std::vector<std::string> more, const std::string& interrupt = {}) {
        std::vector<std::string> all = {"render", kCornell};
        all.insert(all.end(), settings.begin(), settings.end());
        all.insert(all.end(), more.begin(), more.end());
        return runProgram(all, {.signalAfter = interrupt});
    };
    const ProgramRun stopped =
        render({"-o", image, "--time", "100000", "--passes", "100000", "--checkpoint", film, "--json", "-"},
               "pass ");
    ASSERT_EQ(stopped.exitCode, 130) << stopped.err;
    EXPECT_FALSE(TempFolder::read(image).empty());
    const auto report = nlohmann::json::parse(stopped.out, nullptr, false);
    ASSERT_FALSE(report.is_discarded());
    const int more = report["passes"].get<int>() + 3;
    const std::string passes = std::to_string(more);
    const ProgramRun resumed = render({"-o", image, "--resume", film, "--passes", passes});
    ASSERT_EQ(resumed.exitCode, 0) << resumed.err;
    ASSERT_EQ(render({"-o", whole, "--passes", passes}).exitCode, 0);
    EXPECT_EQ(TempFolder::read(image), TempFolder::read(whole));
}

TEST_F(ResumeCommand, ResumingWithOtherSettingsNamesTheDifference) {
    const std::string film = folder.path("a.film"), image = folder.path("a.png");
    ASSERT_EQ(runProgram(
                  {"render", kCornell, "-o", image, "--size", "16x16", "--passes", "2", "--checkpoint", film})
                  .exitCode,
              0);
    const ProgramRun other = runProgram({"render", kCornell, "-o", image, "--size", "16x16", "--passes", "4",
                                         "--depth", "3", "--resume", film});
    EXPECT_EQ(other.exitCode, 1);
    EXPECT_TRUE(says(other.err, "maxDepth"));
}

}  // namespace
}  // namespace glint
