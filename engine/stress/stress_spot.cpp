// Spot lights with narrow cones over a grey plane: in the middle, across their edge, and outside.
//
// The truths are the falloff's definition in double, and its integral by quadrature.
#include <algorithm>
#include <cmath>

#include "engine/stress/stress_families.h"
#include "engine/stress/stress_render.h"
#include "engine/stress/stress_scene.h"

namespace glint {
namespace {

constexpr double kAlbedoD = static_cast<double>(kFloorAlbedo);

/// The falloff between the inner and the outer cone: cubic in the cosine, which is 1 - 2 sin^2 of the half.
double spotFalloffAt(double angle, double inner, double outer) {
    const auto versine = [](double a) { return 2.0 * std::pow(std::sin(0.5 * a), 2.0); };
    const double t =
        std::clamp((versine(outer) - versine(angle)) / (versine(outer) - versine(inner)), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// What a floor at distance 1 sends back of a spot of intensity pi, over its whole cone: albedo times the
/// integral of falloff * cos^3 over the floor.
double spotOnFloor(double inner, double outer) {
    constexpr int kRings = 100000;
    const double radius = std::tan(outer);
    double sum = 0.0;
    for (int ring = 0; ring < kRings; ++ring) {
        const double r = (ring + 0.5) / kRings * radius;
        const double angle = std::atan(r);
        sum += spotFalloffAt(angle, inner, outer) * std::pow(std::cos(angle), 3.0) * r;
    }
    return kAlbedoD * 2.0 * kPiD * sum * radius / kRings;
}

enum class SpotView { Middle, Edge, Outside };

/// A spot light whose cone is narrow, straight above: I / h^2 in its middle, nothing outside, and between
/// them what a picture of the whole cone, three times its radius across, has in the mean.
StressCase narrowSpotCase(float halfAngleDeg, SpotView where) {
    constexpr const char* kWhere[] = {"", ", its edge", ", outside"};
    StressCase c;
    c.family = "lamp";
    c.grade = "spot of " + gradeNumber(halfAngleDeg) + " degrees" + kWhere[static_cast<int>(where)];
    c.extreme = "a spot light with a cone of " + gradeNumber(halfAngleDeg) + " degrees";
    c.truth = where == SpotView::Middle ? "intensity over distance squared"
              : where == SpotView::Edge ? "the falloff by quadrature in double"
                                        : "black";
    c.run = [=](const StressEffort& effort) {
        const double outer = static_cast<double>(halfAngleDeg) * kPiD / 180.0;
        const auto radius = static_cast<float>(std::tan(outer));
        const bool outside = where == SpotView::Outside;
        const Vec3 target(outside ? 1.1f * radius : 0.0f, 0.0f, 0.0f);
        const float width = where == SpotView::Middle ? 0.5f * std::min(radius, 1e-2f)
                            : outside                 ? 0.1f * radius
                                                      : 3.0f * radius;
        SceneDescription scene = closeUpOfFloor(target + Vec3(0, 0.7f, 0), target, width);
        Light light;
        light.kind = LightKind::Spot;
        light.position = {0, 1, 0};
        light.direction = {0, -1, 0};
        light.color = Vec3(static_cast<float>(kPiD));
        light.coneAngleDeg = halfAngleDeg;
        light.coneFalloffStartDeg = 0.9f * halfAngleDeg;
        scene.lights.push_back(light);
        if (outside) { return measurePaths(scene, effort.passes(16), 0.0, effort); }
        if (where == SpotView::Middle) { return measurePaths(scene, effort.passes(16), kAlbedoD, effort, 4); }
        const double area = 9.0 * static_cast<double>(radius) * static_cast<double>(radius);
        return measurePaths(scene, effort.passes(256), spotOnFloor(0.9 * outer, outer) / area, effort);
    };
    return c;
}

}  // namespace

void addSpotCases(StressCases* cases) {
    for (const SpotView where : {SpotView::Middle, SpotView::Edge, SpotView::Outside}) {
        for (const float angle : {10.0f, 1.0f, 1e-1f, 1e-2f, 1e-3f, 1e-4f}) {
            cases->push_back(narrowSpotCase(angle, where));
        }
    }
}

}  // namespace glint
