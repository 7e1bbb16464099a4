// Where the system starts fewer threads than were asked for, a render goes on with those, and is the same;
// what takes much memory is said.
#include <algorithm>

#include <sys/resource.h>

#include "tests/support/program_test.h"

namespace glint {
namespace {

using test::ProgramRun;
using test::runProgram;
using test::says;
using test::TempFolder;

class ScarceResources : public test::ProgramTest {
  protected:
    void SetUp() override {
        ProgramTest::SetUp();
#if defined(__SANITIZE_ADDRESS__) || GLINT_THREAD_SANITIZER
        GTEST_SKIP() << "sanitizers take terabytes of addresses";
#endif
    }
};

/// Room for some threads only, each of which takes a gigabyte for its stack.
void limitThreads(rlim_t gigabytes) {
    const rlimit stack{rlim_t{1} << 30, rlim_t{1} << 30};
    const rlimit memory{gigabytes << 30, gigabytes << 30};
    setrlimit(RLIMIT_STACK, &stack);
    setrlimit(RLIMIT_AS, &memory);
}

TEST_F(ScarceResources, ARenderIsTheSame) {
    const std::string scene = folder.write("a.json", R"({ "glint": 1, "resolution": [64, 64],
        "camera": { "position": [0, 0, 4], "target": [0, 0, 0] },
        "materials": { "grey": { "type": "diffuse", "color": 0.5 } },
        "objects": [{ "type": "sphere", "material": "grey", "center": [0, 0, 0], "radius": 1 }],
        "environment": { "color": 1 } })");
    for (const char* integrator : {"pt", "sppm"}) {
        const auto render = [&](const char* name, const char* threads, const test::RunSetup& setup) {
            return runProgram(
                {"render", scene, "-o", folder.path(name), "--checkpoint", folder.path("a.film"),
                 "--overwrite", "--passes", "2", "--threads", threads, "--integrator", integrator},
                setup);
        };
        ASSERT_EQ(render("all.png", "2", {}).exitCode, 0);
        const std::string image = TempFolder::read(folder.path("all.png"));
        for (const rlim_t gigabytes : {4, 5, 6, 9}) {
            const ProgramRun run = render("few.png", "24", {.before = [=] { limitThreads(gigabytes); }});
            EXPECT_EQ(run.exitCode, 0) << integrator << gigabytes << run.err;
            EXPECT_TRUE(says(run.err, "of 24 threads start; memory or their number is limited"));
            EXPECT_EQ(TempFolder::read(folder.path("few.png")), image) << integrator << gigabytes;
        }
    }
    const ProgramRun none = runProgram({"render", scene, "-o", folder.path("no.png"), "--passes", "2"},
                                       {.before = [] { limitThreads(1); }});
    EXPECT_EQ(none.exitCode, 2) << none.err;
    EXPECT_TRUE(says(none.err, "no thread starts; memory or their number is limited"));
}

/// An RGBE picture of one colour, packed by run lengths: four channels a row.
std::string packedSky(int width, int height) {
    std::string row{2, 2, static_cast<char>(width / 256), static_cast<char>(width % 256)};
    for (int channel = 0; channel < 4; ++channel) {
        for (int done = 0; done < width; done += 127) {
            row += static_cast<char>(128 + std::min(127, width - done));
            row += static_cast<char>(128);
        }
    }
    std::string out = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(height) + " +X " +
                      std::to_string(width) + "\n";
    for (int y = 0; y < height; ++y) {
        out += row;
    }
    return out;
}

/// 1027 MiB of numbers in 4 MB of bytes, where there is room for 1024.
TEST_F(ScarceResources, ALargeEnvironmentIsSaidBeforeItIsMade) {
    folder.write("sky.hdr", packedSky(11600, 5800));
    const std::string scene = folder.write("sky.json", R"({ "glint": 1, "resolution": [8, 8],
        "camera": { "position": [0, 0, 4], "target": [0, 0, 0] },
        "environment": { "image": { "file": "sky.hdr" } } })");
    const ProgramRun run =
        runProgram({"render", scene, "-o", folder.path("a.png"), "--passes", "1"}, {.before = [] {
                       const rlimit limit{rlim_t{1} << 30, rlim_t{1} << 30};
                       setrlimit(RLIMIT_AS, &limit);
                   }});
    EXPECT_EQ(run.exitCode, 2) << run.err;
    EXPECT_TRUE(says(run.err, "the environment's image has 11600x5800 pixels, which take 1.1 GB of memory"));
}

}  // namespace
}  // namespace glint
