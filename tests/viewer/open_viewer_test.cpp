// Looking for scenes in folders, and those that were opened last.
#include <cstdlib>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/viewer/play_script.h"
#include "viewer/model/file_browser.h"
#include "viewer/model/recent_files.h"

namespace glint {
namespace {

namespace fs = std::filesystem;
using namespace test;
using testing::ElementsAre;

std::vector<std::string> namesIn(const FileBrowser& browser) {
    std::vector<std::string> names;
    for (const FileBrowser::Entry& entry : browser.entries()) {
        names.push_back(entry.name);
    }
    return names;
}

TEST(FileBrowser, GoesThroughFolders) {
    fs::create_directories("around/b folder/deep");
    write("around/a.json", "");
    write("around/.hidden", "");
    write("around/b folder/c.obj", "");
    FileBrowser browser;
    browser.open("around/a.json");
    EXPECT_TRUE(browser.isOpen());
    EXPECT_THAT(namesIn(browser), ElementsAre("../", "b folder/", "a.json"));
    EXPECT_EQ(browser.choose("b folder/"), "");
    EXPECT_THAT(namesIn(browser), ElementsAre("../", "deep/", "c.obj"));
    EXPECT_EQ(browser.choose("c.obj"), fs::absolute("around/b folder/c.obj").string());
    EXPECT_EQ(browser.choose("../"), "");
    EXPECT_EQ(fs::path(browser.folder()).filename(), "around");
    setenv("HOME", fs::absolute("around/b folder").c_str(), 1);
    EXPECT_EQ(browser.choose("~"), "");
    EXPECT_THAT(namesIn(browser), ElementsAre("../", "deep/", "c.obj"));
    EXPECT_EQ(browser.choose("~/c.obj"), fs::absolute("around/b folder/c.obj").string());
}

TEST(RecentFiles, TheNewestIsFirstAndEachIsThereOnce) {
    RecentFiles recent;
    recent.begin("kept/recent");
    for (int i = 0; i < 12; ++i) {
        recent.add("/scenes/" + std::to_string(i) + ".json");
    }
    recent.add("/scenes/5.json");
    RecentFiles later;
    later.begin("kept/recent");
    EXPECT_EQ(later.paths(), recent.paths());
    ASSERT_EQ(later.paths().size(), RecentFiles::kMost);
    EXPECT_EQ(later.paths()[0], "/scenes/5.json");
    EXPECT_EQ(later.paths()[1], "/scenes/11.json");
}

TEST(OpenViewer, AFileIsFoundByBrowsingAndIsRecentThen) {
    fs::create_directories("more");
    write("more/other.json", kScene);
    setenv("XDG_STATE_HOME", fs::absolute("state").c_str(), 1);
    expectPlayed(play(R"(
wait picture
key ctrl down
key o
key ctrl up
wait frames 3
screenshot browser.png
click "more/"
wait frames 3
expect widget "other.json"
click "other.json"
wait jobs
wait picture
expect no-widget "Cancel"
expect "History" closed
open "History"
wait frames 3
expect widget "2. Open other.json"
click "Browse…"
wait frames 3
key escape
wait frames 3
expect no-widget "Cancel"
)",
                      "--recovery 3600"));
    expectPlayed(play("wait picture\nset \"Recent\" \"" + fs::absolute("more/other.json").string() +
                          "\"\nwait jobs\nwait picture\nopen \"History\"\nwait frames 3\n"
                          "expect widget \"2. Open other.json\"\n",
                      "--recovery 3600"));
}

TEST(OpenViewer, WhatLacksFilesIsOpenedWithoutThem) {
    std::string scene(kScene);
    scene.insert(scene.find("\"radius\": 1 }") + 13,
                 R"(, {"type": "mesh", "material": "grey", "mesh": {"file": "gone.obj"}})");
    write("lacking.json", scene);
    write("odd.json", "{ \"glint\": 1, \"camra\": 3 }");
    const Ran ran = play(R"(
wait finished
wait frames 3
print "Progress"
set "Scene/File" odd.json
click "Scene/Open"
wait jobs
wait frames 3
expect no-widget "Open anyway"
set "Scene/File" lacking.json
click "Scene/Open"
wait jobs
wait frames 3
expect error "gone.obj"
print "Error note"
click "Open anyway"
wait frames 3
expect no-error
expect no-widget "Error note"
print "Warnings"
wait picture
)",
                         "--passes 2");
    expectPlayed(ran);
    const auto said = [&ran](const char* label) {
        const std::vector<std::string> values = printed(ran, label);
        EXPECT_EQ(values.size(), 1u) << label << '\n' << ran.output;
        return values.empty() ? std::string() : values[0];
    };
    EXPECT_EQ(said("Progress").rfind("PT · 2 passes · ", 0), 0u) << ran.output;
    EXPECT_NE(said("Error note").find("gone.obj"), std::string::npos);
    EXPECT_NE(said("Scene/Warnings").find("left out: \"gone.obj\""), std::string::npos);
}

}  // namespace
}  // namespace glint
