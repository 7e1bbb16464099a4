// Slivers and needles: triangles up to ten million times as long as wide, as floors, as lamps, and lit.
//
// The truths are a grey surface under an even sky (albedo times radiance, whatever its triangles), irradiance
// in closed form, and normals in double.
#include <cmath>
#include <numbers>

#include <glm/ext/vector_double3.hpp>
#include <glm/geometric.hpp>

#include "engine/stress/stress_families.h"
#include "engine/stress/stress_render.h"
#include "engine/stress/stress_scene.h"

namespace glint {
namespace {

constexpr double kFloorGrey = static_cast<double>(kFloorAlbedo);

/// Strips of the width `step` around x = 0 between two wide ones: the square [-1, 1]^2 of the xz plane at y =
/// 0, facing up.
MeshData needleFloor(float step) {
    constexpr int kHalf = 32;  // of the needles
    MeshData mesh;
    const auto strip = [&](float x0, float x1) {
        addQuad(&mesh, {x0, 0, -1}, {x0, 0, 1}, {x1, 0, 1}, {x1, 0, -1});
    };
    const float end = kHalf * step;
    strip(-1.0f, -end);
    for (int i = -kHalf; i < kHalf; ++i) {
        strip(static_cast<float>(i) * step, static_cast<float>(i + 1) * step);
    }
    strip(end, 1.0f);
    return mesh;
}

StressCase needleFloorCase(float aspect, bool tilted) {
    StressCase c =
        namedCase("needles", "floor of aspect " + gradeNumber(aspect) + (tilted ? ", turned" : ""),
                  "triangles " + gradeNumber(aspect) + " times as long as wide", "albedo under an even sky");
    c.run = [=](const StressEffort& effort) {
        const float step = 2.0f / aspect;
        return measurePaths(skyOverMesh(needleFloor(step), 32.0f * step, tilted), effort.passes(64),
                            kFloorGrey, effort, 4);
    };
    return c;
}

/// The lamp is a strip of 64 needles, 2 long and b = 64 * width wide, at height 1: from below its middle it
/// is a rectangle of half edges a = 1 and b / 2.
StressCase needleEmitterCase(float aspect) {
    StressCase c = namedCase("needles", "lamp of aspect " + gradeNumber(aspect),
                             "a lamp of triangles " + gradeNumber(aspect) + " times as long as wide",
                             "irradiance in closed form");
    c.run = [=](const StressEffort& effort) {
        const float step = 2.0f / aspect;
        const double b = 32.0 * static_cast<double>(step);
        MeshData emitter;
        for (int i = -32; i < 32; ++i) {
            const float x0 = static_cast<float>(i) * step;
            const float x1 = static_cast<float>(i + 1) * step;
            addQuad(&emitter, {x0, 1, -1}, {x1, 1, -1}, {x1, 1, 1}, {x0, 1, 1});
        }
        SceneDescription scene = emptyStressScene({0.3f, 0.5f, 0.4f}, {0, 0, 0}, 0.05f);
        scene.options.maxDepth = 1;
        addObject(&scene, ShapeKind::Plane, placeFlatShape({0, 0, 0}, {0, 1, 0}, 1, 1),
                  diffuseMaterial(kFloorAlbedo));
        addMeshObject(&scene, std::move(emitter), {}, emissiveMaterial(Vec3(static_cast<float>(1.0 / b))));
        const double rootA = std::numbers::sqrt2;
        const double rootB = std::hypot(b, 1.0);
        const double irradiance =
            2.0 / b * (1.0 / rootA * std::atan(b / rootA) + b / rootB * std::atan(1.0 / rootB));
        return measurePaths(scene, effort.passes(256), kFloorGrey * irradiance / std::numbers::pi, effort);
    };
    return c;
}

/// One long triangle askew, seen closely and lit from one side: its normal must come from edges that run all
/// but along one another. The truth takes it from the same vertices in double.
StressCase litNeedleCase(float aspect) {
    StressCase c =
        namedCase("needles", "lit, of aspect " + gradeNumber(aspect),
                  "a triangle " + gradeNumber(aspect) + " times as long as wide, lit from one side",
                  "its normal in double");
    c.run = [=](const StressEffort& effort) {
        const Vec3 along(1.0f, 0.7f, 0.3f);
        const float width = 2.0f * glm::length(along) / aspect;
        const Vec3 across = width * glm::normalize(glm::cross(along, Vec3(0, 1, 0)));
        MeshData mesh;
        mesh.positions = {-along, along, along + across};
        mesh.indices = {0, 1, 2};
        const glm::dvec3 p0(mesh.positions[0]), p1(mesh.positions[1]), p2(mesh.positions[2]);
        const glm::dvec3 normal = glm::normalize(glm::cross(p1 - p0, p2 - p0));
        const glm::dvec3 middle = (p0 + p1 + p2) / 3.0;
        SceneDescription scene =
            emptyStressScene(Vec3(middle + normal), Vec3(middle), 0.05f * width * 180.0f / kPi);
        scene.options.maxDepth = 1;
        const Vec3 direction = -Vec3(0.6 * normal + 0.8 * glm::normalize(glm::dvec3(across)));
        scene.lights.push_back(directionalLight(direction));
        const double cosine = -glm::dot(normal, glm::normalize(glm::dvec3(direction)));
        addMeshObject(&scene, std::move(mesh), {}, diffuseMaterial(kFloorAlbedo));
        return measurePaths(scene, effort.passes(16), kFloorGrey / std::numbers::pi * cosine, effort);
    };
    return c;
}

}  // namespace

void addNeedleCases(StressCases* cases) {
    for (const bool tilted : {false, true}) {
        for (const float aspect : {1e2f, 1e4f, 1e6f, 1e7f}) {
            cases->push_back(needleFloorCase(aspect, tilted));
        }
    }
    for (const float aspect : {1e2f, 1e4f, 1e6f, 1e7f}) {
        cases->push_back(needleEmitterCase(aspect));
    }
    for (const float aspect : {1e2f, 1e4f, 1e6f}) {
        cases->push_back(litNeedleCase(aspect));
    }
}

}  // namespace glint
