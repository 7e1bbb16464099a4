// Photon mapping on the command line: its options, its report, numbered pictures.
#include <nlohmann/json.hpp>

#include "tests/support/program_test.h"

namespace glint {
namespace {

using test::ProgramRun;
using test::runProgram;
using test::says;
using test::TempFolder;

using SppmCommand = test::ProgramTest;

const std::string kCaustic = GLINT_SOURCE_DIR "/scenes/cornell_glass_mirror.json";

TEST_F(SppmCommand, PhotonMappingTakesItsOptionsAndReports) {
    const std::string out = folder.path("a.exr");
    const ProgramRun run = runProgram(
        {"render",  kCaustic,       "-o",       out,         "--size",   "24x24",    "--passes",
         "5",       "--integrator", "sppm",     "--photons", "2000",     "--radius", "auto:6",
         "--alpha", "0.5",          "--direct", "photons",   "--lookup", "tree",     "--checkpoint-every",
         "2",       "--json",       "-"});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    const auto report = nlohmann::json::parse(run.out, nullptr, false);
    ASSERT_FALSE(report.is_discarded());
    EXPECT_EQ(report["integrator"], "sppm");
    EXPECT_EQ(report["passes"], 5);
    EXPECT_EQ(report["sppm"]["emitted_photons"], 10000);
    EXPECT_GT(report["relative_error"].get<double>(), 0.0);
    EXPECT_FALSE(TempFolder::read(folder.path("a-000002.exr")).empty());
    EXPECT_FALSE(TempFolder::read(folder.path("a-000004.exr")).empty());
    EXPECT_EQ(folder.size(), 3u);
}

TEST_F(SppmCommand, NumberedImagesChangeNothingAndGoOnAfterResuming) {
    const std::vector<std::string> common = {"render",       kCaustic, "--size",    "20x20",
                                             "--integrator", "sppm",   "--photons", "1500"};
    const auto render = [&](const std::string& out, std::vector<std::string> more) {
        std::vector<std::string> arguments = common;
        arguments.insert(arguments.end(), {"-o", folder.path(out)});
        arguments.insert(arguments.end(), more.begin(), more.end());
        const ProgramRun run = runProgram(arguments);
        EXPECT_EQ(run.exitCode, 0) << run.err;
        return TempFolder::read(folder.path(out));
    };
    const std::string plain = render("plain.png", {"--passes", "6"});
    EXPECT_EQ(render("often.png", {"--passes", "6", "--checkpoint-every", "1"}), plain);
    const std::string half = render("half.png", {"--passes", "3", "--checkpoint", folder.path("c")});
    EXPECT_EQ(TempFolder::read(folder.path("often-000003.png")), half);
    EXPECT_EQ(render("whole.png", {"--passes", "6", "--resume", folder.path("c"), "--checkpoint-every", "2"}),
              plain);
    EXPECT_EQ(TempFolder::read(folder.path("whole-000004.png")),
              TempFolder::read(folder.path("often-000004.png")));
}

TEST_F(SppmCommand, PhotonOptionsThatMakeNoSenseAreRefused) {
    const std::string out = folder.path("a.png");
    const auto refusal = [&](std::vector<std::string> options) {
        std::vector<std::string> arguments = {"render", kCaustic, "-o", out, "--size", "8x8"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const ProgramRun run = runProgram(arguments);
        EXPECT_EQ(run.exitCode, 1) << run.out;
        return run.err;
    };
    EXPECT_TRUE(says(refusal({"--photons", "1000"}), "add --integrator sppm"));
    EXPECT_TRUE(says(refusal({"--integrator", "sppm", "--alpha", "1"}), "between 0 and 1"));
    for (const char* radius : {"wide", "-1", "0", "auto:", "auto:0", "auto4", ":4", "nan", "1m"}) {
        EXPECT_TRUE(says(refusal({"--integrator", "sppm", "--radius", radius}), "auto:4")) << radius;
    }
    refusal({"--integrator", "photons"});
    refusal({"--integrator", "sppm", "--photons", "0"});
    refusal({"--integrator", "sppm", "--pixel", "1,1"});
    EXPECT_EQ(folder.size(), 0u);
}

TEST_F(SppmCommand, ASmallBudgetMeansFewerPhotonsAndSaysSo) {
    const ProgramRun run = runProgram({"render", kCaustic, "-o", folder.path("a.png"), "--size", "16x16",
                                       "--passes", "1", "--integrator", "sppm", "--memory", "1"});
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_TRUE(says(run.err, "photons a pass instead of 262144"));
}

TEST_F(SppmCommand, PathsThatPhotonsCannotCountAreCutOffAndItSaysSo) {
    const auto warning = [&](const char* depth, const char* integrator) {
        const ProgramRun run = runProgram({"render", kCaustic, "-o", folder.path("a.png"), "--size", "8x8",
                                           "--passes", "1", "--depth", depth, "--integrator", integrator});
        EXPECT_EQ(run.exitCode, 0) << run.err;
        return says(run.err, "256 scattering events along a path instead of 257");
    };
    EXPECT_TRUE(warning("257", "sppm"));
    EXPECT_FALSE(warning("256", "sppm"));
    EXPECT_FALSE(warning("257", "path"));
}

}  // namespace
}  // namespace glint
