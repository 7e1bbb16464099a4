// OBJ files of a square, however oddly they are written.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "engine/io/scene_loader.h"
#include "tests/support/temp_folder.h"

namespace glint::test {

/// The scene of a file, if it is as large as a square of two by two that faces +z.
inline std::optional<SceneDescription> loadSquare(const std::string& path) {
    Result<SceneDescription> scene = loadScene(path, {.noStudio = true});
    EXPECT_TRUE(scene) << scene.error().format();
    if (!scene) { return std::nullopt; }
    Vec3 area(0.0f);
    for (const Mesh& mesh : scene->meshes) {
        const MeshData& data = *mesh.data;
        for (size_t i = 0; i < data.indices.size(); i += 3) {
            const Vec3& a = data.positions[data.indices[i]];
            area += 0.5f * glm::cross(data.positions[data.indices[i + 1]] - a,
                                      data.positions[data.indices[i + 2]] - a);
        }
    }
    EXPECT_NEAR(glm::length(area - Vec3(0, 0, 4)), 0.0f, 1e-5f);
    return std::move(*scene);
}

inline const std::string kCorners = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n";
inline const std::string kUvs = "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";

/// The material of a square whose MTL file holds these lines; the other lines are in the OBJ file.
inline Material materialOf(const TempFolder& folder, const std::string& mtl,
                           std::vector<std::string>* warnings,
                           const std::string& use = "mtllib m.mtl\nusemtl it\n") {
    folder.write("m.mtl", mtl);
    const auto scene =
        loadSquare(folder.write("in.obj", use + kCorners + "vn 0 0 1\nf 1//1 2//1 3//1 4//1\n"));
    if (!scene) { return {}; }
    *warnings = scene->warnings;
    return scene->materials.at(0);
}

}  // namespace glint::test
