// The column of panels: every panel is one click away, the arrangement is remembered, and scenes are saved
// where the user says.
#include <cstdlib>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/atomic_file.h"
#include "engine/math/vec.h"
#include "tests/viewer/play_script.h"
#include "viewer/model/window_layout.h"

namespace glint {
namespace {

namespace fs = std::filesystem;
using namespace test;
using testing::HasSubstr;

TEST(WindowLayout, ReadsWhatItWrote) {
    WindowLayout layout;
    layout.begin("layouts/one");
    layout.columnUnits = 444.5f;
    layout.open["Lens"] = false;
    layout.open["Ray casting"] = true;
    layout.save();
    WindowLayout later;
    later.begin("layouts/one");
    EXPECT_EQ(later.columnUnits, 444.5f);
    EXPECT_EQ(later.open, layout.open);
    write("layouts/bad", "column many\nopen\n\xff\n");
    later = {};
    later.begin("layouts/bad");
    EXPECT_EQ(later.columnUnits, 372.0f);
}

/// Upper left corner of a widget on the screen, of `print widgets`.
Vec2 cornerOf(const Ran& ran, const std::string& widget) {
    const size_t at = ran.output.find("\"" + widget + "\" ");
    Vec2 corner(-1.0f);
    if (at != std::string::npos) {
        std::sscanf(ran.output.c_str() + at + widget.size() + 2, "%f %f", &corner.x, &corner.y);
    }
    return corner;
}
float topOf(const Ran& ran, const std::string& widget) { return cornerOf(ran, widget).y; }

TEST(LayoutViewer, TheLensIsOneClickAwayAt720Rows) {
    const Ran ran = play(R"(
wait picture
click "Go to Lens"
wait frames 4
print widgets
screenshot layout.png
)");
    expectPlayed(ran);
    for (const char* row : {"Lens/Focal length", "Lens/Aperture", "Lens/Focal distance", "Lens/Blades"}) {
        EXPECT_GT(topOf(ran, row), 0.0f) << row;
        EXPECT_LT(topOf(ran, row), 680.0f) << row;
    }
}

/// Where a row ends to the right and how high it is.
Vec2 endOf(const Ran& ran, const std::string& widget) {
    const size_t at = ran.output.find("\"" + widget + "\" ");
    float left = 0.0f, top = 0.0f;
    Vec2 size(0.0f);
    if (at != std::string::npos) {
        std::sscanf(ran.output.c_str() + at + widget.size() + 2, "%f %f %f %f", &left, &top, &size.x,
                    &size.y);
    }
    return {left + size.x, size.y};
}

/// A name may be a sentence, or one word that no line holds.
TEST(LayoutViewer, LongValuesTakeAsManyLinesAsTheyNeed) {
    std::string scene = kScene;
    std::string name = "a ball that somebody called by far too many words for a line";
    name += std::string(90, 'x');
    const std::string type = "\"type\": \"sphere\",";
    scene.insert(scene.find(type) + type.size(), " \"name\": \"" + name + "\",");
    write("named.json", scene);
    write("named.txt", R"(
wait picture
open "Inspector"
wait frames 3
move "Image"
wait frames 3
print widgets
)");
    const Ran ran = run("view named.json --headless --threads 1 --script named.txt");
    expectPlayed(ran);
    ASSERT_NE(ran.output.find(name), std::string::npos) << ran.output;
    EXPECT_GT(endOf(ran, "Inspector/Object").x, 1000.0f) << "it is there";
    EXPECT_LE(endOf(ran, "Inspector/Object").x, 1280.0f);
    EXPECT_GT(endOf(ran, "Inspector/Object").y, 2.5f * endOf(ran, "Inspector/Material").y);
}

TEST(LayoutViewer, LongLabelsHaveTheRoomThatTheyNeed) {
    const Ran ran = play(R"(
wait picture
open "Materials"
set "Materials/Kind" Plastic
wait frames 3
print widgets
)");
    expectPlayed(ran);
    const float usual = cornerOf(ran, "Materials/Facets").x;
    EXPECT_EQ(cornerOf(ran, "Materials/IOR map").x, usual);
    EXPECT_GT(cornerOf(ran, "Materials/Anisotropy direction map").x, usual + 15.0f);
}

TEST(LayoutViewer, TheArrangementIsRemembered) {
    setenv("XDG_STATE_HOME", fs::absolute("layout_state").c_str(), 1);
    expectPlayed(
        play("wait picture\nclose \"Render\"\nopen \"Outliner\"\nwait frames 3\n"
             "drag \"Splitter\" -60 0\nwait frames 3\n",
             "--recovery 3600"));
    const Ran ran = play("wait picture\nexpect \"Render\" closed\nexpect \"Outliner\" open\nprint widgets\n",
                         "--recovery 3600");
    expectPlayed(ran);
    EXPECT_THAT(ran.output, HasSubstr("\"Splitter\" 842 ")) << ran.output;
}

TEST(LayoutViewer, ViewsAreKeptForTheirScene) {
    setenv("XDG_STATE_HOME", fs::absolute("views_state").c_str(), 1);
    expectPlayed(play(R"(
wait picture
set "Camera/Position" 1 2 6
set "Aperture" 20
set "Projection" "Orthographic"
wait picture
set "View height" 3
set "Shift up" 0.25
wait picture
click "Bookmark this view"
key home
wait picture
expect "Camera/Position" "0 1 4"
expect "Projection" "Perspective"
click "View 1"
wait picture
expect "Camera/Position" "1 2 6"
expect "Projection" "Orthographic"
expect "View height" 3
expect "Shift up" 0.25
expect "Aperture" 20
click "Bookmark this view"
click "Forget View 1"
wait frames 3
expect no-widget "View 1"
)",
                      "--recovery 3600"));
    expectPlayed(play(R"(
wait picture
click "View 2"
wait picture
expect "Camera/Position" "1 2 6"
open "History"
wait frames 3
expect widget "2. View 2"
)",
                      "--recovery 3600"));
}

TEST(LayoutViewer, ScenesAreSavedWhereTheUserSays) {
    fs::create_directories("saved here");
    fs::remove("saved here/mine.json");
    expectPlayed(play(R"(
wait picture
set "Aperture" 20
wait picture
key ctrl down
key shift down
key s
key shift up
key ctrl up
wait frames 3
expect "Name" "scene-edited.json"
screenshot save_as.png
click "saved here/"
wait frames 3
expect "Name" "scene-edited.json"
set "Name" mine
click "Save this"
wait jobs
expect message "mine.json"
key ctrl down
key shift down
key s
key shift up
key ctrl up
wait frames 3
key escape
wait frames 3
expect no-widget "Save this"
)"));
    EXPECT_THAT(*readFile("saved here/mine.json"), HasSubstr("\"apertureDiameter\": 0.02"));
}

}  // namespace
}  // namespace glint
