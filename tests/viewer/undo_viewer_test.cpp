// Undo and redo, by scripts.
#include <gtest/gtest.h>

#include "engine/io/atomic_file.h"
#include "engine/io/scene_loader.h"
#include "tests/viewer/play_script.h"

namespace glint {
namespace {

using namespace test;

constexpr const char* kUndo = "key ctrl down\nkey z\nkey ctrl up\nwait picture\n";
constexpr const char* kRedo =
    "key ctrl down\nkey shift down\nkey z\nkey shift up\nkey ctrl up\nwait picture\n";
constexpr const char* kRedoByY = "key ctrl down\nkey y\nkey ctrl up\nwait picture\n";
constexpr const char* kLimit = "--passes 12";

std::string savePng(const std::string& name) {
    return "set \"PNG file\" " + name + "\nclick \"Save PNG\"\nwait jobs\n";
}

TEST(UndoViewer, AnEditIsUndoneWithItsFilm) {
    expectPlayed(play(
        "wait finished\nopen \"Checkpoint\"\nopen \"Picture\"\nwait frames 2\n" + savePng("before.png") +
            "mark\nset \"Field of view\" 20\nwait finished\nexpect restarts 1\n" + savePng("edited.png") +
            "mark\n" + kUndo + "expect passes-at-least 12\nexpect restarts 0\nexpect \"Field of view\" 40\n" +
            savePng("after.png") + kRedo +
            "expect passes-at-least 12\nexpect restarts 0\nexpect \"Field of view\" 20\n" + kUndo + kRedoByY +
            "expect \"Field of view\" 20\nexpect restarts 0\n",
        kLimit));
    EXPECT_TRUE(*readFile("before.png") == *readFile("after.png"));
    EXPECT_FALSE(*readFile("before.png") == *readFile("edited.png"));
}

TEST(UndoViewer, SettingsAsTheOriginalsAreOneStep) {
    expectPlayed(play(std::string(R"play(
wait picture
open "Display"
open "Picture"
wait frames 2
set "Exposure" 1
wait frames 2
click "As the original"
wait picture
expect "Max depth" 20
expect "Filter" Box
expect "Filter radius" 1
expect "Exposure" 0
expect "Tone map" "Clamp (linear)"
open "Checkpoint"
wait frames 2
set "Scene file" original.json
click "Save scene"
wait jobs
)play") + kUndo + R"(
expect "Max depth" 64
expect "Filter" Blackman-Harris
expect "Exposure" 1
expect "Tone map" sRGB
)"));
    const auto saved = loadScene("original.json");
    ASSERT_TRUE(saved) << saved.error().format();
    EXPECT_EQ(saved->camera.apertureBlades, 4);
    EXPECT_EQ(saved->camera.bladeRotationDeg, 45.0f);
}

TEST(UndoViewer, ADragIsOneStep) {
    expectPlayed(
        play(std::string(R"(
wait picture
open "History"
wait frames 2
drag "Image" 60 10
wait picture
drag "Aperture" 40 0
wait picture
expect widget "3. Camera: aperture diameter"
expect widget "2. Camera: position"
)") + kUndo + "expect \"Aperture\" 0\n" +
             kUndo +
             "open \"Picture\"\nwait frames 2\nclick \"3. Camera: aperture diameter\"\nwait picture\n"
             "set \"Max depth\" 3\nwait picture\n" +
             kUndo + kUndo +
             "set \"Field of view\" 30\nwait picture\n"
             "expect widget \"3. Camera: vertical fov\"\nexpect no-widget \"4. Render: max depth\"\n"));
}

TEST(UndoViewer, HowThePictureIsShownIsUndone) {
    expectPlayed(play(std::string(R"(
wait finished
open "History"
wait frames 2
mark
drag "Exposure" 30 0
wait frames 2
expect widget "2. Display: exposure"
expect no-widget "3. Display: exposure"
set "Tone map" Filmic
set "Shown" Depth
set "Denoise" on
wait frames 2
expect widget "3. Display: tone map"
expect widget "4. Display: Depth"
expect widget "5. Display: denoise"
)") + kUndo + kUndo + "expect \"Denoise\" off\nexpect \"Shown\" Radiance\nexpect \"Tone map\" Filmic\n" +
                          "set \"Field of view\" 20\nwait finished\n" + kUndo +
                          "expect \"Tone map\" Filmic\n" + kUndo + kUndo +
                          R"(
expect "Tone map" sRGB
expect "Exposure" 0
expect passes-at-least 12
expect restarts 1
key ]
wait frames 2
key ]
wait frames 2
expect widget "3. Display: exposure"
)" + kUndo + kUndo + "expect \"Exposure\" 0\n",
                      kLimit));
}

TEST(UndoViewer, AnExposureThatWasChosenIsNoStep) {
    std::string dim(kScene);
    dim.replace(dim.find("\"color\": 1"), 10, "\"color\": 0.001");
    write("dim.json", dim);
    write("script.txt",
          std::string(R"(
wait finished
open "History"
wait frames 2
expect no-widget "2. Display: exposure"
print "Exposure"
set "Tone map" Filmic
wait frames 2
)") + kUndo +
              "print \"Exposure\"\nset \"File\" scene.json\nclick \"Open\"\nwait jobs\nwait finished\n"
              "expect \"Exposure\" 0\n" +
              kUndo + "wait frames 3\nprint \"Exposure\"\n");
    write("scene.json", kScene);
    const Ran ran = run("view dim.json --headless --threads 1 --script script.txt --passes 12");
    expectPlayed(ran);
    const std::vector<std::string> stops = printed(ran, "Display/Exposure");
    ASSERT_EQ(stops.size(), 3u);
    EXPECT_NE(stops[0], "0");
    EXPECT_EQ(stops[1], stops[0]);
    EXPECT_EQ(stops[2], stops[0]);
}

TEST(UndoViewer, RestartResetAndOpeningAreUndone) {
    write("other.json", std::string(kScene));
    expectPlayed(play(std::string(R"(
wait finished
mark
key r
wait finished
expect restarts 1
)") + kUndo + "expect passes-at-least 12\nexpect restarts 1\n" +
                          R"(
set "Field of view" 20
wait finished
key home
wait finished
)" + kUndo + "expect \"Field of view\" 20\n" +
                          "set \"File\" other.json\nclick \"Open\"\nwait jobs\nwait finished\n"
                          "expect \"File\" other.json\nexpect \"Field of view\" 40\nmark\n" +
                          kUndo +
                          "expect \"File\" scene.json\nexpect \"Field of view\" 20\nexpect restarts 0\n" +
                          kRedo + "expect \"File\" other.json\n",
                      kLimit));
}

TEST(UndoViewer, TheFirstStateHasNothingToUndo) {
    expectPlayed(
        play(std::string("wait finished\nmark\n") + kUndo + kRedo +
                 "expect restarts 0\nopen \"History\"\nwait frames 2\nclick \"Undo\"\nwait frames 3\n"
                 "expect restarts 0\nexpect passes-at-least 12\n",
             kLimit));
}

}  // namespace
}  // namespace glint
