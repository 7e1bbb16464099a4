// Example scenes: what `glint example` writes opens without a remark, is the same each time, and has as many
// triangles as it is said to have.
#include "engine/examples/example_scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/scene_loader.h"
#include "tests/support/temp_folder.h"

namespace glint::examples {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double kQuickDetail = 0.03;
constexpr uint64_t kPromisedTriangles = 500'000;

uint64_t trianglesOf(const SceneDescription& scene) {
    uint64_t triangles = 0;
    for (const Mesh& mesh : scene.meshes) {
        triangles += mesh.data->triangleCount();
    }
    return triangles;
}

TEST(ExampleScenes, OpenWithoutARemark) {
    for (const ExampleScene& example : exampleScenes()) {
        SCOPED_TRACE(example.name);
        const test::TempFolder folder;
        const auto triangles = writeExampleScene(example, kQuickDetail, folder.path(), false);
        ASSERT_TRUE(triangles) << triangles.error().format();
        const auto scene = loadScene(folder.path("scene.json"), {});
        ASSERT_TRUE(scene) << scene.error().format();
        EXPECT_THAT(scene->warnings, IsEmpty());
        EXPECT_EQ(trianglesOf(*scene), *triangles) << "nothing is left out or repaired";
        EXPECT_GT(scene->textures.size(), 5u);
        for (const Material& material : scene->materials) {
            EXPECT_TRUE(material.bump.texture < 0 || material.bumpHeight > 0.0f) << material.name;
        }
    }
}

TEST(ExampleScenes, AreTheSameEachTime) {
    for (const ExampleScene& example : exampleScenes()) {
        SCOPED_TRACE(example.name);
        const test::TempFolder first, second;
        ASSERT_TRUE(writeExampleScene(example, kQuickDetail, first.path(), false));
        ASSERT_TRUE(writeExampleScene(example, kQuickDetail, second.path(), false));
        ASSERT_EQ(first.size(), second.size());
        for (const auto& entry : std::filesystem::directory_iterator(first.path())) {
            const std::string name = entry.path().filename().string();
            EXPECT_EQ(test::TempFolder::read(first.path(name)), test::TempFolder::read(second.path(name)))
                << name;
        }
    }
}

TEST(ExampleScenes, HaveHalfAMillionTriangles) {
    for (const ExampleScene& example : exampleScenes()) {
        SCOPED_TRACE(example.name);
        const test::TempFolder folder;
        const auto triangles = writeExampleScene(example, 1.0, folder.path(), false);
        ASSERT_TRUE(triangles) << triangles.error().format();
        EXPECT_GE(*triangles, kPromisedTriangles);
    }
}

TEST(ExampleScenes, ReplaceNothingUnasked) {
    const test::TempFolder folder;
    const std::string other = folder.write("notes.txt", "mine");
    const ExampleScene& example = exampleScenes()[0];
    const auto refused = writeExampleScene(example, kQuickDetail, folder.path(), false);
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().message, HasSubstr("--overwrite"));
    EXPECT_EQ(folder.size(), 1u);
    EXPECT_TRUE(writeExampleScene(example, kQuickDetail, folder.path(), true));
    EXPECT_EQ(test::TempFolder::read(other), "mine");
    const auto unwritable = writeExampleScene(example, kQuickDetail, other + "/folder", false);
    EXPECT_FALSE(unwritable) << "a file is no folder";
}

}  // namespace
}  // namespace glint::examples
