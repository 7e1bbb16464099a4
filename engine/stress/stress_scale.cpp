// Units and places: the same room in other units of length and far from the origin must look the same.
//
// The truth is the room itself, rendered from the same random numbers, so that only rounding differs.
#include "engine/stress/stress_families.h"
#include "engine/stress/stress_render.h"
#include "engine/stress/stress_scene.h"

namespace glint {
namespace {

constexpr uint32_t kPasses = 400;

const char* changeName(StressChange change) {
    return change == StressChange::Vertices ? "vertices" : "transforms";
}

StressCase scaleCase(float factor, StressChange change) {
    StressCase c;
    c.family = "scale";
    c.grade = std::string(changeName(change)) + " x " + gradeNumber(factor);
    c.extreme = "a room whose unit of length is " + gradeNumber(1.0 / static_cast<double>(factor)) + " units";
    c.truth = "the same room in metres";
    if (factor > 1e17f && change == StressChange::Vertices) {
        c.documented = StressVerdict::Broken;
        c.limit = "products of two lengths overflow float";
    }
    // One grade for each order of magnitude that users meet is enough for a quick run.
    c.quick = change == StressChange::Vertices && factor > 1e-10f && factor < 1e10f;
    c.run = [=](const StressEffort& effort) {
        const SceneDescription room = stressRoom();
        return measurePathsAgainst(scaledScene(room, factor, change), room, effort.passes(kPasses), effort);
    };
    return c;
}

/// The room is moved by whole units, which floats hold exactly beside its own grid.
StressCase offsetCase(float distance, StressChange change) {
    constexpr float kRoomSize = 5.0f;
    StressCase c;
    c.family = "offset";
    c.grade = std::string(changeName(change)) + " + " + gradeNumber(distance);
    c.extreme = "a room " + gradeNumber(distance) + " times its size from the origin";
    c.truth = "the same room at the origin";
    c.quick = change == StressChange::Vertices && distance > 50.0f;
    c.run = [=](const StressEffort& effort) {
        const SceneDescription room = gridRoom();
        const Vec3 offset = glm::round(distance * kRoomSize * Vec3(0.7f, 0.3f, -0.65f));
        return measurePathsAgainst(movedScene(room, offset, change), room, effort.passes(600), effort, 2);
    };
    return c;
}

}  // namespace

void addScaleCases(StressCases* cases) {
    for (const float factor :
         {1e-18f, 1e-12f, 1e-9f, 1e-6f, 1e-4f, 1e-2f, 1e2f, 1e4f, 1e6f, 1e9f, 1e12f, 1e18f}) {
        for (const StressChange change : {StressChange::Vertices, StressChange::Transforms}) {
            cases->push_back(scaleCase(factor, change));
        }
    }
}

void addOffsetCases(StressCases* cases) {
    for (const float distance : {1e1f, 1e2f, 1e3f, 1e4f, 1e5f, 1e6f}) {
        for (const StressChange change : {StressChange::Vertices, StressChange::Transforms}) {
            cases->push_back(offsetCase(distance, change));
        }
    }
}

}  // namespace glint
