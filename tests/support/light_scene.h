// Geometry and lights of a description as a view, without materials or a camera: for tests of light
// sampling alone.
#pragma once

#include <memory>
#include <vector>

#include "engine/builders/instance_builder.h"
#include "engine/builders/light_table.h"
#include "engine/kernels/scene_view.h"
#include "engine/scene/scene_building.h"

namespace glint::test {

struct LightScene {
    explicit LightScene(const SceneDescription& scene);

    std::vector<std::shared_ptr<const BuiltMesh>> meshes;
    std::shared_ptr<const LightTable> lights;
    std::shared_ptr<const InstanceTable> instances;
    SceneView view;
};

/// `count` random triangles of about the given size in the box [-1, 1]^3.
std::shared_ptr<const MeshData> triangleSoup(uint32_t count, float size, uint32_t seed);

}  // namespace glint::test
