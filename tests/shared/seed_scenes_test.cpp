// Scenes that are not part of the repository, in ../shared/seed-scenes: text scenes are read or say what
// they lack, large meshes are read whole, and what was saved renders the same. Skipped where the folder
// is missing.
#include <filesystem>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/obj_loader.h"
#include "engine/io/scene_loader.h"
#include "tests/support/film_bits.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

class SeedScenes : public testing::Test {
  protected:
    void SetUp() override {
        if (!fs::exists(folder_)) { GTEST_SKIP() << folder_ << " is not here"; }
    }

    const fs::path folder_ = fs::path(GLINT_SHARED_DIR) / "seed-scenes";
};

TEST_F(SeedScenes, TextScenesAreReadAndSayWhatTheyLack) {
    const std::map<std::string, std::string> lacking = {{"scene12", "texture/jupyter.png\" (and 2 more)"},
                                                        {"scene16_global", "world_cloud.jpg"},
                                                        {"scene16_global_diff", "world_cloud.jpg"},
                                                        {"scene19_sibenik", "Alucy.obj\""},
                                                        {"scene21_livingroom", "Ceramic.obj\" (and 2 more)"}};
    int count = 0;
    for (const auto& entry : fs::directory_iterator(folder_ / "testcases")) {
        const auto scene = loadScene(entry.path().string());
        ASSERT_TRUE(scene) << scene.error().format();
        const auto expected = lacking.find(entry.path().stem().string());
        const auto saysMissing = testing::Contains(
            testing::HasSubstr(expected == lacking.end() ? "are missing" : expected->second));
        if (expected == lacking.end()) {
            EXPECT_THAT(scene->warnings, testing::Not(saysMissing)) << entry.path();
        } else {
            EXPECT_THAT(scene->warnings, saysMissing) << entry.path();
        }
        ++count;
    }
    EXPECT_EQ(count, 29);
}

TEST_F(SeedScenes, SavedAndLoadedAgainRenderTheSame) {
    for (const char* name : {"scene03_sphere", "scene04_axes", "scene06_bunny_1k", "scene11_smallpt",
                             "scene18_dof", "scene21_livingroom"}) {
        test::expectSameFilmWhenSaved((folder_ / "testcases" / name).string() + ".txt");
    }
    test::expectSameFilmWhenSaved((folder_ / "mesh" / "bunny_1k_vn.obj").string());
}

size_t trianglesIn(const fs::path& folder) {
    size_t sum = 0;
    for (const auto& entry : fs::directory_iterator(folder)) {
        const Result<MeshFile> scene = loadObj(entry.path().string());
        EXPECT_TRUE(scene) << scene.error().format();
        for (const MeshPart& part : scene ? scene->parts : std::vector<MeshPart>{}) {
            sum += part.mesh->triangleCount();
        }
    }
    return sum;
}

TEST_F(SeedScenes, LargeMeshesLoadWhole) {
    EXPECT_EQ(trianglesIn(folder_ / "mesh" / "sibenik"), 75165u);
    EXPECT_EQ(trianglesIn(folder_ / "mesh" / "living_room"), 167288u);
}

}  // namespace
}  // namespace glint
