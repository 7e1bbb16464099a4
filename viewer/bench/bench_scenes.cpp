// Boxes of rectangles: the canonical rectangle faces +z, so each wall is turned to face inwards.
#include "viewer/bench/bench_scenes.h"

#include "engine/io/scene_loader.h"
#include "engine/scene/generated_mesh.h"
#include "engine/scene/scene_building.h"

namespace glint {
namespace {

constexpr float kQuarterTurn = kPi / 2.0f;

int addMaterial(SceneDescription* scene, const char* name, const Vec3& color) {
    const int index = addMaterial(scene, diffuseMaterial(color));
    scene->materials.back().name = name;
    return index;
}

void addObject(SceneDescription* scene, const char* name, ShapeKind shape, int material,
               const Affine& placement) {
    addObject(scene, shape, placement, material);
    scene->objects.back().name = name;
}

int addEmitter(SceneDescription* scene, const Vec3& radiance) {
    const int emitter = addMaterial(scene, "lamp", Vec3(0.0f));
    scene->materials[emitter].emission.value = radiance;
    return emitter;
}

Affine facingDown(const Vec3& center, float halfSize) {
    return translate(center) * rotate({1, 0, 0}, kQuarterTurn) * scale(Vec3(halfSize));
}

Affine facingUp(const Vec3& center, float halfSize) {
    return translate(center) * rotate({1, 0, 0}, -kQuarterTurn) * scale(Vec3(halfSize));
}

void lookAt(SceneDescription* scene, const Vec3& position, const Vec3& target, float fovDeg) {
    scene->camera.position = position;
    scene->camera.target = target;
    scene->camera.verticalFovDeg = fovDeg;
    scene->camera.focalDistance = glm::length(target - position);
}

}  // namespace

std::shared_ptr<SceneDescription> benchCornell(int width, int height) {
    auto scene = std::make_shared<SceneDescription>();
    scene->title = "Cornell box of the benchmarks";
    scene->resolution = {width, height};
    scene->options.maxDepth = 10;
    lookAt(scene.get(), {0, 1, 3.9f}, {0, 1, 0}, 38.0f);
    const int white = addMaterial(scene.get(), "white", Vec3(0.73f));
    const int red = addMaterial(scene.get(), "red", {0.65f, 0.05f, 0.05f});
    const int green = addMaterial(scene.get(), "green", {0.12f, 0.45f, 0.15f});
    const int emitter = addEmitter(scene.get(), Vec3(15.0f));
    const auto wall = [&](const char* name, int material, const Vec3& center, const Vec3& axis,
                          float angleRad) {
        addObject(scene.get(), name, ShapeKind::Rectangle, material,
                  translate(center) * rotate(axis, angleRad));
    };
    wall("floor", white, {0, 0, 0}, {1, 0, 0}, -kQuarterTurn);
    wall("ceiling", white, {0, 2, 0}, {1, 0, 0}, kQuarterTurn);
    wall("back", white, {0, 1, -1}, {0, 1, 0}, 0.0f);
    wall("left", red, {-1, 1, 0}, {0, 1, 0}, kQuarterTurn);
    wall("right", green, {1, 1, 0}, {0, 1, 0}, -kQuarterTurn);
    addObject(scene.get(), "lamp", ShapeKind::Rectangle, emitter, facingDown({0, 1.999f, 0}, 0.25f));
    addObject(scene.get(), "left sphere", ShapeKind::Sphere, white,
              translate({-0.4f, 0.4f, -0.3f}) * scale(Vec3(0.4f)));
    addObject(scene.get(), "right sphere", ShapeKind::Sphere, white,
              translate({0.45f, 0.3f, 0.3f}) * scale(Vec3(0.3f)));
    return scene;
}

std::shared_ptr<SceneDescription> benchGlassAndMirror(int width, int height) {
    auto scene = benchCornell(width, height);
    scene->title = "Cornell box with a mirror and a glass sphere";
    const int mirror = addMaterial(scene.get(), "mirror", Vec3(0.95f));
    const int glass = addMaterial(scene.get(), "glass", Vec3(1.0f));
    scene->materials[static_cast<size_t>(mirror)].kind = MaterialKind::Mirror;
    scene->materials[static_cast<size_t>(glass)].kind = MaterialKind::Dielectric;
    const size_t spheres = scene->objects.size() - 2;
    scene->objects[spheres].material = mirror;
    scene->objects[spheres + 1].material = glass;
    return scene;
}

Result<std::shared_ptr<SceneDescription>> benchMesh(uint32_t triangles, int width, int height) {
    const MeshGenerator source{.name = "blob", .triangles = triangles, .seed = 1};
    auto mesh = generateMesh(source);
    if (!mesh) { return mesh.error(); }
    auto scene = std::make_shared<SceneDescription>();
    scene->title = "A generated mesh of the benchmarks";
    scene->resolution = {width, height};
    scene->options.maxDepth = 10;
    scene->environment.color = Vec3(0.3f);
    lookAt(scene.get(), {0, 1.5f, 4.5f}, {0, 0.2f, 0}, 38.0f);
    const int clay = addMaterial(scene.get(), "clay", {0.6f, 0.5f, 0.4f});
    const int white = addMaterial(scene.get(), "white", Vec3(0.73f));
    const int emitter = addEmitter(scene.get(), Vec3(12.0f));
    scene->meshes.push_back({"blob", source, *mesh});
    addObject(scene.get(), "blob", ShapeKind::Mesh, clay, Affine());
    scene->objects.back().mesh = 0;
    addObject(scene.get(), "floor", ShapeKind::Rectangle, white, facingUp({0, -1.3f, 0}, 4.0f));
    addObject(scene.get(), "lamp", ShapeKind::Rectangle, emitter, facingDown({1, 4, 1}, 1.0f));
    return scene;
}

Result<std::shared_ptr<SceneDescription>> benchFile(const std::string& path) {
    Result<SceneDescription> loaded = loadScene(path, {});
    if (!loaded) { return loaded.error(); }
    return std::make_shared<SceneDescription>(std::move(*loaded));
}

}  // namespace glint
