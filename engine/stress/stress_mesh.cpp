// Meshes that exporters make: triangles without area, doubled faces, sheets all but on one another,
// a ground ten million times larger than what stands on it.
//
// The truths are a grey surface under an even sky (albedo times radiance, whatever its triangles), closed
// forms, and the same scene on a ground of its own size.
#include <cmath>
#include <numbers>

#include "engine/stress/stress_families.h"
#include "engine/stress/stress_render.h"
#include "engine/stress/stress_scene.h"

namespace glint {
namespace {

constexpr float kAlbedo = 0.5f;
constexpr double kGrey = 0.5;

MeshData plainFloor(float halfSize, float height, float slope) {
    MeshData mesh;
    const float lift = slope * halfSize;
    addQuad(&mesh, {-halfSize, height - lift, -halfSize}, {-halfSize, height - lift, halfSize},
            {halfSize, height + lift, halfSize}, {halfSize, height + lift, -halfSize});
    return mesh;
}

/// A floor of two triangles much larger than the way from the eye to it.
StressCase largeFloorCase(float halfSize, float height, float slope) {
    StressCase c =
        namedCase("ratio",
                  "floor " + gradeNumber(halfSize) + (slope != 0.0f ? ", sloping" : "") +
                      (height == 0.0f ? ", at y = 0" : ""),
                  "triangles " + gradeNumber(halfSize) + " times as large as the distance they are seen from",
                  "albedo under an even sky");
    c.run = [=](const StressEffort& effort) {
        SceneDescription scene = emptyStressScene({0.05f, height + 1.0f, 0.02f}, {0.3f, height, 0.1f}, 10.0f);
        scene.environment.color = Vec3(1.0f);
        scene.options.maxDepth = 1;
        addMeshObject(&scene, plainFloor(halfSize, height, slope), {}, diffuseMaterial(kAlbedo));
        return measurePaths(scene, effort.passes(64), kGrey, effort, 2);
    };
    return c;
}

/// A block of size 1 and the ground it stands on in one mesh.
SceneDescription blockOnGround(float groundHalfSize) {
    SceneDescription scene = emptyStressScene({2.5f, 1.5f, 2.0f}, {0.2f, 0.3f, 0.1f}, 35.0f, 32);
    MeshData mesh = plainFloor(groundHalfSize, 0.0f, 0.0f);
    addBox(&mesh, {-0.5f, 0.0f, -0.5f}, {0.5f, 0.8f, 0.5f}, false);
    addMeshObject(&scene, std::move(mesh), rotate({0.2f, 1.0f, 0.1f}, 0.3f), diffuseMaterial(0.7f));
    scene.lights.push_back(directionalLight({-0.5f, -1.0f, -0.7f}, Vec3(3.0f)));
    scene.environment.color = Vec3(0.3f);
    scene.options.maxDepth = 4;
    return scene;
}

StressCase groundCase(float ratio) {
    StressCase c =
        namedCase("ratio", "block on ground " + gradeNumber(ratio),
                  "a ground " + gradeNumber(ratio) + " times as large as the block in the same mesh",
                  "the same block on a ground a hundred times its size");
    c.tolerance = 0.01;  // the horizon of the smaller ground lies some hundredths of a radian lower
    c.run = [=](const StressEffort& effort) {
        return measurePathsAgainst(blockOnGround(ratio), blockOnGround(100.0f), effort.passes(96), effort);
    };
    return c;
}

/// Adds triangles without area: repeated corners, three corners on a line, a point.
void addDegenerates(MeshData* mesh) {
    const auto first = static_cast<uint32_t>(mesh->positions.size());
    mesh->positions.insert(mesh->positions.end(), {{0, 0, 0}, {0.5f, 0, 0}, {1, 0, 0}, {0, 0, 0}});
    for (const uint32_t corner : {0u, 0u, 1u, 0u, 1u, 2u, 2u, 1u, 0u, 0u, 3u, 0u, 1u, 1u, 1u}) {
        mesh->indices.push_back(first + corner);
    }
}

void addDuplicates(MeshData* mesh) {
    const std::vector<uint32_t> once = mesh->indices;
    mesh->indices.insert(mesh->indices.end(), once.begin(), once.end());
}

StressCase faultyFloorCase(const char* what, void (*spoil)(MeshData*)) {
    StressCase c = namedCase("degenerate", std::string("floor with ") + what,
                             std::string("a mesh with ") + what, "albedo under an even sky");
    c.run = [=](const StressEffort& effort) {
        MeshData mesh = plainFloor(1.0f, 0.0f, 0.0f);
        spoil(&mesh);
        return measurePaths(skyOverMesh(std::move(mesh), 0.3f, true), effort.passes(64), kGrey, effort, 4);
    };
    return c;
}

StressCase faultyEmitterCase(const char* what, void (*spoil)(MeshData*)) {
    StressCase c = namedCase("degenerate", std::string("lamp with ") + what,
                             std::string("a lamp with ") + what, "irradiance in closed form");
    c.run = [=](const StressEffort& effort) {
        MeshData emitter;
        addQuad(&emitter, {-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1});
        spoil(&emitter);
        SceneDescription scene = emptyStressScene({0.3f, 0.5f, 0.4f}, {0, 0, 0}, 0.05f);
        scene.options.maxDepth = 1;
        addObject(&scene, ShapeKind::Plane, placeFlatShape({0, 0, 0}, {0, 1, 0}, 1, 1),
                  diffuseMaterial(kAlbedo));
        addMeshObject(&scene, std::move(emitter), translate({0, 1, 0}), emissiveMaterial(Vec3(1.0f)));
        const double root = std::numbers::sqrt2;
        return measurePaths(scene, effort.passes(256),
                            kGrey / std::numbers::pi * 4.0 / root * std::atan(1.0 / root), effort);
    };
    return c;
}

/// A sheet of the height `gap` over a black floor, both of size 1 and not at y = 0, where gaps would
/// be exact.
StressCase sheetCase(float gap) {
    StressCase c =
        namedCase("coplanar", "sheet " + gradeNumber(gap) + " over another",
                  "two sheets with a gap of " + gradeNumber(gap) + " of their size", "the upper sheet alone");
    if (gap < 1e-7f) {
        c.documented = StressVerdict::Broken;
        c.limit =
            "both sheets have the same vertices in float: which of two faces in one place is met is open";
    }
    c.run = [=](const StressEffort& effort) {
        constexpr float kFloorHeight = 0.75f;
        SceneDescription scene = emptyStressScene({0.2f, 1.8f, 0.3f}, {0, kFloorHeight, 0}, 20.0f);
        scene.environment.color = Vec3(1.0f);
        scene.options.maxDepth = 8;
        addMeshObject(&scene, plainFloor(1.0f, kFloorHeight, 0.25f), {}, diffuseMaterial(0.0f));
        addMeshObject(&scene, plainFloor(1.0f, kFloorHeight + gap, 0.25f), {}, diffuseMaterial(kAlbedo));
        return measurePaths(scene, effort.passes(64), kGrey, effort, 4);
    };
    return c;
}

/// The same sheet twice in one place: whichever is met, it is the same surface.
StressCase doubledSheetCase() {
    StressCase c = namedCase("coplanar", "the same sheet twice", "two objects in the very same place",
                             "albedo under an even sky");
    c.run = [=](const StressEffort& effort) {
        SceneDescription scene = skyOverMesh(plainFloor(1.0f, 0.0f, 0.0f), 0.4f, true);
        addMeshObject(&scene, plainFloor(1.0f, 0.0f, 0.0f), scene.objects[0].objectToWorld,
                      diffuseMaterial(kAlbedo));
        return measurePaths(scene, effort.passes(64), kGrey, effort, 4);
    };
    return c;
}

/// Two squares in one plane and one mesh, the second turned and shifted: their triangles overlap in part.
/// Whichever is met, it is the same surface, and neither may lie in the other's shadow.
StressCase overlapCase(float slope) {
    StressCase c = namedCase("coplanar", "overlapping faces" + std::string(slope != 0.0f ? ", sloping" : ""),
                             "two faces of one mesh that overlap in one plane", "albedo under an even sky");
    c.run = [=](const StressEffort& effort) {
        MeshData mesh = plainFloor(1.0f, 0.0f, slope);
        const auto corner = [&](float angle) {
            const float x = 0.02f + 0.15f * std::cos(angle);
            return Vec3(x, slope * x, 0.15f * std::sin(angle) - 0.03f);
        };
        addQuad(&mesh, corner(0.3f), corner(0.3f - 0.5f * kPi), corner(0.3f - kPi),
                corner(0.3f - 1.5f * kPi));
        return measurePaths(skyOverMesh(std::move(mesh), 0.5f, false), effort.passes(64), kGrey, effort, 4);
    };
    return c;
}

}  // namespace

void addMeshCases(StressCases* cases) {
    cases->push_back(faultyFloorCase("triangles without area", addDegenerates));
    cases->push_back(faultyFloorCase("every triangle twice", addDuplicates));
    cases->push_back(faultyEmitterCase("triangles without area", addDegenerates));
    cases->push_back(faultyEmitterCase("every triangle twice", addDuplicates));
    for (const float gap : {1e-2f, 1e-4f, 1e-5f, 1e-6f, 1e-7f, 1e-8f}) {
        cases->push_back(sheetCase(gap));
    }
    cases->push_back(doubledSheetCase());
    cases->push_back(overlapCase(0.0f));
    cases->push_back(overlapCase(0.37f));
    for (const float slope : {0.0f, 0.37f}) {
        for (const float size : {1.0f, 1e2f, 1e4f, 1e6f, 1e7f}) {
            cases->push_back(largeFloorCase(size, 0.0f, slope));
        }
    }
    for (const float size : {1e2f, 1e4f}) {
        cases->push_back(largeFloorCase(size, 0.3f, 0.0f));
    }
    for (const float ratio : {1e3f, 1e4f, 1e5f, 1e6f, 1e7f}) {
        cases->push_back(groundCase(ratio));
    }
}

}  // namespace glint
