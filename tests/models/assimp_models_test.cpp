// The OBJ and PLY files of Debian's package assimp-testmodels, which collects what troubled other programs.
// Skipped where it is not installed. tests/README.md has the table of results.
#include <filesystem>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/file_path.h"
#include "engine/io/scene_loader.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

TEST(AssimpModels, OpenOrAreRefusedForAReason) {
    const fs::path folder = "/usr/share/assimp/models";
    if (!fs::exists(folder)) { GTEST_SKIP() << folder << " is not here: apt-get install assimp-testmodels"; }
    const std::map<std::string, std::string> refused = {{"empty.obj", "no faces"},
                                                        {"empty.ply", "expected the word ply"},
                                                        {"issue623.ply", "the line ends"},
                                                        {"malformed.obj", "there is no vertex 12"},
                                                        {"number_formats.obj", "found \"3.1+e2\""},
                                                        {"point_cloud.obj", "a point cloud"},
                                                        {"points.ply", "a point cloud"},
                                                        {"pond.0.ply", "are left in the file"},
                                                        {"testline.obj", "lines"},
                                                        {"testpoints.obj", "a point cloud"}};
    int opened = 0;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        if (!hasExtension(name, ".obj .ply")) { continue; }
        const auto scene = loadScene(entry.path().string());
        const auto reason = refused.find(name);
        if (reason == refused.end()) {
            EXPECT_TRUE(scene) << scene.error().format();
            ++opened;
        } else {
            ASSERT_FALSE(scene) << name;
            EXPECT_THAT(scene.error().format(), testing::HasSubstr(reason->second));
        }
    }
    EXPECT_GE(opened, 24);
}

}  // namespace
}  // namespace glint
