// What keeps work from being lost: questions before files are replaced and edits are dropped, and sessions
// that are offered again.
#include <csignal>
#include <cstdlib>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/atomic_file.h"
#include "engine/render/checkpoint.h"
#include "tests/viewer/play_script.h"

namespace glint {
namespace {

namespace fs = std::filesystem;
using namespace test;
using testing::HasSubstr;

TEST(SafetyNet, AFileThatIsThereIsNotReplacedUnasked) {
    write("old.png", "not from here");
    const std::string start =
        "wait finished\nopen \"Checkpoint\"\nwait frames 2\nset \"PNG file\" old.png\n"
        "click \"Save PNG\"\nwait frames 3\nexpect widget \"Replace\"\n";
    expectPlayed(
        play(start + "click \"Keep the old file\"\nwait jobs\nexpect no-widget \"Replace\"\n", "--passes 2"));
    EXPECT_EQ(*readFile("old.png"), "not from here");
    expectPlayed(play(start + "key escape\nwait frames 3\nexpect no-widget \"Replace\"\n", "--passes 2"));
    EXPECT_EQ(*readFile("old.png"), "not from here");
    // Once is enough.
    expectPlayed(play(start + "screenshot replace.png\nclick \"Replace\"\nwait jobs\n"
                              "click \"Save PNG\"\nwait jobs\nexpect message \"Saved\"\nexpect no-widget "
                              "\"Replace\"\n",
                      "--passes 2"));
    EXPECT_NE(*readFile("old.png"), "not from here");
}

TEST(SafetyNet, ACheckpointIsNotReplacedByOneOfAnotherSceneUnasked) {
    write("other.json", kScene);
    std::filesystem::remove("own.glintfilm");
    const std::string save = "click \"Checkpoint/Save\"\nwait jobs\nwait frames 3\n";
    expectPlayed(
        play("wait finished\nopen \"Checkpoint\"\nwait frames 2\nset \"Checkpoint file\" own.glintfilm\n" +
                 save + "expect message \"Saved\"\nset \"Aperture\" 20\nwait finished\n" + save +
                 "expect no-widget \"Replace\"\ndrop \"other.json\"\nwait jobs\nwait finished\n" + save +
                 "expect widget \"Replace\"\nclick \"Replace\"\nwait jobs\nexpect message \"Saved\"\n" +
                 save + "expect no-widget \"Replace\"\n",
             "--passes 2"));
    EXPECT_THAT(readCheckpointInfo("own.glintfilm")->scenePath, HasSubstr("other.json"));
}

TEST(SafetyNet, ClosingAsksWhereEditsWouldBeLost) {
    const std::string quit = "key ctrl down\nkey q\nkey ctrl up\nwait frames 4\n";
    // The script fails where the window has closed before its end.
    const auto closes = [](const std::string& script) {
        const Ran ran = play(script + "expect \"Aperture\" 123456\n", "--passes 2");
        return ran.exitCode == 0;
    };
    EXPECT_TRUE(closes("wait finished\n" + quit)) << "nothing was edited";
    EXPECT_TRUE(closes("wait finished\ndrag \"Image\" 50 5\nwait finished\n" + quit)) << "only looked around";
    const std::string edit = "wait finished\nset \"Aperture\" 20\nwait finished\n";
    EXPECT_FALSE(closes(edit + quit));
    EXPECT_FALSE(closes(edit + quit + "click \"Go on\"\nwait frames 3\nexpect no-widget \"Go on\"\n"));
    EXPECT_FALSE(closes(edit + quit + "key escape\nwait frames 3\n"));
    EXPECT_TRUE(closes(edit + quit + "screenshot close.png\nclick \"Close\"\nwait frames 9\n"));
    EXPECT_FALSE(fs::exists("scene-edited.json"));
    EXPECT_TRUE(closes(edit + quit + "click \"Save and close\"\nwait jobs\nwait frames 9\n"));
    EXPECT_THAT(*readFile("scene-edited.json"), HasSubstr("\"apertureDiameter\": 0.02"));
    EXPECT_TRUE(closes(edit + "key ctrl down\nkey z\nkey ctrl up\nwait finished\n" + quit)) << "undone";
}

TEST(SafetyNet, ACheckpointBringsItsSceneAlong) {
    expectPlayed(
        play("wait finished\nset \"Aperture\" 20\nwait finished\nopen \"Checkpoint\"\nwait frames 2\n"
             "set \"Checkpoint file\" edited.glintfilm\nclick \"Checkpoint/Save\"\nwait jobs\n",
             "--passes 12"));
    const auto scene = loadCheckpointScene("edited.glintfilm");
    ASSERT_TRUE(scene) << scene.error().format();
    EXPECT_EQ(scene->camera.apertureDiameter, 0.02f);
    EXPECT_EQ(fs::path(scene->path).filename(), "scene.json");
    expectPlayed(
        play("wait finished\ndrop edited.glintfilm\nwait jobs\nwait finished\n"
             "expect message \"with the scene it is of\"\nexpect \"Aperture\" 20\n"
             "expect passes-at-least 12\n"
             "key ctrl down\nkey z\nkey z\nkey ctrl up\nwait picture\nexpect \"Aperture\" 0\n",
             "--passes 6"));
}

TEST(SafetyNet, ACheckpointIsOpenedLikeAScene) {
    expectPlayed(
        play("wait finished\nset \"Aperture\" 20\nwait finished\nopen \"Checkpoint\"\nwait frames 2\n"
             "set \"Checkpoint file\" alone.glintfilm\nclick \"Checkpoint/Save\"\nwait jobs\n",
             "--passes 9"));
    write("script.txt", "wait jobs\nwait finished\nexpect \"Aperture\" 20\nexpect passes-at-least 9\n");
    expectPlayed(run("view alone.glintfilm --headless --threads 1 --passes 3 --script script.txt"));
    write("no.glintfilm", "something else");
    const Ran ran = run("view no.glintfilm --headless --passes 3");
    EXPECT_EQ(ran.exitCode, 1);
    EXPECT_THAT(ran.output, HasSubstr("no.glintfilm: is not a Glint checkpoint"));
}

/// A triangle whose picture stands inside the file.
const std::string kEmbedded =
    R"({)"
    "\n"
    R"(  "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],)"
    "\n"
    R"(  "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "ma)"
    R"(terial": 0}]}],)"
    "\n"
    R"(  "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, "metallicFactor": 0)"
    R"(}}],)"
    "\n"
    R"(  "textures": [{"source": 0}], "images": [{"uri": "data:image/png;base64,iVBORw0KGgoAAAANSUhEUg)"
    R"(AAAAIAAAACCAIAAAD91JpzAAAAFElEQVR42mP4z8DAAMIM////ZwAAHu8E/HMcU8wAAAAASUVORK5CYII="}],)"
    "\n"
    R"(  "accessors": [)"
    "\n"
    R"(    {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [-1, 0, 0], "ma)"
    R"(x": [1, 2, 0]},)"
    "\n"
    R"(    {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC2"},)"
    "\n"
    R"(    {"bufferView": 2, "componentType": 5123, "count": 3, "type": "SCALAR"}],)"
    "\n"
    R"(  "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 36}, {"buffer": 0, "byteOffset":)"
    R"( 36, "byteLength": 24},)"
    "\n"
    R"(                  {"buffer": 0, "byteOffset": 60, "byteLength": 6}],)"
    "\n"
    R"(  "buffers": [{"byteLength": 66, "uri": "data:application/octet-stream;base64,AACAvwAAAAAAAAAAA)"
    R"(ACAPwAAAAAAAAAAAAAAAAAAAEAAAAAAAAAAAAAAgD8AAIA/AACAPwAAAD8AAAAAAAABAAIA"}])"
    "\n"
    R"(})"
    "\n";

/// Plays in the background until `ready` is there, then kills it as a crash would.
void playAndKill(const std::string& script, const std::string& ready,
                 const std::string& scene = "scene.json") {
    write("scene.json", kScene);
    write("crash.txt", script + "screenshot " + ready + "\nwait seconds 600\n");
    fs::remove(ready);
    std::system(
        (std::string(GLINT_PROGRAM) + " view " + scene +
         " --headless --threads 1 --passes 12 --recovery 0.1 --script crash.txt "
         "> crash.log 2>&1 & echo $! > crash.pid; i=0; while [ ! -s " +
         ready +
         " ] && [ $i -lt 1200 ]; do sleep 0.1; i=$((i+1)); done; sleep 0.3; kill -9 $(cat crash.pid); wait")
            .c_str());
    ASSERT_TRUE(fs::exists(ready)) << *readFile("crash.log");
}

TEST(SafetyNet, AKilledSessionIsOfferedAgain) {
    setenv("XDG_STATE_HOME", fs::absolute("state").c_str(), 1);
    const fs::path folder = fs::path("state") / "glint" / "sessions";
    playAndKill("wait finished\nset \"Aperture\" 20\nwait finished\nwait seconds 1\n", "ready.png");
    ASSERT_FALSE(fs::is_empty(folder)) << "what it kept";
    const std::string recovery = "--passes 6 --recovery 3600";
    expectPlayed(
        play("wait finished\nwait frames 3\nexpect widget \"Restore\"\nscreenshot recovery.png\n"
             "expect \"Aperture\" 0\nclick \"Restore\"\nwait jobs\nwait finished\n"
             "expect \"Aperture\" 20\nexpect passes-at-least 12\n"
             "expect no-widget \"Restore\"\n",
             recovery));
    EXPECT_TRUE(fs::is_empty(folder)) << "a session that ends leaves nothing";
    expectPlayed(play("wait finished\nwait frames 3\nexpect no-widget \"Restore\"\n", recovery));
    playAndKill("wait finished\nwait seconds 1\n", "ready.png");
    expectPlayed(
        play("wait finished\nwait frames 3\nclick \"Discard\"\nwait frames 3\n"
             "expect no-widget \"Restore\"\n",
             recovery));
    EXPECT_TRUE(fs::is_empty(folder));
}

TEST(SafetyNet, ImagesInMemoryAreKeptToo) {
    setenv("XDG_STATE_HOME", fs::absolute("state").c_str(), 1);
    const fs::path folder = fs::path("state") / "glint" / "sessions";
    fs::remove_all("state");
    fs::remove_all("saved");
    fs::create_directories("saved");
    write("embedded.gltf", kEmbedded);
    playAndKill(
        "wait passes 1\nopen \"Picture\"\nwait frames 2\nset \"Width\" 64\nset \"Height\" 48\nwait "
        "finished\nwait seconds 1\n",
        "ready.png", "embedded.gltf");
    ASSERT_FALSE(fs::is_empty(folder));
    write("embedded.gltf", kEmbedded.substr(0, kEmbedded.find("\"images\"")) +
                               "\"images\": [{\"uri\": \"no.png\"}]" +
                               kEmbedded.substr(kEmbedded.find("}],\n  \"accessors\"") + 2));
    expectPlayed(
        play("wait finished\nwait frames 3\nclick \"Restore\"\nwait jobs\nwait finished\n"
             "expect passes-at-least 12\nopen \"Checkpoint\"\nwait frames 3\n"
             "set \"Scene file\" saved/scene.json\nclick \"Save scene\"\nwait jobs\n",
             "--passes 6 --recovery 3600"));
    EXPECT_TRUE(fs::is_empty(folder)) << "with its files";
    const Ran info = run("info saved/scene.json");
    EXPECT_EQ(info.exitCode, 0);
    EXPECT_THAT(info.output, HasSubstr("textures   1"));
    EXPECT_EQ(std::distance(fs::directory_iterator("saved"), {}), 2) << "the scene and its picture";
}

void expectRestored(const std::string& hidden) {
    setenv("XDG_STATE_HOME", fs::absolute("state").c_str(), 1);
    fs::remove_all("state");
    std::string two(kScene);
    two.insert(two.find("\"objects\": [") + 12, hidden + ", ");
    write("two.json", two);
    playAndKill(
        "wait finished\nmove \"Image\"\npress\nrelease\nwait frames 3\nkey h\nwait finished\nwait "
        "seconds 1\n",
        "ready.png", "two.json");
    expectPlayed(
        play("wait finished\nwait frames 3\nclick \"Restore\"\nwait jobs\nwait finished\n"
             "expect passes-at-least 12\nopen \"Object\"\nwait frames 3\n"
             "move \"Image\"\npress\nrelease\nwait frames 3\nexpect no-widget \"Object/Duplicate\"\n"
             "click \"Show all\"\nwait picture\nmove \"Image\"\npress\nrelease\nwait frames 3\n"
             "expect widget \"Object/Duplicate\"\nexpect \"Object/Material\" grey\n",
             "--passes 6 --recovery 3600"));
    EXPECT_TRUE(fs::is_empty(fs::path("state") / "glint" / "sessions"));
}

TEST(SafetyNet, WhatWasHiddenIsRestored) {
    expectRestored(R"({"type": "sphere", "material": "grey", "center": [1.6, 1, 0], "radius": 0.2})");
}

TEST(SafetyNet, HiddenMeshesAreRestored) {
    expectRestored(
        R"({"type": "mesh", "material": "grey", "mesh": {"generator": "sphere", "triangleCount": 400},
        "transform": [{"scale": 0.2}, {"translate": [1.6, 1, 0]}]})");
}

TEST(SafetyNet, ASessionThatLivesIsNobodysLeftover) {
    setenv("XDG_STATE_HOME", fs::absolute("state").c_str(), 1);
    write("scene.json", kScene);
    write("long.txt", "wait finished\nwait seconds 1\nscreenshot lives.png\nwait seconds 600\n");
    std::system((std::string(GLINT_PROGRAM) +
                 " view scene.json --headless --threads 1 --passes 2 --recovery 0.1 --script long.txt "
                 "> long.log 2>&1 & echo $! > long.pid; i=0; while [ ! -s lives.png ] && [ $i -lt 1200 ]; do "
                 "sleep 0.1; i=$((i+1)); done")
                    .c_str());
    const Ran ran =
        play("wait finished\nwait frames 3\nexpect no-widget \"Restore\"\n", "--passes 2 --recovery 3600");
    std::system("kill -9 $(cat long.pid)");
    expectPlayed(ran);
}

}  // namespace
}  // namespace glint
