#include "tests/support/light_scene.h"

#include <random>

#include "engine/builders/mesh_builder.h"

namespace glint::test {

LightScene::LightScene(const SceneDescription& scene) {
    for (const Mesh& mesh : scene.meshes) {
        meshes.push_back(buildMesh(mesh.data, 1));
    }
    lights = buildLightTable(scene, {}, nullptr, 1);
    instances = buildInstances(scene, meshes, lights->firstEmitter);
    view.geometry = instances->view();
    view.lights = lights->view();
}

std::shared_ptr<const MeshData> triangleSoup(uint32_t count, float size, uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> uniform(-1.0f, 1.0f);
    const auto point = [&] { return Vec3(uniform(random), uniform(random), uniform(random)); };
    auto mesh = std::make_shared<MeshData>();
    for (uint32_t i = 0; i < count; ++i) {
        const Vec3 center = point();
        for (uint32_t corner = 0; corner < 3; ++corner) {
            mesh->positions.push_back(center + size * point());
            mesh->indices.push_back(3 * i + corner);
        }
    }
    return mesh;
}

}  // namespace glint::test
