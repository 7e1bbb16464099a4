// Glass: indices of refraction next to 1 and far from it, nested and touching slabs, total
// internal reflection.
//
// The truths are Fresnel's equations in double. Slabs are pairs of infinite planes between a glowing wall
// and the dark: T = 1 / (1 + sum R / (1 - R)) over the interfaces, unpolarised at each of them as the
// renderer is.
#include <cmath>

#include "engine/stress/stress_families.h"
#include "engine/stress/stress_render.h"
#include "engine/stress/stress_scene.h"

namespace glint {
namespace {

constexpr const char* kGlassFamily = "glass";

/// Unpolarised reflectance; n: index beyond over index before; 1 under total reflection. (Born and Wolf 1999,
/// section 1.5.2.)
double reflectance(double sine, double n) {
    const double sine2 = sine / n;
    if (sine2 >= 1.0) { return 1.0; }
    const double c1 = std::sqrt(1.0 - sine * sine);
    const double c2 = std::sqrt(1.0 - sine2 * sine2);
    const double s = (c1 - n * c2) / (c1 + n * c2);
    const double p = (n * c1 - c2) / (n * c1 + c2);
    return 0.5 * (s * s + p * p);
}

/// The steeper, the fewer paths get through, unless all do.
uint32_t passesFor(double angleRad, double truth) {
    if (truth == 1.0) { return 1024; }
    return angleRad > 1.5705 ? 120000 : angleRad > 1.55 ? 16384 : 4096;
}

/// An interface at height z: above it the index `above`, below it `below`.
struct Interface {
    float z;
    double above, below;
};

/// Seen from above at an angle to the normal: a wall of radiance 1 below all interfaces, nothing above.
Result<StressOutcome> measureStack(const std::vector<Interface>& stack, double angleRad,
                                   const StressEffort& effort) {
    const auto s = static_cast<float>(std::sin(angleRad));
    const auto c = static_cast<float>(std::cos(angleRad));
    SceneDescription scene = emptyStressScene(Vec3(-s, 0.0f, c) * 2.0f + Vec3(0, 0, 1), {0, 0, 1}, 1e-3f);
    // What gets in is reflected to and fro about 1 / (4 cos) times.
    scene.options.maxDepth = angleRad > 1.56 ? 20000 : 400;
    double sum = 0.0;
    const double sine = std::sin(angleRad);
    for (const Interface& i : stack) {
        // The material's index is that of the side the plane's normal turns away from, over the other side's.
        const bool denserBelow = i.below >= i.above;
        const double ratio = denserBelow ? i.below / i.above : i.above / i.below;
        addObject(&scene, ShapeKind::Plane,
                  placeFlatShape({0, 0, i.z}, {0, 0, denserBelow ? 1.0f : -1.0f}, 1, 1),
                  glass(static_cast<float>(ratio)));
        const double exact = static_cast<double>(static_cast<float>(ratio));
        const double r = reflectance(sine / i.above, denserBelow ? exact : 1.0 / exact);
        sum += r / (1.0 - r);
    }
    addObject(&scene, ShapeKind::Plane, placeFlatShape({0, 0, -4}, {0, 0, 1}, 1, 1),
              emissiveMaterial(Vec3(1.0f)));
    const double truth = 1.0 / (1.0 + sum);
    return measurePaths(scene, effort.passes(passesFor(angleRad, truth), 512), truth, effort);
}

StressCase slabCase(double ior, double angleDeg) {
    StressCase c =
        namedCase(kGlassFamily, "slab n " + gradeNumber(ior) + " at " + gradeNumber(angleDeg),
                  "index " + gradeNumber(ior) + ", " + gradeNumber(angleDeg) + " degrees off the normal",
                  "Fresnel's equations");
    c.quick = angleDeg <= 89.0 || ior == 1.0;
    c.run = [=](const StressEffort& effort) {
        return measureStack({{0.5f, 1.0, ior}, {-0.5f, ior, 1.0}}, angleDeg * kPiD / 180.0, effort);
    };
    return c;
}

StressCase nestedCase(double outer, double inner, double angleDeg) {
    StressCase c = namedCase(
        kGlassFamily,
        "slab n " + gradeNumber(inner) + " in " + gradeNumber(outer) + " at " + gradeNumber(angleDeg),
        "a slab of index " + gradeNumber(inner) + " within one of " + gradeNumber(outer),
        "Fresnel's equations");
    c.run = [=](const StressEffort& effort) {
        return measureStack(
            {{1.0f, 1.0, outer}, {0.3f, outer, inner}, {-0.3f, inner, outer}, {-1.0f, outer, 1.0}},
            angleDeg * kPiD / 180.0, effort);
    };
    return c;
}

StressCase gapCase(float gap) {
    StressCase c =
        namedCase(kGlassFamily, "slabs " + gradeNumber(gap) + " apart",
                  "two slabs with " + gradeNumber(gap) + " of air between them", "Fresnel's equations");
    if (gap < 1e-7f) {
        c.documented = StressVerdict::Broken;
        c.limit =
            "two interfaces in one place have no order, and a path that leaves the one starts beyond the "
            "other: model the one interface between two bodies that touch";
    }
    c.run = [=](const StressEffort& effort) {
        return measureStack({{0.8f, 1.0, 1.5}, {0.3f + gap, 1.5, 1.0}, {0.3f, 1.0, 1.5}, {-0.5f, 1.5, 1.0}},
                            kPiD / 3.0, effort);
    };
    return c;
}

/// From within glass towards its surface, `offset` (relative) from the critical angle, an even glow all
/// around: R reflected and (1 - R) n^2 from outside.
StressCase criticalCase(double offset) {
    StressCase c = namedCase(
        kGlassFamily,
        "critical angle " + std::string(offset < 0 ? "- " : "+ ") + gradeNumber(std::abs(offset)),
        gradeNumber(std::abs(offset)) + (offset < 0 ? " below" : " above") + " the critical angle, relative",
        "Fresnel's equations inside an even glow");
    c.run = [=](const StressEffort& effort) {
        const double n = 1.5;
        const double angle = std::asin(1.0 / n) * (1.0 + offset);
        const auto s = static_cast<float>(std::sin(angle));
        const auto k = static_cast<float>(std::cos(angle));
        const auto fov = static_cast<float>(std::min(1e-3, 5.0 * std::abs(offset)));
        SceneDescription scene = emptyStressScene({0, -k, 0}, {s, 0, 0}, fov);
        scene.environment.color = Vec3(1.0f);
        addObject(&scene, ShapeKind::Plane, placeFlatShape({0, 0, 0}, {0, 1, 0}, 1, 1), glass(1.5f));
        const double r = reflectance(std::sin(angle), 1.0 / n);
        return measurePaths(scene, effort.passes(256, 64), r + (1.0 - r) * n * n, effort);
    };
    return c;
}

/// A white body of glass vanishes in an even glow, however its light is trapped and split.
StressCase furnaceCase(double ior, ShapeKind shape) {
    const bool sphere = shape == ShapeKind::Sphere;
    StressCase c = namedCase(kGlassFamily, std::string(sphere ? "ball" : "cube") + " n " + gradeNumber(ior),
                             std::string("a ") + (sphere ? "ball" : "turned cube") + " of index " +
                                 gradeNumber(ior) + " in an even glow",
                             "it vanishes");
    c.run = [=](const StressEffort& effort) {
        SceneDescription scene = emptyStressScene({0, 0, 4}, {0, 0, 0}, 20.0f);
        scene.environment.color = Vec3(1.0f);
        scene.options.maxDepth = 2000;
        if (sphere) {
            addObject(&scene, ShapeKind::Sphere, {}, glass(static_cast<float>(ior)));
        } else {
            MeshData mesh;
            addBox(&mesh, Vec3(-0.8f), Vec3(0.8f), false);
            addMeshObject(&scene, std::move(mesh), rotate({1, 2, 3}, 0.8f), glass(static_cast<float>(ior)));
        }
        return measurePaths(scene, effort.passes(64), 1.0, effort, 2);
    };
    return c;
}

}  // namespace

void addGlassCases(StressCases* cases) {
    for (const double ior : {1.0, 1.0001, 1.01, 1.5, 2.4, 4.0}) {
        for (const double angle : {0.0, 60.0, 89.0}) {
            cases->push_back(slabCase(ior, angle));
        }
    }
    cases->push_back(slabCase(1.0, 89.99));
    cases->push_back(slabCase(1.5, 89.9));
    cases->push_back(slabCase(1.5, 89.99));
    cases->push_back(nestedCase(1.33, 1.5, 0.0));
    cases->push_back(nestedCase(1.33, 1.5, 80.0));
    cases->push_back(nestedCase(1.5, 1.0001, 30.0));
    cases->push_back(nestedCase(4.0, 1.01, 5.0));
    for (const float gap : {1e-1f, 1e-3f, 1e-5f, 1e-6f, 0.0f}) {
        cases->push_back(gapCase(gap));
    }
    for (const double offset : {1e-1, 1e-3, 1e-5, -1e-6, -1e-5, -1e-4, -1e-3, -1e-1}) {
        cases->push_back(criticalCase(offset));
    }
    for (const double ior : {1.0001, 1.5, 4.0}) {
        cases->push_back(furnaceCase(ior, ShapeKind::Sphere));
        cases->push_back(furnaceCase(ior, ShapeKind::Mesh));
    }
}

}  // namespace glint
