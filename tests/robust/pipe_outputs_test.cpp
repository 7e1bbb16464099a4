// Pipes as outputs: by their names they are refused before anything is rendered, since opening one waits for
// a reader; those that the program was started with are written to.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/support/program_test.h"

namespace glint {
namespace {

using test::ProgramRun;
using test::runProgram;
using test::says;

class PipeOutputs : public test::ProgramTest {
  protected:
    void SetUp() override {
        ProgramTest::SetUp();
        scene = folder.write("a.json", R"({ "glint": 1, "resolution": [8, 8],
            "camera": { "position": [0, 0, 4], "target": [0, 0, 0] }, "environment": { "color": 1 } })");
        const ProgramRun run = runProgram({"render", scene, "-o", at("p.png"), "--passes", "1"});
        ASSERT_EQ(run.exitCode, 0) << run.err;
    }
    /// Open at both ends, so that a program that writes to it does not wait.
    int makePipe(const std::string& path) const {
        EXPECT_EQ(mkfifo(path.c_str(), 0600), 0) << path;
        return open(path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
    }
    void expectRefused(const std::string& name, std::vector<std::string> words) const {
        const int pipe = makePipe(at(name));
        const ProgramRun run = runProgram(words);
        EXPECT_TRUE(says(run.err, "is a pipe; expected a file")) << testing::PrintToString(words);
        EXPECT_EQ(run.exitCode, 1) << testing::PrintToString(words) << run.err;
        char byte = 0;
        EXPECT_LT(read(pipe, &byte, 1), 0) << testing::PrintToString(words);
        close(pipe);
        unlink(at(name).c_str());
    }
    std::string at(const std::string& name) const { return folder.path(name); }

    std::string scene;
};

TEST_F(PipeOutputs, EveryCommandRefusesThem) {
    const auto render = [&](std::vector<std::string> more) {
        std::vector<std::string> words{"render", scene, "--passes", "3"};
        words.insert(words.end(), more.begin(), more.end());
        return words;
    };
    expectRefused("f.png", render({"-o", at("f.png")}));
    expectRefused("f.json", render({"-o", at("o.png"), "--json", at("f.json")}));
    expectRefused("f.film", render({"-o", at("o.png"), "--checkpoint", at("f.film")}));
    expectRefused("o-000002.png", render({"-o", at("o.png"), "--checkpoint-every", "1"}));
    expectRefused("o-000002.png", render({"-o", at("o.png"), "--turntable", "3"}));
    expectRefused("f.json", {"info", scene, "--json", at("f.json")});
    expectRefused("f.json", {"convert", scene, at("f.json")});
    expectRefused("f.gltf", {"convert", scene, at("f.gltf")});
    expectRefused("f.json", {"diff", at("p.png"), at("p.png"), "--json", at("f.json")});
    expectRefused("flip.png", {"diff", at("p.png"), at("p.png"), "--maps", folder.path()});
    expectRefused("f.json", {"bench", "passes", scene, "--json", at("f.json")});
    expectRefused("f.html", {"stress", "--quick", "--filter", "recurrence", "--html", at("f.html")});
    const std::vector<std::string> converge{
        "converge", scene,   "--make-reference", "0.1",         "--passes", "1",         "--integrators",
        "pt",       "--out", at("runs"),         "--overwrite", "--json",   at("f.json")};
    std::filesystem::create_directory(at("runs"));
    expectRefused("f.json", converge);
    expectRefused("runs/index.html", converge);
    EXPECT_FALSE(std::filesystem::exists(at("o.png")) || std::filesystem::exists(at("o-000001.png")));
}

TEST_F(PipeOutputs, SoDoesTheWindow) {
    const std::vector<std::string> view{"view", scene, "--headless", "--passes", "1"};
    if (says(runProgram(view).err, "this build has no window")) { GTEST_SKIP(); }
    const auto with = [&](const char* option, const std::string& value) {
        std::vector<std::string> words = view;
        words.insert(words.end(), {option, value});
        return words;
    };
    expectRefused("f.png", with("--screenshot", at("f.png")));
    expectRefused("f.png", with("--output", at("f.png")));
    expectRefused("f.json", with("--json", at("f.json")));
    const std::string script = folder.write("s.txt", "wait finished\nscreenshot \"" + at("f.png") + "\"\n");
    expectRefused("f.png", with("--script", script));
}

TEST_F(PipeOutputs, ThoseThatTheProgramWasStartedWithAreWrittenTo) {
    for (const char* name : {"/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"}) {
        const ProgramRun run =
            runProgram({"render", scene, "-o", at("o.png"), "--passes", "1", "--json", name});
        EXPECT_EQ(run.exitCode, 0) << name << run.err;
        EXPECT_TRUE(says(run.out, "\"report\": \"render\"")) << name;
    }
    const ProgramRun other = runProgram({"info", scene, "--json", "/dev/fd/9"}, {.before = [] {
                                            int ends[2];
                                            if (pipe(ends) == 0) { dup2(ends[0], 9); }
                                            close(ends[1]);
                                        }});
    EXPECT_EQ(other.exitCode, 1) << "the end to read from: " << other.err;
    EXPECT_TRUE(says(other.err, "is a pipe; expected a file"));
}

}  // namespace
}  // namespace glint
