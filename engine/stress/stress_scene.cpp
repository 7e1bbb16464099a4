#include "engine/stress/stress_scene.h"

#include <cmath>

#include <fmt/format.h>

namespace glint {
namespace {

template <class Change>
void changeVertices(SceneDescription* scene, const Change& change) {
    for (Mesh& mesh : scene->meshes) {
        auto data = std::make_shared<MeshData>(*mesh.data);
        for (Vec3& p : data->positions) {
            p = change(p);
        }
        mesh.data = std::move(data);
    }
}

/// Meshes without a transform change their vertices where asked to; all else is placed by its transform.
void changeObjects(SceneDescription* scene, const Affine& map, StressChange change) {
    for (Object& object : scene->objects) {
        const bool baked = change == StressChange::Vertices && object.shape == ShapeKind::Mesh &&
                           object.objectToWorld == Affine{};
        if (!baked) { object.objectToWorld = map * object.objectToWorld; }
    }
}

MeshData roomWalls() {
    MeshData mesh;
    addQuad(&mesh, {-2, 0, -3}, {-2, 0, 2}, {2, 0, 2}, {2, 0, -3});
    addQuad(&mesh, {-2, 0, -3}, {2, 0, -3}, {2, 3, -3}, {-2, 3, -3});
    addQuad(&mesh, {-2, 0, 2}, {-2, 0, -3}, {-2, 3, -3}, {-2, 3, 2});
    addQuad(&mesh, {2, 0, -3}, {2, 0, 2}, {2, 3, 2}, {2, 3, -3});
    addQuad(&mesh, {-2, 3, -3}, {2, 3, -3}, {2, 3, 2}, {-2, 3, 2});
    return mesh;
}

MeshData block(const Vec3& lo, const Vec3& hi) {
    MeshData mesh;
    addBox(&mesh, lo, hi, false);
    return mesh;
}

/// Where things stand in a room.
struct Furniture {
    Vec3 camera, target;
    Vec3 emitter, sphere;    ///< their middles
    Vec3 goldLow, goldHigh;  ///< corners of a block
    Vec3 plastic;            ///< the middle of a block's bottom
};

SceneDescription furnishedRoom(const Furniture& at) {
    SceneDescription scene = emptyStressScene(at.camera, at.target, 42.0f, 32);
    scene.camera.apertureDiameter = 0.06f;
    scene.camera.focalDistance = 5.4f;
    scene.options.maxDepth = 6;
    addMeshObject(&scene, roomWalls(), {}, diffuseMaterial(0.7f));
    addObject(&scene, ShapeKind::Rectangle, placeFlatShape(at.emitter, {0, -1, 0}, 0.6f, 0.5f),
              emissiveMaterial(Vec3(12.0f)));
    addObject(&scene, ShapeKind::Sphere, translate(at.sphere) * scale(Vec3(0.6f)), glass(1.5f));
    Material gold = diffuseMaterial(1.0f);
    gold.kind = MaterialKind::Conductor;
    gold.roughness.value = 0.3f;
    addMeshObject(&scene, block(at.goldLow, at.goldHigh), {}, gold);
    Material plastic = diffuseMaterial(0.4f);
    plastic.kind = MaterialKind::Plastic;
    plastic.roughness.value = 0.1f;
    addMeshObject(&scene, block({-0.4f, 0.0f, -0.5f}, {0.4f, 0.5f, 0.5f}),
                  translate(at.plastic) * rotate({0, 1, 0}, 0.4f), plastic);
    return scene;
}

}  // namespace

Material whiteMetal(float roughness) {
    Material material = diffuseMaterial(1.0f);
    material.kind = MaterialKind::Conductor;
    material.metal.clear();
    material.eta.value = Vec3(1e-4f);
    material.k.value = Vec3(100.0f);
    material.roughness.value = roughness;
    return material;
}

Material glass(float ior) {
    Material material = diffuseMaterial(1.0f);
    material.kind = MaterialKind::Dielectric;
    material.ior.value = ior;
    return material;
}

SceneDescription closeUpOfFloor(const Vec3& from, const Vec3& target, float width) {
    const float fov = 2.0f * std::atan(0.5f * width / glm::length(target - from)) * 180.0f / kPi;
    SceneDescription scene = emptyStressScene(from, target, fov);
    addObject(&scene, ShapeKind::Plane, placeFlatShape({0, 0, 0}, {0, 1, 0}, 1, 1),
              diffuseMaterial(kFloorAlbedo));
    scene.options.maxDepth = 1;
    return scene;
}

SceneDescription skyOverMesh(MeshData mesh, float width, bool tilted) {
    const Affine turn = tilted ? rotate({0.3f, 0.2f, 1.0f}, 0.7f) : Affine{};
    const Vec3 from = turn.point({0.2f, 0.8f, 0.3f});
    const float fov = 2.0f * std::atan(0.5f * width / glm::length(from)) * 180.0f / kPi;
    SceneDescription scene = emptyStressScene(from, {0, 0, 0}, fov);
    scene.environment.color = Vec3(1.0f);
    scene.options.maxDepth = 1;
    addMeshObject(&scene, std::move(mesh), turn, diffuseMaterial(kFloorAlbedo));
    return scene;
}

SceneDescription stressRoom() {
    return furnishedRoom({.camera = {0.1f, 1.4f, 5.5f},
                          .target = {0.1f, 1.2f, 0.0f},
                          .emitter = {0.3f, 2.9f, -0.5f},
                          .sphere = {0.8f, 0.62f, 0.4f},
                          .goldLow = {-1.6f, 0.01f, -1.8f},
                          .goldHigh = {-0.6f, 1.7f, -0.8f},
                          .plastic = {-0.7f, 0.01f, 0.8f}});
}

SceneDescription gridRoom() {
    return furnishedRoom({.camera = {0, 1.5f, 5.5f},
                          .target = {0, 1, 0},
                          .emitter = {0.5f, 2.5f, -0.5f},
                          .sphere = {1, 1, 0.5f},
                          .goldLow = {-1.5f, 0.5f, -2},
                          .goldHigh = {-0.5f, 2, -1},
                          .plastic = {-0.5f, 0.5f, 1}});
}

SceneDescription scaledScene(const SceneDescription& scene, float factor, StressChange change) {
    SceneDescription scaled = scene;
    if (change == StressChange::Vertices) {
        changeVertices(&scaled, [&](const Vec3& p) { return factor * p; });
    }
    for (Object& object : scaled.objects) {
        const bool mesh = object.shape == ShapeKind::Mesh;
        object.objectToWorld.translation *= factor;
        if (!mesh || change == StressChange::Transforms) { object.objectToWorld.linear *= factor; }
    }
    scaled.camera.position *= factor;
    scaled.camera.target *= factor;
    scaled.camera.apertureDiameter *= factor;
    scaled.camera.focalDistance *= factor;
    scaled.camera.viewHeight *= factor;
    for (Light& light : scaled.lights) {
        light.position *= factor;
        if (light.kind != LightKind::Directional) { light.color *= factor * factor; }
    }
    scaled.sppm.radiusWorld *= factor;
    return scaled;
}

SceneDescription movedScene(const SceneDescription& scene, const Vec3& offset, StressChange change) {
    SceneDescription moved = scene;
    if (change == StressChange::Vertices) {
        for (Mesh& mesh : moved.meshes) {
            mesh.data = nullptr;  // only those without a transform are moved
        }
        for (const Object& object : scene.objects) {
            if (object.shape != ShapeKind::Mesh) { continue; }
            const auto index = static_cast<size_t>(object.mesh);
            auto data = std::make_shared<MeshData>(*scene.meshes[index].data);
            if (object.objectToWorld == Affine{}) {
                for (Vec3& p : data->positions) {
                    p += offset;
                }
            }
            moved.meshes[index].data = std::move(data);
        }
    }
    changeObjects(&moved, translate(offset), change);
    moved.camera.position += offset;
    moved.camera.target += offset;
    for (Light& light : moved.lights) {
        light.position += offset;
    }
    return moved;
}

std::string gradeNumber(double value) {
    const double magnitude = std::abs(value);
    if (value == 0.0 || (magnitude >= 1e-2 && magnitude < 1e4)) { return fmt::format("{:.7g}", value); }
    std::string text = fmt::format("{:.3e}", value);
    const size_t e = text.find('e');
    std::string mantissa = text.substr(0, e);
    mantissa.erase(mantissa.find_last_not_of('0') + 1);
    if (mantissa.ends_with('.')) { mantissa.pop_back(); }
    return fmt::format("{}e{}", mantissa, std::stoi(text.substr(e + 1)));
}

}  // namespace glint
