// Lenses: from pinholes to lenses larger than the scene, in focus beside the glass, fields of view from
// hundredths of a degree to nearly everything.
//
// The truths are areas: how much of the picture a disc covers, and through how much of the lens a disc
// is seen.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/stress/stress_families.h"
#include "engine/stress/stress_render.h"
#include "engine/stress/stress_scene.h"

namespace glint {
namespace {

/// A glowing disc that reaches half way to the edges of the picture covers pi / 16 of it, at any angle.
StressCase fieldOfViewCase(float degrees) {
    StressCase c = namedCase("camera", "field of view " + gradeNumber(degrees),
                             "a field of view of " + gradeNumber(degrees) + " degrees",
                             "the disc's share of the picture");
    c.run = [=](const StressEffort& effort) {
        SceneDescription scene = emptyStressScene({3, 1, 2}, {3, 1, 1}, degrees, 32);
        const double radius = 0.5 * std::tan(0.5 * static_cast<double>(degrees) * std::numbers::pi / 180.0);
        const auto r = static_cast<float>(radius);
        addObject(&scene, ShapeKind::Disc, placeFlatShape({3, 1, 1}, {0, 0, 1}, r, r),
                  emissiveMaterial(Vec3(1.0f)));
        return measurePaths(scene, effort.passes(256), std::numbers::pi / 16.0, effort);
    };
    return c;
}

/// The middle of the picture, a disc of radius r at the distance d on the axis, a lens of radius R in focus
/// at f: a ray through the lens at rho passes the disc where rho |1 - d/f| < r.
StressCase lensCase(float aperture, float focus) {
    StressCase c = namedCase(
        "camera", "aperture " + gradeNumber(aperture) + " focus " + gradeNumber(focus),
        "a lens " + gradeNumber(aperture) + " wide in focus at " + gradeNumber(focus) + ", the object at 2",
        "the share of the lens that sees the object");
    c.run = [=](const StressEffort& effort) {
        const double blur =
            0.5 * static_cast<double>(aperture) * std::abs(1.0 - 2.0 / static_cast<double>(focus));
        // The object covers about a third of what the lens sees, or is sharp in the middle; a lens of a
        // million times its size would leave it no digits.
        const double radius = std::max({0.6 * blur, 1e-3, 1e-6 * static_cast<double>(aperture)});
        SceneDescription scene = emptyStressScene({0, 0, 0}, {0, 0, -1}, 1e-4f);
        scene.camera.apertureDiameter = aperture;
        scene.camera.focalDistance = focus;
        const auto r = static_cast<float>(radius);
        addObject(&scene, ShapeKind::Disc, placeFlatShape({0, 0, -2}, {0, 0, 1}, r, r),
                  emissiveMaterial(Vec3(1.0f)));
        const double share = blur > 0.0 ? std::min(1.0, std::pow(static_cast<double>(r) / blur, 2.0)) : 1.0;
        return measurePaths(scene, effort.passes(2048), share, effort);
    };
    return c;
}

/// A grey wall under an even sky looks the same through any lens.
StressCase wallCase(float aperture, float focus) {
    StressCase c = namedCase(
        "camera", "wall, aperture " + gradeNumber(aperture) + " focus " + gradeNumber(focus),
        "a wall seen through a lens " + gradeNumber(aperture) + " wide in focus at " + gradeNumber(focus),
        "albedo under an even sky");
    c.run = [=](const StressEffort& effort) {
        SceneDescription scene = emptyStressScene({0, 1, 0}, {0.1f, 0, 0}, 30.0f);
        scene.camera.apertureDiameter = aperture;
        scene.camera.focalDistance = focus;
        scene.environment.color = Vec3(1.0f);
        scene.options.maxDepth = 1;
        // The lens stands level over the floor: none of it reaches through.
        scene.camera.target = {0, 0, 0};
        scene.camera.up = {0, 0, 1};
        addObject(&scene, ShapeKind::Plane, placeFlatShape({0, 0, 0}, {0, 1, 0}, 1, 1),
                  diffuseMaterial(0.5f));
        return measurePaths(scene, effort.passes(64), 0.5, effort, 2);
    };
    return c;
}

}  // namespace

void addCameraCases(StressCases* cases) {
    for (const float degrees : {1e-4f, 1e-2f, 1.0f, 90.0f, 170.0f, 179.0f, 179.9f}) {
        cases->push_back(fieldOfViewCase(degrees));
    }
    for (const float aperture : {0.0f, 1e-6f, 1e-2f, 1.0f, 1e3f, 1e6f}) {
        for (const float focus : {1e-6f, 1e-2f, 1.0f, 2.0f, 1e6f}) {
            cases->push_back(lensCase(aperture, focus));
        }
    }
    cases->push_back(wallCase(0.5f, 1e-6f));
    cases->push_back(wallCase(1e3f, 1.0f));
    cases->push_back(wallCase(1e6f, 1e3f));
}

}  // namespace glint
