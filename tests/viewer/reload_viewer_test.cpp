// Files that other programs change are read again, and the camera stays.
#include <chrono>
#include <filesystem>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/scene_loader.h"
#include "tests/support/gltf_files.h"
#include "tests/viewer/play_script.h"
#include "viewer/model/workspace.h"

namespace glint {
namespace {

namespace fs = std::filesystem;
using namespace test;

/// Another time than before, whatever the file system's clock does.
void rewrite(const std::string& path, const std::string& text) {
    write(path, text);
    static int seconds = 0;
    fs::last_write_time(path, fs::file_time_type::clock::now() + std::chrono::seconds(++seconds));
}

TEST(FileWatch, TellsOfAChangeOnceAndNotOfOneThatIsUnderWay) {
    write("watched.txt", "one");
    FileWatch watch;
    watch.watch({"watched.txt", "missing.txt"});
    EXPECT_FALSE(watch.hasChanged(1.0));
    rewrite("watched.txt", "two");
    EXPECT_FALSE(watch.hasChanged(1.1)) << "not so often";
    EXPECT_FALSE(watch.hasChanged(2.0)) << "it may go on";
    rewrite("watched.txt", "three");
    EXPECT_FALSE(watch.hasChanged(3.0)) << "and did";
    EXPECT_TRUE(watch.hasChanged(4.0));
    EXPECT_FALSE(watch.hasChanged(5.0));
    fs::remove("watched.txt");
    EXPECT_FALSE(watch.hasChanged(6.0));
    EXPECT_FALSE(watch.hasChanged(7.0)) << "it may come back";
    rewrite("watched.txt", "four");
    EXPECT_FALSE(watch.hasChanged(8.0));
    EXPECT_TRUE(watch.hasChanged(9.0));
}

TEST(FileWatch, KnowsTheFilesOfAScene) {
    SceneDescription scene;
    scene.path = "folder/scene.json";
    scene.textures.resize(2);
    scene.textures[0].image.source = FileSource{"../wood.png"};
    scene.textures[1].image.source = FileSource{"../wood.png"};
    scene.meshes.resize(1);
    scene.meshes[0].source = MeshGenerator{"cube", 12, 0};
    const auto files = filesOf(scene);
    ASSERT_EQ(files.size(), 2u);
    EXPECT_EQ(files[0], fs::absolute("folder/scene.json").string());
    EXPECT_EQ(files[1], fs::absolute("wood.png").string());
}

TEST(FileWatch, ManyFilesAreLookedAtInTurn) {
    std::vector<std::string> paths(2000, "missing.txt");
    write("last.txt", "one");
    paths.push_back("last.txt");
    FileWatch watch;
    watch.watch(paths);
    rewrite("last.txt", "another");
    int looks = 0;
    while (!watch.hasChanged(++looks)) {
        ASSERT_LT(looks, 100);
    }
    EXPECT_GT(looks, 2) << "not all at once";
    EXPECT_FALSE(watch.hasChanged(++looks));
}

/// Frames of a window that nobody touches.
template <class Condition>
void runUntil(Workspace* workspace, const Condition& condition) {
    while (!condition()) {
        workspace->refresh();
        workspace->commitEdits(false);
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
}

TEST(HotReload, TheSceneIsReadAgainAndTheCameraStays) {
    write("reloaded.json", kScene);
    Workspace workspace(makeCpuBackend(1));
    workspace.adopt(*loadScene("reloaded.json"));
    workspace.document.draft().camera.position = {0, 1, 9};
    workspace.commitEdits(false);
    std::string changed = kScene;
    changed.replace(changed.find("\"radius\": 1"), 11, "\"radius\": 2");
    rewrite("reloaded.json", "{ broken");
    runUntil(&workspace, [&] { return workspace.sceneFiles.error().has_value(); });
    EXPECT_EQ(workspace.document.draft().objects[0].objectToWorld.linear[0].x, 1.0f) << "it goes on";
    rewrite("reloaded.json", changed);
    runUntil(&workspace,
             [&] { return workspace.document.draft().objects[0].objectToWorld.linear[0].x == 2.0f; });
    EXPECT_EQ(workspace.document.draft().camera.position, Vec3(0, 1, 9));
    EXPECT_FALSE(workspace.sceneFiles.error().has_value());
    EXPECT_EQ(workspace.history.name(workspace.history.size() - 1), "Reload reloaded.json");
    workspace.document.resetCamera();
    EXPECT_EQ(workspace.document.draft().camera.position, Vec3(0, 1, 4)) << "the file's";
    workspace.history.askUndo();
    workspace.commitEdits(false);
    EXPECT_EQ(workspace.document.draft().objects[0].objectToWorld.linear[0].x, 1.0f);
}

TEST(HotReload, EditsThatAreNotSavedStay) {
    write("edited.json", kScene);
    Workspace workspace(makeCpuBackend(1));
    workspace.adopt(*loadScene("edited.json"));
    workspace.document.draft().camera.verticalFovDeg = 20.0f;
    workspace.commitEdits(false);
    std::string changed = kScene;
    changed.replace(changed.find("\"radius\": 1"), 11, "\"radius\": 2");
    rewrite("edited.json", changed);
    runUntil(&workspace, [&] { return !workspace.notice.text().empty(); });
    EXPECT_THAT(workspace.notice.text(), testing::HasSubstr("your edits stay"));
    EXPECT_EQ(workspace.document.draft().objects[0].objectToWorld.linear[0].x, 1.0f);
    EXPECT_EQ(workspace.document.draft().camera.verticalFovDeg, 20.0f);
    EXPECT_TRUE(workspace.document.hasUnsavedEdits());
}

TEST(HotReload, WhatASceneIncludesIsWatched) {
    write("part.xml", "<scene version=\"3.0.0\"><shape type=\"sphere\"/></scene>");
    write("whole.xml", "<scene version=\"3.0.0\"><include filename=\"part.xml\"/></scene>");
    const auto files = filesOf(*loadScene("whole.xml"));
    EXPECT_THAT(files,
                testing::ElementsAre(fs::absolute("part.xml").string(), fs::absolute("whole.xml").string()));
}

/// A square that a second animation moves from 4 to 8 in 2 seconds, grey, or red or green by its variants.
std::string choosyGltf(float grey) {
    const auto colored = [](const std::string& color) {
        return R"({"pbrMetallicRoughness": {"metallicFactor": 0, "baseColorFactor": [)" + color + "]}}";
    };
    const std::string buffer = kSquare + packed<float>({0, 2, 4, 0, 0, 8, 0, 0});
    const std::string views =
        R"("bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 92, "byteLength": 8},
        {"buffer": 0, "byteOffset": 100, "byteLength": 24}], "accessors": [
        {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
        {"bufferView": 1, "componentType": 5126, "count": 2, "type": "SCALAR", "min": [0], "max": [2]},
        {"bufferView": 2, "componentType": 5126, "count": 2, "type": "VEC3"}])";
    return gltf(
        R"("extensions": {"KHR_materials_variants": {"variants": [{"name": "red"}, {"name": "green"}]}},
        "animations": [{"name": "rest", "channels": [], "samplers": []}, {"name": "walk", "channels":
        [{"sampler": 0, "target": {"node": 0, "path": "translation"}}], "samplers": [{"input": 1, "output": 2}]}],
        "materials": [)" +
            colored(std::to_string(grey) + ", 0.5, 0.5, 1") + "," + colored("1, 0, 0, 1") + "," +
            colored("0, 1, 0, 1") + "]",
        R"("meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "mode": 6, "material": 0, "extensions":
        {"KHR_materials_variants": {"mappings": [{"material": 1, "variants": [0]},
        {"material": 2, "variants": [1]}]}}}]}])",
        kNode, views, buffer);
}

TEST(HotReload, AGltfFileIsReadAgainAsItWasOpenedOrAsIsChosen) {
    const std::string path = "choosy.gltf";
    write(path, choosyGltf(0.5f));
    Workspace workspace(makeCpuBackend(1));
    SceneReading& reading = workspace.sceneFiles.reading;
    const SceneDescription& draft = workspace.document.draft();
    const auto colorIs = [&](const Vec3& color) {
        const Object& square = draft.objects[0];
        return draft.materials[static_cast<size_t>(square.material)].color.value == color;
    };
    reading = {.path = path, .options = {.parameters = {{"variant", "green"}}}};
    workspace.adopt(*loadScene(path, reading.options));
    ASSERT_TRUE(colorIs({0, 1, 0}));
    workspace.document.draft().camera.position = {0, 1, 9};
    workspace.document.noteSaved(workspace.document.posted());
    setParameter(&reading.options.parameters, "animation", "walk");
    setParameter(&reading.options.parameters, "time", "1");
    workspace.sceneFiles.reload(path);
    runUntil(&workspace, [&] { return draft.objects[0].objectToWorld.translation.x == 6.0f; });
    EXPECT_TRUE(colorIs({0, 1, 0}));
    EXPECT_EQ(reading.choices.variants.size(), 2u);
    EXPECT_EQ(reading.choices.animations[1].endSeconds, 2.0f);
    EXPECT_EQ(draft.camera.position, Vec3(0, 1, 9)) << "the camera stays";
    setParameter(&reading.options.parameters, "variant", "");
    workspace.sceneFiles.reload(path);
    runUntil(&workspace, [&] { return colorIs({0.5f, 0.5f, 0.5f}); });
    rewrite(path, choosyGltf(0.25f));
    runUntil(&workspace, [&] { return colorIs({0.25f, 0.5f, 0.5f}); });
    EXPECT_EQ(draft.objects[0].objectToWorld.translation.x, 6.0f) << "at the time that was chosen";
    write("other.json", kScene);
    workspace.sceneFiles.open("other.json");
    runUntil(&workspace, [&] { return draft.path == "other.json"; });
    EXPECT_TRUE(reading.choices.isEmpty());
}

TEST(HotReload, ThePanelOffersWhatTheFileHas) {
    write("choosy.gltf", choosyGltf(0.5f));
    write("choose.txt", R"(expect "Scene/Variant" red
expect "Scene/Animation" walk
expect "Scene/Time" 0.5
set "Scene/Variant" green
wait jobs
wait picture
expect "Scene/Variant" green
set "Scene/Time" 1.5
wait jobs
expect "Scene/Time" 1.5
expect no-widget "Scene/Choice note"
set "Aperture" 20
wait picture
expect "Scene/Choice note" "A choice reads the file again, without the unsaved edits; undo brings them back."
set "Scene/Animation" rest
wait jobs
expect no-widget "Scene/Time"
set "Scene/File" scene.json
click "Scene/Open"
wait jobs
expect no-widget "Scene/Variant"
expect no-error
)");
    write("scene.json", kScene);
    expectPlayed(
        run("view choosy.gltf --headless --threads 1 --script choose.txt -D variant=0 -D animation=walk "
            "-D time=0.5"));
}

/// Long enough that frames are drawn meanwhile: what it brings must be on screen when the wait ends.
TEST(HotReload, WaitingForJobsEndsWithWhatTheyBroughtOnScreen) {
    std::string slow = choosyGltf(0.5f);
    slow.insert(slow.rfind('}'), 50'000'000, ' ');
    write("slow.gltf", slow);
    expectPlayed(play(R"(set "Scene/File" slow.gltf
click "Scene/Open"
wait jobs
expect "Scene/Variant" –
expect no-error
)"));
}

/// Also where the checkpoint opens it: on the disk's next change it is read as it was then.
TEST(HotReload, ACheckpointKnowsWhatWasChosen) {
    write("choosy.gltf", choosyGltf(0.5f));
    write("save.txt", R"(wait finished
open "Checkpoint"
wait frames 2
set "Checkpoint file" choosy.glintfilm
click "Checkpoint/Save"
wait jobs
expect no-error
)");
    expectPlayed(
        run("view choosy.gltf --headless --threads 1 --passes 2 --script save.txt -D variant=green -D "
            "animation=walk -D time=0.5"));
    write("resume.txt", R"(wait jobs
expect "Scene/Variant" green
expect "Scene/Animation" walk
expect "Scene/Time" 0.5
set "Scene/Variant" red
wait jobs
wait picture
expect "Scene/Variant" red
expect "Scene/Time" 0.5
expect no-error
)");
    expectPlayed(run("view choosy.glintfilm --headless --threads 1 --script resume.txt"));
}

}  // namespace
}  // namespace glint
