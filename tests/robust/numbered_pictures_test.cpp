// Numbered pictures replace no input and no other output, which is known before the first pass; one that
// cannot be written on the way makes the run fail at its end.
#include <chrono>
#include <thread>

#include "engine/io/image_io.h"
#include "tests/support/program_test.h"
#include "viewer/base/numbered_files.h"

namespace glint {
namespace {

using test::ProgramRun;
using test::runProgram;
using test::says;
using test::TempFolder;

namespace fs = std::filesystem;

class NumberedPictures : public test::ProgramTest {
  protected:
    void SetUp() override {
        ProgramTest::SetUp();
        ASSERT_TRUE(savePng(idle, Image8{2, 1, {200, 100, 50, 20, 30, 40}}));
        scene = sceneWith("idle.png");
    }
    std::string sceneWith(const std::string& texture) const {
        return folder.write(texture + ".json", R"({ "glint": 1, "resolution": [8, 8],
            "camera": { "position": [0, 0, 4], "target": [0, 0, 0] },
            "textures": { "idle": { "file": ")" + texture +
                                                   R"(" } }, "environment": { "color": 1 } })");
    }
    ProgramRun render(const std::string& opened, const char* passes, const char* option,
                      const std::string& value, const std::vector<std::string>& more = {}) const {
        std::vector<std::string> words{"render", opened, "-o", out, "--passes", passes, option, value};
        words.insert(words.end(), more.begin(), more.end());
        return runProgram(words);
    }
    void expectRefused(const ProgramRun& run, const char* message) const {
        EXPECT_EQ(run.exitCode, 1) << run.err;
        EXPECT_TRUE(says(run.err, message));
        EXPECT_FALSE(fs::exists(numberedPath(out, 1)) || fs::exists(out));
    }
    std::string at(const char* name) const { return folder.path(name); }

    const std::string idle = folder.path("idle.png");
    const std::string out = folder.path("out.png");
    const std::string second = folder.path("out-000002.png");
    std::string scene;
};

TEST_F(NumberedPictures, ReplaceNoOutput) {
    expectRefused(render(scene, "3", "--checkpoint-every", "1", {"--json", second}),
                  "two outputs go to one file");
    expectRefused(render(scene, "3", "--checkpoint-every", "1", {"--checkpoint", second}),
                  "two outputs go to one file");
}

TEST_F(NumberedPictures, ReplaceNoInput) {
    const auto refuse = [&](const std::string& opened) {
        const std::string before = TempFolder::read(idle);
        const char* const texture = "is a texture of the scene";
        expectRefused(render(opened, "3", "--checkpoint-every", "1"), texture);
        expectRefused(render(opened, "5", "--checkpoint-every", "2"), texture);
        expectRefused(render(opened, "1", "--turntable", "3"), texture);
        EXPECT_EQ(TempFolder::read(second), before);
        fs::remove(second);
    };
    fs::copy_file(idle, second);
    refuse(sceneWith("out-000002.png"));
    fs::create_hard_link(idle, second);
    refuse(scene);
    fs::copy_file(idle, second);
    fs::create_symlink("out-000002.png", at("link.png"));
    refuse(sceneWith("link.png"));
    fs::create_symlink("idle.png", second);
    refuse(scene);
}

TEST_F(NumberedPictures, ThatAreNeverWrittenAreNoMatter) {
    fs::copy_file(idle, second);
    const std::string opened = sceneWith("out-000002.png"), before = TempFolder::read(second);
    EXPECT_EQ(render(opened, "2", "--checkpoint-every", "1").exitCode, 0) << "the last has no number";
    EXPECT_EQ(render(opened, "4", "--checkpoint-every", "3").exitCode, 0);
    EXPECT_EQ(render(opened, "1", "--turntable", "1").exitCode, 0);
    EXPECT_EQ(TempFolder::read(second), before);
}

/// A folder takes the name of a picture that is still to come.
TEST_F(NumberedPictures, OneThatIsMissingIsAFailure) {
    ProgramRun run;
    {
        const std::jthread rendering([&] {
            run = runProgram({"render", scene, "-o", out, "--passes", "100000000", "--checkpoint-every", "1"},
                             {.signalAfter = "is a folder"});
        });
        for (uint32_t next = 1;; next += 20) {
            while (!fs::exists(numberedPath(out, next))) {
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            }
            std::error_code isLate;
            if (fs::create_directory(numberedPath(out, next + 20), isLate)) { break; }
        }
    }
    EXPECT_EQ(run.exitCode, 2) << run.err;
    EXPECT_TRUE(fs::is_regular_file(out));
}

}  // namespace
}  // namespace glint
