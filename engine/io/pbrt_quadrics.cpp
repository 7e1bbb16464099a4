// pbrt's rectangles, spheres, disks, cylinders and curves. Whole ones are Glint's shapes, others meshes.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "engine/io/pbrt_grid.h"
#include "engine/io/pbrt_shapes.h"

namespace glint {
namespace {

constexpr float kRadians = kPi / 180.0f;
constexpr int kAround = 96, kAlong = 48;

/// A flat shape's front, turned over about x.
const Affine kTurnedOver{Mat3(1, 0, 0, 0, -1, 0, 0, 0, -1), Vec3(0.0f)};
/// Glint's north is +y, and its u begins at -z; pbrt's north is +z, and its u begins at +x.
const Affine kSphereAxes{Mat3(0, -1, 0, 0, 0, 1, -1, 0, 0), Vec3(0.0f)};
/// Turned profiles have their axis in y, pbrt's cylinders in z.
const Affine kCylinderAxes{Mat3(1, 0, 0, 0, 0, 1, 0, -1, 0), Vec3(0.0f)};

float phiMaxOf(const PbrtParams& params) { return kRadians * params.number("phimax", 360.0f, 0.01f, 360.0f); }

bool isWhole(float phiMax) { return phiMax > 359.999f * kRadians; }

int columnsOf(float phiMax) {
    return std::max(3, static_cast<int>(std::ceil(static_cast<float>(kAround) * phiMax / kTwoPi)));
}

}  // namespace

PbrtShapes::Piece PbrtShapes::rectangle(const Affine& place, const Wish& wish) {
    Piece piece;
    piece.object.shape = ShapeKind::Rectangle;
    piece.object.objectToWorld = wish.state.isReversed ? place * kTurnedOver : place;
    const Affine toWorld = affineOf(&context_, wish.params.place(), wish.state.transform) * place;
    piece.area = static_cast<double>(4.0f * glm::length(glm::cross(toWorld.linear[0], toWorld.linear[1])));
    wish.params.passOver({"P", "indices", "emissionfilename"});
    return piece;
}

PbrtShapes::Piece PbrtShapes::sphere(const Wish& wish) {
    const PbrtParams& params = wish.params;
    const float radius = params.number("radius", 1.0f, 0.0f), phiMax = phiMaxOf(params);
    const float a = params.number("zmin", -radius), b = params.number("zmax", radius);
    const float low = std::clamp(std::min(a, b), -radius, radius),
                high = std::clamp(std::max(a, b), -radius, radius);
    Piece piece;
    piece.area = static_cast<double>(phiMax * radius * (high - low));
    const bool isAll = isWhole(phiMax) && low <= -radius && high >= radius;
    if (isAll && !(wish.state.isReversed && wish.needsSides)) {
        piece.object.shape = ShapeKind::Sphere;
        piece.object.objectToWorld = scale(Vec3(radius)) * kSphereAxes;
        return piece;
    }
    if (!(radius > 0.0f && high > low)) {
        piece.isThere = false;
        params.approximated("shapes that are flattened are left out");
        return piece;
    }
    const float south = std::acos(low / radius), north = std::acos(high / radius);
    const auto mesh = gridMesh(columnsOf(phiMax), kAlong, [&](float u, float v) {
        const float phi = u * phiMax, theta = glm::mix(south, north, v);
        const Vec3 n(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
        return GridPoint{radius * n, n};
    });
    Piece of = ofMesh(meshes_.add("sphere", mesh, wish.state.isReversed), wish);
    of.area = piece.area;
    of.parts = 1;
    return of;
}

PbrtShapes::Piece PbrtShapes::disk(const Wish& wish) {
    const PbrtParams& params = wish.params;
    const float radius = params.number("radius", 1.0f, 0.0f),
                inner = params.number("innerradius", 0.0f, 0.0f);
    const float height = params.number("height", 0.0f), phiMax = phiMaxOf(params);
    Piece piece;
    piece.area = static_cast<double>(0.5f * phiMax * (radius * radius - inner * inner));
    if (isWhole(phiMax) && inner == 0.0f && !wish.isTextured) {
        piece.object.shape = ShapeKind::Disc;
        piece.object.objectToWorld = translate(Vec3(0, 0, height)) * scale(Vec3(radius, radius, radius));
        if (wish.state.isReversed) { piece.object.objectToWorld = piece.object.objectToWorld * kTurnedOver; }
        return piece;
    }
    const auto mesh = gridMesh(columnsOf(phiMax), 1, [&](float u, float v) {
        const float r = glm::mix(radius, inner, v), phi = u * phiMax;
        return GridPoint{Vec3(r * std::cos(phi), r * std::sin(phi), height), Vec3(0, 0, 1)};
    });
    Piece of = ofMesh(meshes_.add("disk", mesh, wish.state.isReversed), wish);
    of.area = piece.area;
    of.parts = 1;
    return of;
}

PbrtShapes::Piece PbrtShapes::cylinder(const Wish& wish) {
    const PbrtParams& params = wish.params;
    const float radius = params.number("radius", 1.0f, 0.0f), phiMax = phiMaxOf(params);
    const float a = params.number("zmin", -1.0f), b = params.number("zmax", 1.0f);
    const float low = std::min(a, b), high = std::max(a, b);
    Piece piece;
    piece.area = static_cast<double>((high - low) * radius * phiMax);
    if (!(radius > 0.0f && high > low)) {
        piece.isThere = false;
        params.approximated("shapes that are flattened are left out");
        return piece;
    }
    if (isWhole(phiMax) && !(wish.state.isReversed && wish.needsSides)) {
        piece.object.shape = ShapeKind::Revolved;
        piece.object.curve = CurveKind::Bezier;
        piece.object.curveDegree = 1;
        piece.object.profile = {{radius, high}, {radius, low}};
        piece.object.objectToWorld = kCylinderAxes;
        return piece;
    }
    const auto mesh = gridMesh(columnsOf(phiMax), 1, [&](float u, float v) {
        const Vec3 n(std::cos(u * phiMax), std::sin(u * phiMax), 0.0f);
        return GridPoint{radius * n + Vec3(0, 0, glm::mix(low, high, v)), n};
    });
    Piece of = ofMesh(meshes_.add("cylinder", mesh, wish.state.isReversed), wish);
    of.area = piece.area;
    of.parts = 1;
    return of;
}

/// pbrt-v3's: their normals are those of the surface's own u and v.
PbrtShapes::Piece PbrtShapes::oldQuadric(const std::string& kind, const Wish& wish) {
    const PbrtParams& params = wish.params;
    const float radius = params.number("radius", 1.0f, 0.0f), phiMax = phiMaxOf(params);
    const float height = params.number("height", 1.0f), low = params.number("zmin", 0.0f);
    const float high = params.number("zmax", 1.0f);
    const Vec3 p1 = params.point("p1", Vec3(0.0f)), p2 = params.point("p2", Vec3(1.0f));
    const auto profile = [&](float v) -> Vec3 {
        if (kind == "cone") { return {radius * (1.0f - v), 0.0f, height * v}; }
        const float z = glm::mix(low, high, v);
        if (kind == "paraboloid") { return {radius * safeSqrt(high > 0.0f ? z / high : 0.0f), 0.0f, z}; }
        return glm::mix(p1, p2, v);
    };
    const auto mesh = gridMesh(columnsOf(phiMax), kAlong, [&](float u, float v) {
        constexpr float kStep = 1e-3f;
        const float c = std::cos(u * phiMax), s = std::sin(u * phiMax);
        const auto turned = [&](const Vec3& p) { return Vec3(c * p.x - s * p.y, s * p.x + c * p.y, p.z); };
        const float before = std::max(v - kStep, 0.0f), after = std::min(v + kStep, 1.0f);
        const Vec3 along = turned(profile(after)) - turned(profile(before));
        const Vec3 at = turned(profile(clampf(v, kStep, 1.0f - kStep))),
                   n = glm::cross(Vec3(-at.y, at.x, 0.0f), along);
        const float length = glm::length(n);
        return GridPoint{turned(profile(v)), length > 0.0f ? n / length : Vec3(0.0f)};
    });
    Piece of = ofMesh(meshes_.add(kind, mesh, wish.state.isReversed), wish);
    of.parts = 1;
    return of;
}

void PbrtShapes::placeCurve(const PbrtParams& params, const PbrtState& state, std::vector<Object>* out) {
    const float width = params.number("width", 1.0f, 0.0f);
    const float width0 = params.number("width0", width, 0.0f), width1 = params.number("width1", width, 0.0f);
    const int degree = params.integer("degree", 3, 2, 3);
    const bool isSpline = params.text("basis", "bezier") == "bspline";
    if (params.text("type", "flat") == "ribbon") { params.approximated("approximated: ribbons are tubes"); }
    if (state.areaLight >= 0) { params.approximated("approximated: curves do not shine"); }
    params.passOver({"N", "splitdepth", "alpha"});
    const std::vector<Vec3> p = params.points("P");
    const auto step = static_cast<size_t>(isSpline ? 1 : degree), order = static_cast<size_t>(degree);
    if (p.size() < order + 1 || (p.size() - 1) % step != 0) {
        params.fail(fmt::format("the curve has {} points; expected {}", p.size(),
                                isSpline
                                    ? fmt::format("at least {}", degree + 1)
                                    : fmt::format("{} and any number of times {} more", degree + 1, degree)));
    }
    if (context_.failed()) { return; }
    const int material = materials_.take(state.material, PbrtValue{Vec3(1.0f)}, {});
    const bool goesOn = curves_.mesh && curves_.material == material && curves_.transform == state.transform;
    if (!goesOn) { curves_ = {std::make_shared<MeshData>(), material, state.transform}; }
    const size_t segments = isSpline ? p.size() - order : (p.size() - 1) / order;
    for (size_t i = 0; i < segments; ++i) {
        const Vec3* c = &p[i * step];
        std::array<Vec3, 4> cubic;
        if (order == 2) {
            const Vec3 first = isSpline ? 0.5f * (c[0] + c[1]) : c[0],
                       last = isSpline ? 0.5f * (c[1] + c[2]) : c[2];
            cubic = {first, glm::mix(first, c[1], 2.0f / 3.0f), glm::mix(last, c[1], 2.0f / 3.0f), last};
        } else if (isSpline) {
            cubic = {(c[0] + 4.0f * c[1] + c[2]) / 6.0f, (2.0f * c[1] + c[2]) / 3.0f,
                     (c[1] + 2.0f * c[2]) / 3.0f, (c[1] + 4.0f * c[2] + c[3]) / 6.0f};
        } else {
            cubic = {c[0], c[1], c[2], c[3]};
        }
        const float u0 = static_cast<float>(i) / static_cast<float>(segments);
        const float u1 = static_cast<float>(i + 1) / static_cast<float>(segments);
        appendTube(cubic, glm::mix(width0, width1, u0), glm::mix(width0, width1, u1), u0, u1,
                   curves_.mesh.get());
    }
    params.finish();
    context_.note(params.place(), "curves are tubes of four sides, as wide as a round one in the mean");
    if (curves_.mesh->indices.empty()) { endCurves(); }
    if (goesOn || !curves_.mesh) { return; }
    Object object;
    object.shape = ShapeKind::Mesh;
    object.name = "curves";
    object.material = material;
    object.mesh = meshes_.add("curves", curves_.mesh, false);
    object.objectToWorld = affineOf(&context_, params.place(), state.transform);
    out->push_back(std::move(object));
}

}  // namespace glint
