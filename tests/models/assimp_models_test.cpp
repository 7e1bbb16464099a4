// The OBJ, PLY, STL and glTF files of Debian's package assimp-testmodels, which collects what troubled other
// programs. Skipped where it is not installed. tests/README.md has the table of results.
#include <filesystem>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/file_path.h"
#include "engine/io/scene_loader.h"

namespace glint {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// Where it is in the folder, and what the error says.
constexpr std::pair<const char*, const char*> kRefused[] = {
    {"empty.obj", "no faces"},
    {"empty.ply", "expected the word ply"},
    {"issue623.ply", "the line ends"},
    {"malformed.obj", "there is no vertex 12"},
    {"point_cloud.obj", "a point cloud"},
    {"points.ply", "a point cloud"},
    {"pond.0.ply", "are left in the file"},
    {"testline.obj", "lines"},
    {"testpoints.obj", "a point cloud"},
    {"CesiumMilkTruck", "\"asset\" object not found"},
    {"/glTF/", "is glTF 1.0; expected 2.0"},
    {"techniqueWebGL", "needs KHR_technique_webgl"},
    {"BoxWithInfinites", "a position is not finite"},
    {"IndexOutOfRange", "an index is"},
    {"MissingBin", "File not found : BoxTextured0.bin"},
    {"RecursiveNodes", "node 0 has two parents"},
    {"sceneWrongType", "File not found : BoxTextured0.bin"},
    {"TestNoRootNode", "has no triangles"},
    {"PrimitiveMode_00", "has no triangles"},
    {"PrimitiveMode_01", "has no triangles"},
    {"PrimitiveMode_02", "has no triangles"},
    {"PrimitiveMode_03", "has no triangles"},
    {"PrimitiveMode_07", "has no triangles"},
    {"PrimitiveMode_08", "has no triangles"},
    {"PrimitiveMode_09", "has no triangles"},
    {"PrimitiveMode_10", "has no triangles"},
    {"badArray", "has no triangles"}};

TEST(AssimpModels, OpenOrAreRefusedForAReason) {
    const fs::path folder = "/usr/share/assimp/models";
    if (!fs::exists(folder)) { GTEST_SKIP() << folder << " is not here: apt-get install assimp-testmodels"; }
    const auto isRefused = [](const std::string& path) -> const char* {
        for (const auto& [end, reason] : kRefused) {
            if (path.find(end) != std::string::npos) { return reason; }
        }
        return nullptr;
    };
    int opened = 0, refused = 0;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
        const std::string path = entry.path().string();
        if (!hasExtension(path, ".obj .ply .stl .gltf .glb")) { continue; }
        SCOPED_TRACE(path);
        const auto scene = loadScene(path);
        if (const char* reason = isRefused(path); reason != nullptr) {
            ++refused;
            ASSERT_FALSE(scene);
            EXPECT_THAT(scene.error().format(), HasSubstr(reason));
        } else {
            ++opened;
            EXPECT_TRUE(scene) << scene.error().format();
        }
    }
    EXPECT_GE(opened, 24);
    EXPECT_GE(refused, 10);
}

}  // namespace
}  // namespace glint
