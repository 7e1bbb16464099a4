// Saves that cannot be: no name, no room, and what an earlier session left in a form that nobody can read.
#include <cstdlib>
#include <filesystem>

#include <gtest/gtest.h>

#include "engine/io/atomic_file.h"
#include "tests/viewer/play_script.h"

namespace glint {
namespace {

namespace fs = std::filesystem;
using namespace test;

size_t countOf(const std::string& text, const std::string& part) {
    size_t count = 0;
    for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
        ++count;
    }
    return count;
}

TEST(FailedSaves, WithoutANameNothingIsSavedAndThatIsSaid) {
    expectPlayed(play(R"(
wait picture
open "Checkpoint"
wait frames 3
set "Scene file" ""
click "Save scene"
wait frames 3
expect message "no file name"
set "PNG file" "   "
click "Save PNG"
wait frames 3
expect message "no file name"
set "Scene file" nameless.json
click "Save scene"
wait jobs
expect message "Saved "
)"));
}

TEST(FailedSaves, ATildeIsTheHomeFolder) {
    const fs::path home = fs::absolute("home");
    fs::create_directories(home);
    setenv("HOME", home.c_str(), 1);
    expectPlayed(play(R"(
wait picture
open "Checkpoint"
wait frames 3
set "Scene file" ~/at-home.json
click "Save scene"
wait jobs
expect message "home/at-home.json"
)"));
    EXPECT_TRUE(fs::exists(home / "at-home.json"));
}

/// A limit on the size of files stands for a full disk.
TEST(FailedSaves, ASessionThatCannotBeKeptIsSaidOnce) {
    setenv("XDG_STATE_HOME", fs::absolute("state").c_str(), 1);
    fs::remove_all("state");
    write("scene.json", kScene);
    write("full.txt", R"(
wait finished
wait seconds 1
expect message "cannot be kept for a crash"
set "Aperture" 20
wait finished
wait seconds 1
)");
    const int code =
        std::system((std::string("ulimit -f 16; trap '' XFSZ; exec ") + GLINT_PROGRAM +
                     " view scene.json --headless --threads 1 --passes 4 --recovery 0.1 --script full.txt "
                     "> full.log 2>&1 < /dev/null")
                        .c_str());
    const std::string log = *readFile("full.log");
    EXPECT_EQ(code, 0) << log;
    EXPECT_EQ(countOf(log, "cannot be kept for a crash"), 1u) << log;
}

TEST(FailedSaves, ASessionThatCannotBeReadIsKeptAside) {
    setenv("XDG_STATE_HOME", fs::absolute("state").c_str(), 1);
    fs::remove_all("state");
    const fs::path folder = fs::path("state") / "glint" / "sessions";
    fs::create_directories(folder / "7-1.glintfilm.files");
    write((folder / "7-1.glintfilm").string(), "of another version");
    write((folder / "7-1.glintfilm.files" / "image.png").string(), "a picture");
    const std::string script = "wait finished\nwait frames 3\nexpect no-widget \"Restore\"\n";
    const Ran first = play(script, "--passes 2 --recovery 3600");
    expectPlayed(first);
    EXPECT_EQ(countOf(first.output, "it is kept as "), 1u) << first.output;
    EXPECT_EQ(*readFile((folder / "7-1.glintfilm.unreadable").string()), "of another version");
    const Ran second = play(script, "--passes 2 --recovery 3600");
    expectPlayed(second);
    EXPECT_EQ(countOf(second.output, "it is kept as "), 0u) << "once is enough";
    EXPECT_TRUE(fs::exists(folder / "7-1.glintfilm.unreadable"));
    EXPECT_TRUE(fs::exists(folder / "7-1.glintfilm.unreadable.files" / "image.png"));
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 2) << "the lock is gone";
}

}  // namespace
}  // namespace glint
