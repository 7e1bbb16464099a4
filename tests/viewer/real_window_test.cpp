// A real window on an X server of the test's own (Xvfb), with a mouse and a keyboard that are not ours
// (xdotool): a click pauses, a drag on the picture moves the camera, closing ends the program with exit
// code 0.
#include "tests/viewer/real_window.h"

#include <cmath>
#include <cstdio>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "viewer/model/window_layout.h"
// Last: Xlib's macros.
#include "tests/viewer/drag_source.h"

namespace glint {
namespace {

using namespace test;

TEST_F(RealWindow, AClickPausesADragMovesTheCameraAndClosingEndsIt) {
#if GLINT_TEST_HAS_XLIB
    openWindow();
    if (HasFatalFailure()) { return; }
    click("Render/Pause");
    ASSERT_TRUE(titleSays("paused")) << read("glint.log");
    dragImage(120, 30);
    askToClose(display_->name(), std::stoul(window_));
    EXPECT_EQ(glint_->exitCode(), 0) << read("glint.log");
    const nlohmann::json left = report();
    ASSERT_TRUE(left.contains("session")) << read("view.json");
    EXPECT_GE(left["session"]["restarts"], 2) << left["session"];
    const auto position = left["camera"]["position"].get<std::vector<double>>();
    // Orbiting keeps the distance to the target.
    EXPECT_GT(std::abs(position[0]), 0.1);
    EXPECT_NEAR(std::hypot(position[0], position[1] - 1.0, position[2]), 4.0, 1e-3);
#else
    GTEST_SKIP() << "Xlib's headers are not installed";
#endif
}

TEST_F(RealWindow, FilesAreDroppedOnIt) {
#if GLINT_TEST_HAS_XLIB
    openWindow();
    if (HasFatalFailure()) { return; }
    write("another scene.json", kWindowScene);
    write("broken.json", "{\n  \"glint\": 1,\n  \"camra\": 3\n}\n");
    write("no picture.png", "hello");
    const std::string folder = "file://" + std::filesystem::current_path().string() + "/";
    const ::Window target = std::stoul(window_);
    DragSource source(display_->name());
    const auto logSays = [](const char* what) {
        return until([&] { return read("glint.log").find(what) != std::string::npos; });
    };
    EXPECT_TRUE(source.drop(target, folder + "broken.json\r\n"));
    EXPECT_TRUE(logSays("camra")) << read("glint.log");
    EXPECT_TRUE(source.drop(target, folder + "no%20picture.png\r\n" + folder + "\r\n"));
    EXPECT_TRUE(logSays("no picture.png: ")) << read("glint.log");
    EXPECT_TRUE(logSays("is a folder; expected a scene file")) << read("glint.log");
    EXPECT_TRUE(source.drop(target, folder + "another%20scene.json\r\n"));
    EXPECT_TRUE(titleSays("another scene.json")) << read("glint.log");
    askToClose(display_->name(), target);
    EXPECT_EQ(glint_->exitCode(), 0) << read("glint.log");
#else
    GTEST_SKIP() << "Xlib's headers are not installed";
#endif
}

TEST_F(RealWindow, ADragIsUndone) {
    openWindow();
    if (HasFatalFailure()) { return; }
    hand("windowfocus " + window_);
    dragImage(120, 30);
    ASSERT_TRUE(titleSays("scene.json[*]")) << "the edit is not in the file";
    ASSERT_TRUE(titleSaysAfterCtrl("z", "^scene.json ")) << read("glint.log");
    ASSERT_TRUE(titleSaysAfterCtrl("y", "^scene.json[*] ")) << read("glint.log");
}

TEST_F(RealWindow, CtrlClickFocuses) {
    openWindow();
    if (HasFatalFailure()) { return; }
    hand("windowfocus " + window_);
    hand("keydown ctrl");
    click("Image");
    EXPECT_TRUE(titleSays("^scene.json[*] ")) << "the focal distance is the sphere's now";
    hand("keyup ctrl");
    EXPECT_TRUE(titleSaysAfterCtrl("z", "^scene.json ")) << read("glint.log");
}

TEST_F(RealWindow, BrowsingAsksTheDesktopsDialog) {
    write("another scene.json", kWindowScene);
    std::filesystem::create_directory("programs");
    const std::string here = std::filesystem::current_path().string();
    write("programs/zenity", "#!/bin/sh\necho \"$@\" > asked.txt\necho '" + here + "/another scene.json'\n");
    std::filesystem::permissions("programs/zenity", std::filesystem::perms::owner_all);
    const std::string path = std::getenv("PATH");
    setenv("PATH", (here + "/programs:" + path).c_str(), 1);
    openWindow();
    if (!HasFatalFailure()) {
        hand("windowfocus " + window_);
        EXPECT_TRUE(titleSaysAfterCtrl("o", "^another scene.json ")) << read("glint.log");
        EXPECT_THAT(read("asked.txt"), testing::HasSubstr("--filename=" + here));
    }
    setenv("PATH", path.c_str(), 1);
}

TEST_F(RealWindow, ClosingAsksBeforeEditsAreLost) {
#if GLINT_TEST_HAS_XLIB
    openWindow();
    if (HasFatalFailure()) { return; }
    dragAperture();
    ASSERT_TRUE(titleSays("scene.json[*]")) << read("glint.log");
    askToClose(display_->name(), std::stoul(window_));
    findWidgets("set \"Aperture\" 20\nkey ctrl down\nkey q\nkey ctrl up\nwait frames 4\n");
    std::this_thread::sleep_for(std::chrono::seconds(1));
    ASSERT_FALSE(glint_->ended()) << "it asks first";
    click("Close");
    EXPECT_EQ(glint_->exitCode(), 0) << read("glint.log");
#else
    GTEST_SKIP() << "Xlib's headers are not installed";
#endif
}

TEST_F(RealWindow, AKilledSessionIsRestored) {
    openWindow();
    if (HasFatalFailure()) { return; }
    dragAperture();
    ASSERT_TRUE(titleSays("scene.json[*]")) << read("glint.log");
    const auto keeps = [] {
        const std::filesystem::path folder = "state/glint/sessions";
        for (const auto& entry : std::filesystem::directory_iterator(folder)) {
            if (entry.path().extension() == ".glintfilm") { return true; }
        }
        return false;
    };
    ASSERT_TRUE(until(keeps));
    std::this_thread::sleep_for(std::chrono::seconds(2));  // the edit too
    glint_->killAtOnce();
    openWindow();
    if (HasFatalFailure()) { return; }
    ASSERT_TRUE(titleSays("^scene.json ")) << "as it is in the file";
    click("Restore");
    EXPECT_TRUE(titleSays("scene.json[*]")) << read("glint.log");
}

TEST_F(RealWindow, TheKeyboardPausesAndQuits) {
    openWindow();
    if (HasFatalFailure()) { return; }
    hand("windowfocus " + window_);
    // Held until it is seen: pressed and released between two frames, a key would be lost.
    hand("keydown space");
    ASSERT_TRUE(titleSays("paused")) << read("glint.log");
    hand("keyup space");
    hand("keydown ctrl keydown q");
    EXPECT_EQ(glint_->exitCode(), 0) << read("glint.log");
    const nlohmann::json left = report();
    ASSERT_TRUE(left.contains("session")) << read("view.json");
    EXPECT_EQ(left["session"]["state"], "paused");
    EXPECT_EQ(left["session"]["restarts"], 1);
}

TEST_F(RealWindow, AKeyIsChanged) {
    openWindow();
    if (HasFatalFailure()) { return; }
    hand("windowfocus " + window_);
    press("F1");
    findWidgets("key f1\nwait frames 3\n");
    click("Key of pause");
    press("KP_Add");
    EXPECT_TRUE(until([] { return !read("config/glint/keys").empty(); }));
    EXPECT_EQ(read("config/glint/keys"), "zoom-in +\npause kp+\n");
    press("Escape");
    press("space");
    EXPECT_TRUE(titleSays("^scene.json ")) << "no key of anything now";
    hand("keydown KP_Add");
    EXPECT_TRUE(titleSays("paused")) << read("glint.log");
    hand("keyup KP_Add");
    hand("keydown ctrl keydown q");
    EXPECT_EQ(glint_->exitCode(), 0) << read("glint.log");
}

TEST_F(RealWindow, SpaceIsForTheMarkedWidgetUntilEsc) {
    openWindow();
    if (HasFatalFailure()) { return; }
    hand("windowfocus " + window_);
    press("F6");
    press("space");
    EXPECT_TRUE(titleSays("^scene.json ")) << "a section was closed, and nothing paused";
    press("Escape");
    hand("keydown space");
    EXPECT_TRUE(titleSays("paused")) << read("glint.log");
    hand("keyup space");
}

TEST_F(RealWindow, ArrowsMoveTheSelectionAndAltWithThemThePanels) {
    openWindow();
    if (HasFatalFailure()) { return; }
    hand("windowfocus " + window_);
    click("Image");
    press("Right");
    EXPECT_TRUE(titleSays("^scene.json ")) << "there are no handles";
    press("g");
    press("Right");
    EXPECT_TRUE(titleSays("scene.json[*]")) << read("glint.log");
    EXPECT_TRUE(titleSaysAfterCtrl("z", "^scene.json ")) << "one step of the history";
    press("alt+Left");
    hand("keydown ctrl keydown q");
    EXPECT_EQ(glint_->exitCode(), 0) << read("glint.log");
    float column = 0.0f;
    const std::string layout = read("state/glint/layout");
    ASSERT_EQ(std::sscanf(layout.c_str(), "column %f", &column), 1) << layout;
    EXPECT_GE(column, WindowLayout().columnUnits + 20.0f);
}

TEST_F(RealWindow, AMaterialIsDraggedToAnObject) {
    openWindow();
    if (HasFatalFailure()) { return; }
    findWidgets("");
    click("Go to Library");
    findWidgets("click \"Go to Library\"\nwait frames 4\n");
    const auto line = placeOf(widgets_, "Library/aluminium"), image = placeOf(widgets_, "Image");
    ASSERT_TRUE(line && image) << widgets_;
    moveTo(line->centreX(), line->centreY());
    hand("mousedown 1");
    moveTo(line->centreX() - 60, line->centreY());
    moveTo(image->centreX(), image->centreY());
    std::this_thread::sleep_for(std::chrono::seconds(1));
    hand("mouseup 1");
    EXPECT_TRUE(titleSays("scene.json[*]")) << read("glint.log");
}

TEST_F(RealWindow, ADisplayWithoutOpenGlIsExitTwoWithTheCause) {
    XServer display({"-extension", "GLX"});
    ASSERT_FALSE(display.name().empty()) << read("xvfb.log");
    setenv("DISPLAY", display.name().c_str(), 1);
    Child glint({GLINT_PROGRAM, "view", "scene.json"}, "glint.log");
    EXPECT_EQ(glint.exitCode(), 2);
    EXPECT_THAT(read("glint.log"), testing::HasSubstr("no window with OpenGL 3.3 can be opened: "));
}

TEST_F(RealWindow, OpenGlThatIsTooOldIsExitTwoWithTheCause) {
    XServer display;
    ASSERT_FALSE(display.name().empty()) << read("xvfb.log");
    setenv("DISPLAY", display.name().c_str(), 1);
    Child glint({"env", "MESA_GL_VERSION_OVERRIDE=2.1", GLINT_PROGRAM, "view", "scene.json"}, "glint.log");
    EXPECT_EQ(glint.exitCode(), 2);
    EXPECT_THAT(read("glint.log"), testing::HasSubstr("no window with OpenGL 3.3 can be opened: "));
}

TEST_F(RealWindow, ADisplayThatIsNotThereIsExitTwoWithTheCause) {
    setenv("DISPLAY", ":987", 1);
    Child glint({GLINT_PROGRAM, "view", "scene.json"}, "glint.log");
    EXPECT_EQ(glint.exitCode(), 2);
    EXPECT_THAT(read("glint.log"), testing::HasSubstr("no window can be opened: "));
}

}  // namespace
}  // namespace glint
