// Gloss and grazing: GGX lobes from a needle's width to a hemisphere, seen from everywhere, and surfaces seen
// or lit along themselves.
//
// The truths are quadratures of the microfacet model in double, written with Smith's Lambda and slopes
// instead of the kernels' forms, and closed forms for point lights.
#include <cmath>

#include "engine/stress/stress_families.h"
#include "engine/stress/stress_render.h"
#include "engine/stress/stress_scene.h"

namespace glint {
namespace {

/// Smith's Lambda for GGX (Walter et al. 2007, eq. 34, as G1 = 1 / (1 + Lambda)).
double smithLambda(double cosine, double alpha) {
    const double tan2 = (1.0 - cosine * cosine) / (cosine * cosine);
    return 0.5 * (std::sqrt(1.0 + alpha * alpha * tan2) - 1.0);
}

/// Share of light from all around that a rough metal without absorption sends towards cosOut: the integral of
/// D G2 (wo . h) / cosOut over the facets' normals, taken uniformly by D cos.
double metalAlbedo(double cosOut, double alpha) {
    constexpr int kRings = 2000;
    constexpr int kSectors = 256;
    const double sinOut = std::sqrt(1.0 - cosOut * cosOut);
    const double lambdaOut = smithLambda(cosOut, alpha);
    double sum = 0.0;
    for (int ring = 0; ring < kRings; ++ring) {
        const double u = (ring + 0.5) / kRings;
        const double tangent = alpha * std::sqrt(u / (1.0 - u));
        const double cosH = 1.0 / std::sqrt(1.0 + tangent * tangent);
        const double sinH = tangent * cosH;
        for (int sector = 0; sector < kSectors; ++sector) {
            const double phi = (sector + 0.5) * kPiD / kSectors;
            const double outH = sinOut * sinH * std::cos(phi) + cosOut * cosH;
            const double cosIn = 2.0 * outH * cosH - cosOut;
            if (outH <= 0.0 || cosIn <= 0.0) { continue; }
            sum += outH / (cosOut * cosH * (1.0 + lambdaOut + smithLambda(cosIn, alpha)));
        }
    }
    return sum / (static_cast<double>(kRings) * kSectors);
}

/// The origin of the plane y = 0 from an angle to its normal, in a picture that covers next to nothing.
SceneDescription planeAtAngle(double angleRad, float fovDeg) {
    const Vec3 from(static_cast<float>(-std::sin(angleRad)), static_cast<float>(std::cos(angleRad)), 0.0f);
    SceneDescription scene = emptyStressScene(from, {0, 0, 0}, fovDeg);
    scene.options.maxDepth = 1;
    return scene;
}

Affine levelPlane() { return placeFlatShape({0, 0, 0}, {0, 1, 0}, 1, 1); }

/// As a mesh askew, or as a plane.
void addGreyFloor(SceneDescription* scene, bool mesh) {
    if (mesh) {
        MeshData floor;
        addQuad(&floor, {-3, 0, -2}, {-2, 0, 3}, {3, 0, 2}, {2, 0, -3});
        addMeshObject(scene, std::move(floor), {}, diffuseMaterial(0.5f));
    } else {
        addObject(scene, ShapeKind::Plane, levelPlane(), diffuseMaterial(0.5f));
    }
}

StressCase metalCase(double alpha, double angleDeg) {
    StressCase c = namedCase(
        "roughness", "metal " + gradeNumber(alpha) + " at " + gradeNumber(angleDeg),
        "GGX alpha " + gradeNumber(alpha) + ", seen " + gradeNumber(angleDeg) + " degrees off the normal",
        "directional albedo by quadrature in double");
    c.run = [=](const StressEffort& effort) {
        const double angle = angleDeg * kPiD / 180.0;
        SceneDescription scene = planeAtAngle(angle, 1e-3f);
        scene.environment.color = Vec3(1.0f);
        addObject(&scene, ShapeKind::Plane, levelPlane(), whiteMetal(static_cast<float>(alpha)));
        return measurePaths(scene, effort.passes(128), metalAlbedo(std::cos(angle), alpha), effort);
    };
    return c;
}

/// A point light in the mirror direction of the view: I / d^2 * D(n) G2 / (4 cos), D(n) = 1 / (pi alpha^2).
StressCase highlightCase(double alpha, double angleDeg) {
    StressCase c = namedCase("roughness", "highlight " + gradeNumber(alpha) + " at " + gradeNumber(angleDeg),
                             "the highlight of a point light, GGX alpha " + gradeNumber(alpha),
                             "microfacet model in closed form");
    c.run = [=](const StressEffort& effort) {
        const double angle = angleDeg * kPiD / 180.0;
        SceneDescription scene = planeAtAngle(angle, static_cast<float>(0.01 * alpha * 180.0 / kPiD));
        Light light;
        light.position = {-scene.camera.position.x, scene.camera.position.y, 0.0f};
        light.color = Vec3(static_cast<float>(alpha * alpha));
        scene.lights.push_back(light);
        addObject(&scene, ShapeKind::Plane, levelPlane(), whiteMetal(static_cast<float>(alpha)));
        const double cosine = std::cos(angle);
        const double visible = 1.0 / (1.0 + 2.0 * smithLambda(cosine, alpha));
        return measurePaths(scene, effort.passes(16), visible / (4.0 * kPiD * cosine), effort);
    };
    return c;
}

/// A grey surface under an even sky, seen at an elevation of a few millionths.
StressCase grazingViewCase(double elevation, bool mesh) {
    StressCase c = namedCase(
        "grazing", std::string("view of a ") + (mesh ? "mesh" : "plane") + " " + gradeNumber(elevation),
        "a surface seen " + gradeNumber(elevation) + " radians from edge on", "albedo under an even sky");
    c.run = [=](const StressEffort& effort) {
        const auto y = static_cast<float>(elevation);
        SceneDescription scene = emptyStressScene({-1, y, 0.1f}, {0, 0, 0}, 10.0f * y);
        scene.camera.up = {0, 1, 0};
        scene.environment.color = Vec3(1.0f);
        scene.options.maxDepth = 1;
        addGreyFloor(&scene, mesh);
        return measurePaths(scene, effort.passes(64), 0.5, effort, 2);
    };
    return c;
}

/// A grey surface lit along itself: irradiance times the sine of the elevation.
StressCase grazingLightCase(double elevation, bool mesh) {
    StressCase c = namedCase(
        "grazing", std::string("light on a ") + (mesh ? "mesh" : "plane") + " " + gradeNumber(elevation),
        "light " + gradeNumber(elevation) + " radians from along the surface", "the sine of its elevation");
    c.run = [=](const StressEffort& effort) {
        SceneDescription scene = emptyStressScene({0.3f, 1, 0.2f}, {0, 0, 0}, 5.0f);
        scene.options.maxDepth = 1;
        scene.lights.push_back(directionalLight({1.0f, static_cast<float>(-elevation), 0.3f},
                                                Vec3(static_cast<float>(1.0 / elevation))));
        addGreyFloor(&scene, mesh);
        const double length = std::sqrt(1.0 + elevation * elevation + 0.09);
        return measurePaths(scene, effort.passes(16), 0.5 / (kPiD * length), effort, 2);
    };
    return c;
}

}  // namespace

void addGlossCases(StressCases* cases) {
    for (const double alpha : {1e-4, 1e-3, 1e-2, 0.1, 0.5, 1.0}) {
        for (const double angle : {0.0, 60.0, 85.0, 89.9}) {
            cases->push_back(metalCase(alpha, angle));
        }
    }
    for (const double alpha : {1e-4, 1e-3, 1e-2, 0.1, 1.0}) {
        cases->push_back(highlightCase(alpha, 0.0));
        cases->push_back(highlightCase(alpha, 60.0));
    }
    for (const bool mesh : {false, true}) {
        for (const double elevation : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
            cases->push_back(grazingViewCase(elevation, mesh));
            cases->push_back(grazingLightCase(elevation, mesh));
        }
    }
}

}  // namespace glint
