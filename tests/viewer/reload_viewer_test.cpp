// Files that other programs change are read again, and the camera stays.
#include <chrono>
#include <filesystem>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/scene_loader.h"
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
    EXPECT_EQ(workspace.history.states().back().name, "Reload reloaded.json");
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

}  // namespace
}  // namespace glint
