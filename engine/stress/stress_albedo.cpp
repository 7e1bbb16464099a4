// Long paths: closed white rooms, where light bounces hundreds of times and every loss adds up.
//
// The truths are closed forms: the geometric series of a furnace, and the integrating sphere.
#include <cmath>

#include "engine/stress/stress_families.h"
#include "engine/stress/stress_render.h"
#include "engine/stress/stress_scene.h"

namespace glint {
namespace {

constexpr const char* kAlbedoFamily = "albedo";

/// From inside a closed room that emits 1 and reflects `albedo`, everything looks alike.
SceneDescription furnace(float albedo, int maxDepth, bool box) {
    SceneDescription scene = emptyStressScene({0.2f, -0.3f, 0.1f}, {1, 0.2f, 0.3f}, 60.0f, 16);
    Material material = diffuseMaterial(albedo);
    material.emission.value = Vec3(1.0f);
    material.emitsBothSides = true;
    if (box) {
        MeshData mesh;
        addBox(&mesh, Vec3(-1.3f, -0.9f, -1.1f), Vec3(1.2f, 1.0f, 1.4f), true);
        addMeshObject(&scene, std::move(mesh), {}, material);
    } else {
        addObject(&scene, ShapeKind::Sphere, scale(Vec3(2.0f)), material);
    }
    scene.options.maxDepth = maxDepth;
    return scene;
}

/// Paths that are never ended by chance all have the same sum: what rounding does to it shows in few of them.
StressCase furnaceCase(float albedo, int maxDepth, bool box, bool roulette) {
    StressCase c =
        namedCase(kAlbedoFamily,
                  std::string(box ? "box" : "sphere") + " " + gradeNumber(albedo) + " depth " +
                      std::to_string(maxDepth) + (roulette ? "" : ", no roulette"),
                  "walls reflect " + gradeNumber(albedo) + " up to " + std::to_string(maxDepth) + " times",
                  "geometric series");
    c.quick = maxDepth <= (roulette ? 100 : 1000);
    c.run = [=](const StressEffort& effort) {
        const double a = static_cast<double>(albedo);
        const double truth = a == 1.0 ? maxDepth + 1.0 : (1.0 - std::pow(a, maxDepth + 1.0)) / (1.0 - a);
        SceneDescription scene = furnace(albedo, maxDepth, box);
        if (!roulette) {
            scene.options.rouletteStartDepth = maxDepth + 1;
            return measurePaths(scene, 2, truth, effort);
        }
        const uint32_t passes = a == 1.0 ? 4 : maxDepth <= 100 ? 900 : maxDepth <= 1000 ? 200 : 32;
        return measurePaths(scene, effort.passes(passes, 250), truth, effort, maxDepth <= 100 ? 2 : 1);
    };
    return c;
}

/// A black lamp in the middle of a white sphere of radius 1: of all light that leaves the wall, the lamp
/// absorbs the share r^2, so that the wall's radiance is a Le r^2 / (1 - a (1 - r^2)) (integrating sphere).
StressCase integratingSphereCase(float albedo, float emitterRadius) {
    StressCase c = namedCase(
        kAlbedoFamily, "integrating sphere " + gradeNumber(albedo) + " lamp " + gradeNumber(emitterRadius),
        "a lamp of radius " + gradeNumber(emitterRadius) + " in a sphere that reflects " +
            gradeNumber(albedo),
        "integrating sphere in closed form");
    c.run = [=](const StressEffort& effort) {
        const double f = static_cast<double>(emitterRadius) * static_cast<double>(emitterRadius);
        const double a = static_cast<double>(albedo);
        SceneDescription scene = emptyStressScene({0.0f, 0.5f, 0.3f}, {0.6f, 0.7f, 0.4f}, 40.0f, 16);
        addObject(&scene, ShapeKind::Sphere, {}, diffuseMaterial(albedo));
        addObject(&scene, ShapeKind::Sphere, scale(Vec3(emitterRadius)),
                  emissiveMaterial(Vec3(static_cast<float>(1.0 / f))));
        scene.options.maxDepth = 5000;
        return measurePaths(scene, effort.passes(1200, 300), a / (1.0 - a * (1.0 - f)), effort);
    };
    return c;
}

}  // namespace

void addAlbedoCases(StressCases* cases) {
    for (const bool box : {false, true}) {
        for (const bool roulette : {true, false}) {
            cases->push_back(furnaceCase(0.9f, 100, box, roulette));
            cases->push_back(furnaceCase(0.99f, 1000, box, roulette));
            cases->push_back(furnaceCase(0.999f, 1000, box, roulette));
            cases->push_back(furnaceCase(1.0f, 1000, box, roulette));
            cases->push_back(furnaceCase(0.9999f, 10000, box, roulette));
        }
    }
    for (const float emitter : {0.5f, 1e-2f, 1e-4f}) {
        cases->push_back(integratingSphereCase(0.9f, emitter));
        cases->push_back(integratingSphereCase(0.99f, emitter));
        cases->back().quick = false;
    }
}

}  // namespace glint
