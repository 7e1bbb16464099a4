// What a load opens is known, on whatever thread it was read.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/scene_loader.h"
#include "tests/support/temp_folder.h"

namespace glint::test {
namespace {

TEST(FilesRead, MeshesThatAreReadSeveralAtOnceAreKnown) {
    const TempFolder folder;
    std::string text =
        "LookAt 0 0 5 0 0 0 0 1 0\nCamera \"perspective\"\nWorldBegin\nLightSource \"infinite\"\n";
    std::vector<std::string> meshes;
    for (int i = 0; i < 20; ++i) {
        const std::string name = "mesh" + std::to_string(i) + ".ply";
        meshes.push_back(folder.write(
            name,
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
            "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
            "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"));
        text += "Shape \"plymesh\" \"string filename\" \"" + name + "\"\n";
    }
    const auto scene = loadScene(folder.write("scene.pbrt", text));
    ASSERT_TRUE(scene) << scene.error().format();
    for (const std::string& mesh : meshes) {
        EXPECT_THAT(scene->filesRead, testing::Contains(testing::EndsWith(mesh.substr(mesh.rfind('/')))))
            << mesh;
    }
}

}  // namespace
}  // namespace glint::test
