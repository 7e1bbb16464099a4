// Instances whose transforms shrink, stretch, shear and mirror by large factors.
//
// The truth is the room with all vertices in place: each mesh is first taken back by the inverse transform
// (in double), so that its instance stands where it stood.
#include <utility>

#include <glm/ext/matrix_double3x3.hpp>
#include <glm/matrix.hpp>

#include "engine/stress/stress_families.h"
#include "engine/stress/stress_render.h"
#include "engine/stress/stress_scene.h"

namespace glint {
namespace {

/// The room with its lamp as a mesh, so that emission goes through transforms, too.
SceneDescription meshRoom() {
    SceneDescription room = stressRoom();
    for (Object& object : room.objects) {
        if (object.shape != ShapeKind::Rectangle) { continue; }
        MeshData emitter;
        addQuad(&emitter, {-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0});
        object.shape = ShapeKind::Mesh;
        object.mesh = static_cast<int>(room.meshes.size());
        room.meshes.emplace_back();
        room.meshes.back().data = std::make_shared<const MeshData>(std::move(emitter));
    }
    return room;
}

glm::dmat3 linearOf(const Affine& a) { return glm::dmat3(a.linear); }

/// All meshes in world space, objects without transforms.
SceneDescription inPlace(const SceneDescription& scene) {
    SceneDescription placed = scene;
    for (Object& object : placed.objects) {
        if (object.shape != ShapeKind::Mesh) { continue; }
        Mesh& mesh = placed.meshes[static_cast<size_t>(object.mesh)];
        auto data = std::make_shared<MeshData>(*mesh.data);
        for (Vec3& p : data->positions) {
            p = object.objectToWorld.point(p);
        }
        mesh.data = std::move(data);
        object.objectToWorld = Affine{};
    }
    return placed;
}

/// The same scene with every mesh brought to where it is by `map`. Mirroring turns triangles inside out, so
/// that their corners change places.
SceneDescription throughTransform(const SceneDescription& placed, const Affine& map) {
    SceneDescription scene = placed;
    const glm::dmat3 back = glm::inverse(linearOf(map));
    const bool mirrors = glm::determinant(linearOf(map)) < 0.0;
    for (Object& object : scene.objects) {
        if (object.shape != ShapeKind::Mesh) { continue; }
        Mesh& mesh = scene.meshes[static_cast<size_t>(object.mesh)];
        auto data = std::make_shared<MeshData>(*mesh.data);
        for (Vec3& p : data->positions) {
            p = Vec3(back * (glm::dvec3(p) - glm::dvec3(map.translation)));
        }
        for (size_t i = 0; mirrors && i + 2 < data->indices.size(); i += 3) {
            std::swap(data->indices[i + 1], data->indices[i + 2]);
        }
        mesh.data = std::move(data);
        object.objectToWorld = map;
    }
    return scene;
}

StressCase transformCase(std::string grade, const Affine& map) {
    StressCase c;
    c.family = "instances";
    c.grade = grade;
    c.extreme = "meshes placed by a transform: " + std::move(grade);
    c.truth = "the same meshes without transforms";
    c.run = [=](const StressEffort& effort) {
        const SceneDescription room = inPlace(meshRoom());
        return measurePathsAgainst(throughTransform(room, map), room, effort.passes(480), effort);
    };
    return c;
}

Affine shear(float factor) {
    Affine a;
    a.linear[1][0] = factor;
    return a;
}

}  // namespace

void addInstanceCases(StressCases* cases) {
    for (const float factor : {1e-6f, 1e-3f, 1e3f, 1e6f}) {
        const std::string text = gradeNumber(factor);
        cases->push_back(transformCase("scaled " + text, scale(Vec3(factor))));
        cases->push_back(transformCase("stretched " + text + " along y", scale({1.0f, factor, 1.0f})));
    }
    cases->push_back(
        transformCase("stretched 1e-3 and 1e3", rotate({1, 2, 3}, 1.0f) * scale({1e-3f, 1.0f, 1e3f})));
    for (const float factor : {1.0f, 10.0f, 100.0f, 1000.0f}) {
        cases->push_back(transformCase("sheared " + gradeNumber(factor), shear(factor)));
    }
    cases->push_back(transformCase("mirrored", scale({-1, 1, 1})));
    cases->push_back(transformCase("mirrored and scaled 1e-3", scale({1e-3f, -1e-3f, 1e-3f})));
    cases->push_back(transformCase("mirrored and sheared 10", scale({1, 1, -1}) * shear(10.0f)));
}

}  // namespace glint
