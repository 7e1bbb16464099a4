// Photon mapping at the ends of its scale: radii from a millionth of the scene to larger than it, one photon
// a pass and ten million, rooms in other units.
//
// The truths are a floor under even light in closed form, with the bias that a radius beyond its edges has,
// and the same room in metres from the same random numbers.
#include <cmath>

#include "engine/stress/stress_families.h"
#include "engine/stress/stress_render.h"
#include "engine/stress/stress_scene.h"

namespace glint {
namespace {

constexpr const char* kPhotonFamily = "photons";
constexpr double kFloorRadiance = 0.5 / kPiD;  // albedo 0.5, irradiance 1

/// The middle of a floor, lit by photons of the light alone.
SceneDescription photonFloor(const Vec3& from, float fovDeg, float halfSize, const Light& light, float radius,
                             uint32_t photons) {
    SceneDescription scene = emptyStressScene(from, {0, 0, 0}, fovDeg, 4);
    addObject(&scene, ShapeKind::Rectangle, placeFlatShape({0, 0, 0}, {0, 1, 0}, halfSize, halfSize),
              diffuseMaterial(0.5f));
    scene.lights.push_back(light);
    scene.options.maxDepth = 1;
    scene.sppm.radiusWorld = radius;
    scene.sppm.photonsPerPass = photons;
    scene.sppm.sampleDirectLight = false;
    return scene;
}

/// At height 1, pointing down.
Light spotAbove(float coneAngleDeg, float coneFalloffStartDeg) {
    Light spot;
    spot.kind = LightKind::Spot;
    spot.position = {0, 1, 0};
    spot.coneAngleDeg = coneAngleDeg;
    spot.coneFalloffStartDeg = coneFalloffStartDeg;
    return spot;
}

/// A floor of half size 1, lit straight from above with the irradiance 1.
SceneDescription litFloor(float radius, uint32_t photons) {
    const Light sun = directionalLight({0, -1, 0});
    return photonFloor({0.2f, 1.0f, 0.1f}, 2.0f, 1.0f, sun, radius, photons);
}

/// Every photon of the floor counts in a disc that reaches beyond it: with the share s = 4 / (pi r^2) of
/// the true density. The one point of the disc that a pass looks at misses the floor with 1 - s, which
/// doubles them.
StressCase largeRadiusCase(float radius) {
    StressCase c = namedCase(kPhotonFamily, "radius " + gradeNumber(radius),
                             "a radius " + gradeNumber(radius) + " times half the floor's size",
                             "irradiance in closed form, with the bias of the first pass");
    c.run = [=](const StressEffort& effort) {
        const double r2 = static_cast<double>(radius) * static_cast<double>(radius);
        const double share = radius > 1.5f ? 4.0 / (kPiD * r2) : 1.0;
        return measurePhotons(litFloor(radius, 5000), 1, effort.passes(2000, 500),
                              kFloorRadiance * share * (2.0 - share), effort);
    };
    return c;
}

/// A narrow spot light over a floor that is 1 / relative times as large as the radius.
StressCase smallRadiusCase(float relative) {
    StressCase c = namedCase(kPhotonFamily, "radius " + gradeNumber(relative),
                             "a radius " + gradeNumber(relative) + " times half the floor's size",
                             "irradiance in closed form");
    c.run = [=](const StressEffort& effort) {
        constexpr float kRadius = 2e-3f;
        const float size = kRadius / relative;
        const SceneDescription scene =
            photonFloor({0.1f, 1.0f, 0.05f}, 1.0f, size, spotAbove(3.0f, 2.5f), kRadius, 50000);
        return measurePhotons(scene, 4, effort.passes(64, 16), kFloorRadiance, effort);
    };
    return c;
}

/// The same floor lit by a spot whose cone is as narrow as grades go: all its photons go where it shines.
StressCase narrowSpotCase(float halfAngleDeg) {
    StressCase c =
        namedCase(kPhotonFamily, "spot of " + gradeNumber(halfAngleDeg) + " degrees",
                  "photons of a spot light with a cone of " + gradeNumber(halfAngleDeg) + " degrees",
                  "intensity over distance squared");
    c.run = [=](const StressEffort& effort) {
        const float spotRadius = halfAngleDeg * kPi / 180.0f;
        const SceneDescription scene =
            photonFloor({0, 0.7f, 0}, 0.2f * halfAngleDeg, 1.0f, spotAbove(halfAngleDeg, 0.9f * halfAngleDeg),
                        0.2f * spotRadius, 20000);
        return measurePhotons(scene, 4, effort.passes(48, 16), kFloorRadiance, effort);
    };
    return c;
}

StressCase photonCountCase(uint32_t photons, uint32_t passes, uint32_t runs) {
    StressCase c = namedCase(kPhotonFamily, gradeNumber(photons) + " photons a pass",
                             std::to_string(passes) + " passes of " + gradeNumber(photons) + " photons",
                             "irradiance in closed form");
    c.quick = photons == 1000;
    c.run = [=](const StressEffort& effort) {
        return measurePhotons(litFloor(photons == 1 ? 0.8f : 0.3f, photons), passes, effort.passes(runs, 12),
                              kFloorRadiance, effort);
    };
    return c;
}

/// No photon reaches the floor: it must stay black and finite.
StressCase darkCase() {
    StressCase c =
        namedCase(kPhotonFamily, "no photon for 10000 passes", "a floor that no photon reaches", "black");
    c.run = [](const StressEffort& effort) {
        SceneDescription scene = litFloor(0.3f, 100);
        addObject(&scene, ShapeKind::Rectangle, placeFlatShape({0, 3, 0}, {0, 1, 0}, 5, 5),
                  diffuseMaterial(0.0f));
        return measurePhotons(scene, effort.passes(10000), 2, 0.0, effort);
    };
    return c;
}

StressCase roomCase(const char* what, float amount) {
    const bool scaled = std::string(what) == "room x";
    StressCase c = namedCase(
        kPhotonFamily, std::string(what) + " " + gradeNumber(amount),
        scaled ? "a room whose unit of length is " + gradeNumber(1.0 / static_cast<double>(amount)) + " units"
               : "a room " + gradeNumber(amount) + " times its size from the origin",
        "the same room in metres at the origin");
    c.run = [=](const StressEffort& effort) {
        SceneDescription room = scaled ? stressRoom() : gridRoom();
        room.resolution = {16, 16};
        room.sppm.photonsPerPass = 2500;
        const SceneDescription extreme =
            scaled ? scaledScene(room, amount, StressChange::Vertices)
                   : movedScene(room, glm::round(amount * 5.0f * Vec3(0.7f, 0.3f, -0.65f)),
                                StressChange::Vertices);
        return measurePhotonsAgainst(extreme, room, 4, effort.passes(24, 10), effort);
    };
    return c;
}

}  // namespace

void addPhotonCases(StressCases* cases) {
    for (const float relative : {1e-6f, 1e-4f, 1e-2f}) {
        cases->push_back(smallRadiusCase(relative));
    }
    for (const float radius : {0.1f, 0.5f, 3.0f, 1e2f, 1e6f, 1e12f}) {
        cases->push_back(largeRadiusCase(radius));
    }
    for (const float angle : {10.0f, 1.0f, 1e-1f, 1e-2f, 1e-3f}) {
        cases->push_back(narrowSpotCase(angle));
    }
    cases->push_back(photonCountCase(1, 2000, 64));
    cases->push_back(photonCountCase(1000, 40, 48));
    cases->push_back(photonCountCase(1000000, 1, 16));
    cases->push_back(photonCountCase(10000000, 1, 8));
    cases->push_back(darkCase());
    for (const float factor : {1e-9f, 1e-6f, 1e-3f, 1e3f, 1e6f, 1e9f}) {
        cases->push_back(roomCase("room x", factor));
    }
    for (const float distance : {1e2f, 1e3f, 1e4f, 1e5f, 1e6f}) {
        cases->push_back(roomCase("room +", distance));
    }
}

}  // namespace glint
