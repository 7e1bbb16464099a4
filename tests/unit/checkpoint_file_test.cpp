// A checkpoint that is saved again and again never throws away a film that is not its own.
#include "viewer/base/checkpoint_file.h"

#include <gtest/gtest.h>

#include "tests/support/capture.h"
#include "tests/support/temp_folder.h"

namespace glint {
namespace {

using test::captureOf;
using test::TempFolder;

SessionCapture filmOf(uint32_t passes, const std::string& ofScene = {}, float fov = 40.0f) {
    SceneDescription scene;
    scene.path = ofScene;
    scene.camera.verticalFovDeg = fov;
    scene.resolution = {4, 3};
    Film film(4, 3);
    for (uint32_t pass = 0; pass < passes; ++pass) {
        film.commit(std::vector<PixelSample>(12), pass, 1);
    }
    return captureOf(scene, std::move(film), 1.0);
}

uint32_t passesIn(const std::string& path) {
    const auto info = readCheckpointInfo(path);
    return info ? info->passes : 0;
}

TEST(CheckpointFile, ReplacesItsOwnAndAShorterOneThatWasThere) {
    const TempFolder folder;
    const std::string path = folder.path("a.film");
    ASSERT_TRUE(saveCheckpoint(path, filmOf(2)));
    CheckpointFile file(path, false);
    for (const uint32_t passes : {2u, 3u, 9u}) {
        EXPECT_TRUE(file.save(filmOf(passes)));
        EXPECT_EQ(passesIn(path), passes);
    }
    EXPECT_EQ(folder.size(), 1u);
}

TEST(CheckpointFile, KeepsALongerOneThatWasThere) {
    const TempFolder folder;
    const std::string path = folder.path("a.film");
    ASSERT_TRUE(saveCheckpoint(path, filmOf(5)));
    CheckpointFile file(path, false);
    EXPECT_TRUE(file.save(filmOf(4)));
    EXPECT_TRUE(file.save(filmOf(6))) << "stays where it went";
    EXPECT_EQ(passesIn(path), 5u);
    EXPECT_EQ(passesIn(folder.path("a-2.film")), 6u);
    EXPECT_EQ(folder.size(), 2u);

    CheckpointFile replacing(path, true);
    EXPECT_TRUE(replacing.save(filmOf(1)));
    EXPECT_EQ(passesIn(path), 1u);
}

TEST(CheckpointFile, KeepsWhatAnotherRenderSavedMeanwhile) {
    const TempFolder folder;
    const std::string path = folder.path("a.film");
    CheckpointFile first(path, false), second(path, false);
    EXPECT_TRUE(first.save(filmOf(1)));
    EXPECT_TRUE(second.save(filmOf(3)));
    EXPECT_TRUE(first.save(filmOf(2)));
    EXPECT_EQ(passesIn(path), 2u);
    EXPECT_EQ(passesIn(folder.path("a-2.film")), 3u);
}

TEST(CheckpointFile, KeepsOneOfAnotherScene) {
    const TempFolder folder;
    const std::string path = folder.path("a.film");
    ASSERT_TRUE(saveCheckpoint(path, filmOf(2, "one.json")));
    CheckpointFile other(path, false);
    EXPECT_TRUE(other.save(filmOf(3, "two.json", 50.0f)));
    EXPECT_EQ(passesIn(path), 2u);
    EXPECT_EQ(passesIn(folder.path("a-2.film")), 3u);

    CheckpointFile edited(path, false);
    EXPECT_TRUE(edited.save(filmOf(4, "./one.json", 50.0f))) << "of the same file, edited";
    EXPECT_EQ(passesIn(path), 4u);
    CheckpointFile copied(path, false);
    EXPECT_TRUE(copied.save(filmOf(5, "copy.json", 50.0f))) << "of a file that shows the same";
    EXPECT_EQ(passesIn(path), 5u);
    CheckpointFile replacing(path, true);
    EXPECT_TRUE(replacing.save(filmOf(6, "two.json")));
    EXPECT_EQ(passesIn(path), 6u);
}

TEST(CheckpointFile, WritesToDevicesAndNowhere) {
    EXPECT_TRUE(CheckpointFile("", false).save(filmOf(1)));
    EXPECT_TRUE(CheckpointFile("/dev/null", false).save(filmOf(1)));
    EXPECT_FALSE(CheckpointFile("/dev/full", false).save(filmOf(1)));
}

}  // namespace
}  // namespace glint
