// A scene's folder with images, meshes and broken files, and scenes that use some of them.
#pragma once

#include <string>

#include <gtest/gtest.h>

#include "engine/io/image_io.h"
#include "engine/io/scene_loader.h"
#include "tests/support/temp_folder.h"

namespace glint::test {

/// "room.obj" and "room.mtl": two parts, one with the texture "wall.png"; both have texture coordinates.
constexpr const char* kRoomObj = R"(mtllib room.mtl
v 0 0 0
v 1 0 0
v 0 1 0
v 1 1 0
vt 0 0
vt 4 0
vt 0 4
vt 4 4
usemtl wall
f 1/1 2/2 3/3
usemtl plain
f 2/2 4/4 3/3
)";
constexpr const char* kRoomMtl = R"(newmtl wall
map_Kd wall.png
newmtl plain
Kd 0.5 0.5 0.5
newmtl nobody
map_Kd broken.png
)";

/// A triangle with texture coordinates.
constexpr const char* kLeafPly = R"(ply
format ascii 1.0
element vertex 3
property float x
property float y
property float z
property float u
property float v
element face 1
property list uchar int vertex_indices
end_header
0 0 0 0 0
1 0 0 1 0
0 1 0 0 1
3 0 1 2
)";

/// Uses a sphere, a mesh and nothing else of what it names.
constexpr const char* kIdleScene = R"({"glint": 1, "resolution": [24, 16],
  "camera": {"position": [0.4, 0.4, 3], "target": [0.4, 0.4, 0]},
  "textures": {"wall": {"file": "wall.png"}, "same": {"file": "./wall.png", "scale": [2, 2]},
               "broken": {"file": "broken.png"}, "gone": {"file": "gone.png"}},
  "materials": {"grey": {"type": "diffuse"},
                "nobody": {"type": "diffuse", "color": {"texture": "broken"}}},
  "meshes": {"leaf": {"file": "leaf.ply"}, "room": {"file": "room.obj", "part": 1},
             "unplaced": {"file": "broken.ply"}, "blob": {"generator": "blob", "triangleCount": 50000}},
  "objects": [{"type": "sphere", "material": "grey", "center": [2, 2, 0]},
              {"type": "mesh", "mesh": "leaf", "material": "grey"}],
  "lights": [{"type": "directional", "direction": [0.2, -0.3, -1], "irradiance": 3}],
  "environment": {"strength": 0, "image": {"file": "broken.exr"}}
})";

class UsedAssets : public testing::Test {
  protected:
    UsedAssets() {
        Image8 image{64, 32, {}};
        for (size_t i = 0; i < size_t{64} * 32 * 3; ++i) {
            image.rgb.push_back(static_cast<uint8_t>(i * 37 % 251));
        }
        EXPECT_TRUE(savePng(folder.path("wall.png"), image));
        for (const char* name : {"broken.png", "broken.ply", "broken.exr"}) {
            folder.write(name, "not what its name says");
        }
        folder.write("room.obj", kRoomObj);
        folder.write("room.mtl", kRoomMtl);
        folder.write("leaf.ply", kLeafPly);
    }

    SceneDescription load(const std::string& path, LoadCounts* counts = nullptr) const {
        auto scene = loadScene(path, {.noStudio = true, .counts = counts});
        EXPECT_TRUE(scene.ok()) << scene.error().format();
        return scene ? std::move(*scene) : SceneDescription();
    }
    SceneDescription loadText(const std::string& name, const std::string& text,
                              LoadCounts* counts = nullptr) {
        return load(folder.write(name, text), counts);
    }

    TempFolder folder;
};

}  // namespace glint::test
