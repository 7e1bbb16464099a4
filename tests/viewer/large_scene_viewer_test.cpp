// Thousands of objects: what the window does in a frame is counted, not timed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/render/backend.h"
#include "tests/viewer/play_script.h"
#include "viewer/model/outliner.h"
#include "viewer/model/workspace.h"

namespace glint {
namespace {

using namespace test;

constexpr int kObjects = 10000;

std::string largeScene() {
    std::string objects;
    for (int i = 0; i < kObjects; ++i) {
        objects += (i > 0 ? ",\n" : "") + std::string(R"({"type": "sphere", "name": "ball )") +
                   std::to_string(i + 1) + R"(", "material": "grey", "center": [)" + std::to_string(i % 100) +
                   ", 0, " + std::to_string(-(i / 100)) + R"(], "radius": 0.4})";
    }
    return R"({"glint": 1, "resolution": [64, 48],
  "camera": {"position": [50, 60, 70], "target": [50, 0, -50]},
  "materials": {"grey": {"type": "diffuse", "color": 0.5}},
  "objects": [)" +
           objects + R"(], "environment": {"color": 1}})";
}

size_t countOf(const std::string& text, const std::string& part) {
    size_t count = 0;
    for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
        ++count;
    }
    return count;
}

TEST(LargeScene, OnlyRowsThatAreSeenAreDrawn) {
    write("large.json", largeScene());
    write("large.txt", R"(
wait passes 1
click "Go to Outliner"
wait frames 4
print widgets
move "Object 2: ball 2"
wheel -9000
wait frames 4
expect no-widget "Object 2: ball 2"
set "Search" "ball 999"
wait frames 3
expect widget "Object 999: ball 999"
)");
    const Ran ran = run("view large.json --headless --threads 1 --script large.txt");
    expectPlayed(ran);
    EXPECT_LE(countOf(ran.output, "\"Outliner/Object "), 14u);
    EXPECT_GE(countOf(ran.output, "\"Outliner/Object "), 8u);
}

TEST(LargeScene, LabelsAreMadeForRowsThatAreAskedFor) {
    SceneDescription scene;
    scene.objects.resize(kObjects);
    SceneDocument document;
    document.adopt(scene);
    Outliner outliner;
    for (int frame = 0; frame < 100; ++frame) {
        outliner.update(document);
        EXPECT_EQ(outliner.at(5000).label, "Object 5001");
        document.draft().objects[7].objectToWorld.translation.x += 1.0f;
        (void)document.takeEdits();
    }
    EXPECT_EQ(outliner.labelsMade(), 100u) << "also while something is dragged";
    outliner.search = "object 9";
    for (int frame = 0; frame < 100; ++frame) {
        outliner.update(document);
    }
    EXPECT_EQ(outliner.labelsMade(), 100u + kObjects) << "looked through once";
}

/// A frame without input looks through no objects; what it takes is still seen at the next one with input, or
/// when a job has ended.
TEST(LargeScene, FramesWithoutInputCompareNothing) {
    SceneDescription scene;
    scene.resolution = {8, 8};
    scene.objects.resize(kObjects);
    Workspace workspace(makeCpuBackend(1));
    workspace.adopt(scene);
    workspace.commitEdits(false, true);
    const uint64_t before = workspace.document.comparisons();
    for (int frame = 0; frame < 50; ++frame) {
        workspace.commitEdits(false, false);
    }
    EXPECT_EQ(workspace.document.comparisons(), before);
    workspace.document.draft().objects[5].objectToWorld.translation.x = 3.0f;
    EXPECT_FALSE(workspace.commitEdits(false, false));
    EXPECT_TRUE(workspace.commitEdits(false, true));
    EXPECT_EQ(workspace.document.comparisons(), before + 1);
    workspace.document.draft().objects[5].objectToWorld.translation.x = 4.0f;
    workspace.jobs.start([]() -> JobQueue::Completion { return [] {}; }, true);
    while (workspace.jobs.running() > 0) {
        workspace.refresh();
    }
    EXPECT_TRUE(workspace.commitEdits(false, false)) << "a job may have edited it";
}

}  // namespace
}  // namespace glint
