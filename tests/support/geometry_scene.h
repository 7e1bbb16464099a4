// Geometry alone, ready for rays: for tests that need no materials, lights or camera.
#pragma once

#include <memory>
#include <random>
#include <vector>

#include "engine/builders/instance_builder.h"
#include "engine/kernels/intersect.h"
#include "engine/kernels/surface.h"
#include "engine/scene/generated_mesh.h"

namespace glint::testing_support {

struct GeometryScene {
    std::vector<std::shared_ptr<const BuiltMesh>> meshes;
    std::shared_ptr<const InstanceTable> instances;
    SceneView view;
};

inline Object makeObject(ShapeKind shape, const Affine& objectToWorld, int mesh = -1) {
    Object object;
    object.shape = shape;
    object.objectToWorld = objectToWorld;
    object.mesh = mesh;
    return object;
}

inline GeometryScene makeScene(const std::vector<Object>& objects,
                               const std::vector<std::shared_ptr<const MeshData>>& meshes = {},
                               AcceleratorKind accelerator = AcceleratorKind::Bvh) {
    GeometryScene scene;
    SceneDescription description;
    description.options.accelerator = accelerator;
    description.materials.resize(1);
    description.objects = objects;
    for (const auto& mesh : meshes) {
        scene.meshes.push_back(buildMesh(mesh, 2, accelerator));
    }
    scene.instances = buildInstances(description, scene.meshes, {});
    scene.view.geometry = scene.instances->view();
    return scene;
}

inline std::shared_ptr<const MeshData> generated(const char* generator, uint32_t triangles,
                                                 uint32_t seed = 1) {
    return generateMesh({generator, triangles, seed}).value();
}

/// The standard library's distributions differ between versions; this does not.
class Random {
  public:
    explicit Random(uint32_t seed) : engine_(seed) {}

    float uniform() { return static_cast<float>(engine_() >> 8) * 0x1p-24f; }
    float uniform(float lo, float hi) { return lo + (hi - lo) * uniform(); }
    Vec3 box(float halfSide) {
        return {uniform(-halfSide, halfSide), uniform(-halfSide, halfSide), uniform(-halfSide, halfSide)};
    }
    Vec3 direction() {
        while (true) {
            const Vec3 v = box(1.0f);
            const float length = glm::length(v);
            if (length > 0.1f && length <= 1.0f) { return v / length; }
        }
    }
    uint32_t below(uint32_t count) { return static_cast<uint32_t>(engine_() % count); }

    /// Rotated, scaled differently along the axes, sheared, mirrored half of the time, and moved.
    Affine transform(float reach) {
        Affine shear;
        shear.linear[1][0] = uniform(-0.5f, 0.5f);
        const float mirror = uniform() < 0.5f ? -1.0f : 1.0f;
        return translate(box(reach)) * rotate(direction(), uniform(0.0f, 6.0f)) * shear *
               scale(Vec3(mirror * uniform(0.3f, 2.0f), uniform(0.3f, 2.0f), uniform(0.3f, 2.0f)));
    }

  private:
    std::mt19937 engine_;
};

}  // namespace glint::testing_support
