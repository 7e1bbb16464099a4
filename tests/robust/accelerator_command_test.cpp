// Acceleration structures and ray casting on the command line.
#include "tests/support/program_test.h"

namespace glint {
namespace {

using test::ProgramRun;
using test::runProgram;
using test::says;
using test::TempFolder;

using AcceleratorCommand = test::ProgramTest;

const std::string kScene = GLINT_SOURCE_DIR "/scenes/furnace.json";

TEST_F(AcceleratorCommand, EveryKindRendersTheSamePicture) {
    const auto pictureBy = [&](const std::string& kind) {
        const std::string out = folder.path(kind + ".hdr");
        const ProgramRun run = runProgram({"render", kScene, "-o", out, "--size", "40x30", "--passes", "2",
                                           "--integrator", "rc", "--accelerator", kind});
        EXPECT_EQ(run.exitCode, 0) << run.err;
        return TempFolder::read(out);
    };
    const std::string expected = pictureBy("bvh");
    for (const char* kind : {"kdtree", "aabb", "none"}) {
        EXPECT_EQ(pictureBy(kind), expected) << kind;
    }
    const ProgramRun wrong =
        runProgram({"render", kScene, "-o", folder.path("a.png"), "--accelerator", "tree"});
    EXPECT_EQ(wrong.exitCode, 1);
    EXPECT_TRUE(says(wrong.err, "bvh, kdtree, aabb or none"));
}

TEST_F(AcceleratorCommand, TestedBoxesAndTrianglesAreLayers) {
    const std::string out = folder.path("a.exr");
    const ProgramRun run = runProgram({"render", kScene, "-o", out, "--size", "16x16", "--passes", "1",
                                       "--aov", "boxes-tested,triangles-tested"});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    EXPECT_TRUE(says(TempFolder::read(out), "boxesTested.Y"));
    EXPECT_TRUE(says(TempFolder::read(out), "trianglesTested.Y"));
}

TEST_F(AcceleratorCommand, PhongsSettingsNeedRayCasting) {
    const std::vector<std::string> render = {"render", kScene,  "-o",       folder.path("a.png"),
                                             "--size", "16x16", "--passes", "1"};
    const auto with = [&](std::vector<std::string> more) {
        std::vector<std::string> all = render;
        all.insert(all.end(), more.begin(), more.end());
        return runProgram(all);
    };
    const ProgramRun alone = with({"--phong-shadows", "off"});
    EXPECT_EQ(alone.exitCode, 1);
    EXPECT_TRUE(says(
        alone.err, "--phong-shadows, --phong-falloff are settings of Ray casting; add --integrator raycast"));
    EXPECT_EQ(with({"--integrator", "raycast", "--phong-shadows", "maybe"}).exitCode, 1);
    EXPECT_EQ(with({"--integrator", "raycast", "--phong-shadows", "off"}).exitCode, 0);
    EXPECT_EQ(with({"--integrator", "raycast", "--photons", "10"}).exitCode, 1);
}

}  // namespace
}  // namespace glint
