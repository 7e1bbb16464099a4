// 6.837-style scenes: shapes.
#include <fmt/format.h>

#include "engine/io/scene_text_reader.h"
#include "engine/math/frame.h"
#include "engine/scene/kind_names.h"
#include "engine/scene/profile.h"

namespace glint {
namespace {

/// The plane n.x = offset with the original's texture coordinates as its own x and y: u runs along up x n, v
/// is the world's y, both in world units. Level planes have no such v; they get any frame.
Affine planePlacement(const Vec3& normal, float offset) {
    const Vec3 n = glm::normalize(normal);
    const Vec3 across(n.z, 0.0f, -n.x);  // up x n
    const float steepness = glm::length(across);
    if (steepness < 1e-3f) {
        const Frame frame = Frame::fromNormal(n);
        return {Mat3(frame.s, frame.t, n), offset * n};
    }
    const Vec3 x = across / steepness;
    const Vec3 y = glm::cross(n, x);  // y.y = steepness
    return {Mat3(x / steepness, y / steepness, n), offset * n - (offset * n.y / steepness) * y};
}

}  // namespace

void SceneTextReader::readSphere(const Affine& toWorld) {
    constexpr std::string_view kFields[] = {"center", "radius"};
    const TextToken at = tokens_.take();
    tokens_.expect("{", "Sphere");
    Vec3 center(0.0f);
    float radius = 0.0f;
    while (!tokens_.accept("}") && !tokens_.failed()) {
        if (tokens_.accept("center")) {
            center = tokens_.vec3("center");
        } else if (tokens_.accept("radius")) {
            radius = tokens_.number("radius", 1e-30f, 1e30f, "a radius > 0");
        } else {
            tokens_.failUnknown("Sphere", kFields);
        }
    }
    if (!tokens_.failed() && radius == 0.0f) { tokens_.fail(at, "this Sphere has no radius"); }
    addObject(at, ShapeKind::Sphere, toWorld * Affine{Mat3(radius), center}, -1, false);
}

void SceneTextReader::readPlane(const Affine& toWorld) {
    constexpr std::string_view kFields[] = {"normal", "offset"};
    const TextToken at = tokens_.take();
    tokens_.expect("{", "Plane");
    Vec3 normal(0.0f, 1.0f, 0.0f);
    float offset = 0.0f;
    while (!tokens_.accept("}") && !tokens_.failed()) {
        if (tokens_.accept("normal")) {
            normal = tokens_.direction("normal");
        } else if (tokens_.accept("offset")) {
            offset = tokens_.number("offset");
        } else {
            tokens_.failUnknown("Plane", kFields);
        }
    }
    addObject(at, ShapeKind::Plane, toWorld * planePlacement(normal, offset), -1, true);
}

void SceneTextReader::readTriangle(const Affine& toWorld) {
    constexpr std::string_view kFields[] = {"vertex0", "vertex1", "vertex2"};
    const TextToken at = tokens_.take();
    tokens_.expect("{", "Triangle");
    auto mesh = std::make_shared<MeshData>();
    mesh->positions.assign(3, Vec3(0.0f));
    mesh->indices = {0, 1, 2};
    int read = 0;
    while (!tokens_.accept("}") && !tokens_.failed()) {
        const std::string_view word = tokens_.peek().text;
        if (word == kFields[0] || word == kFields[1] || word == kFields[2]) {
            const auto corner = static_cast<size_t>(word.back() - '0');
            tokens_.take();
            mesh->positions[corner] = tokens_.vec3("a vertex");
            read |= 1 << corner;
        } else {
            tokens_.failUnknown("Triangle", kFields);
        }
    }
    if (!tokens_.failed() && read != 7) {
        tokens_.fail(at, "this Triangle lacks a vertex; expected vertex0, vertex1 and vertex2");
    }
    addObject(at, ShapeKind::Mesh, toWorld, addMesh("", -1, std::move(mesh)), false);
}

void SceneTextReader::readMesh(const Affine& toWorld) {
    tokens_.take();
    tokens_.expect("{", "TriangleMesh");
    tokens_.expect("obj_file", "'TriangleMesh {'");
    const TextToken at = tokens_.peek();
    const std::string path = tokens_.path("a mesh");
    tokens_.expect("}", "the path of a TriangleMesh");
    if (tokens_.failed()) { return; }
    const std::string located = locate(path);
    if (!fileExists(resolvePath(located, scene_.path))) {
        remark(at, "meshes are missing and left out", path);
        if (!missingMesh_) {
            missingMesh_ = tokens_.source().error(
                at.offset, fmt::format("the mesh \"{}\" is missing, and nothing else is there to be seen; "
                                       "--allow-missing goes on without",
                                       path));
        }
        return;
    }
    const auto file = assets_.meshFile({.path = located, .isFaceted = true});
    if (!file) {
        tokens_.fail(at, fmt::format("the mesh cannot be read: {}", file.error().format()));
        return;
    }
    for (size_t part = 0; part < (*file)->parts.size(); ++part) {
        const auto number = static_cast<int>(part);
        addObject(at, ShapeKind::Mesh, toWorld, addMesh(located, number, (*file)->parts[part].mesh), false);
    }
}

void SceneTextReader::readRevSurface(const Affine& toWorld) {
    const TextToken at = tokens_.take();
    tokens_.expect("{", "RevSurface");
    tokens_.expect("profile", "'RevSurface {'");
    const TextToken curve = tokens_.peek();
    Object profile = readCurve();
    tokens_.expect("}", "the profile of a RevSurface");
    const std::string problem = profileFault(profile);
    if (!problem.empty() && !tokens_.failed()) { tokens_.fail(curve, problem); }
    addObject(at, ShapeKind::Revolved, toWorld, -1, false);
    if (tokens_.failed()) { return; }
    Object& object = scene_.objects.back();
    object.curve = profile.curve;
    object.profile = std::move(profile.profile);
}

/// An object with the curve and the points alone. They lie in the plane z = 0.
Object SceneTextReader::readCurve() {
    constexpr std::string_view kCurves[] = {"BezierCurve", "BsplineCurve"};
    Object object;
    const TextToken at = tokens_.peek();
    if (at.text != kCurves[0] && at.text != kCurves[1]) {
        tokens_.failUnknown("a profile", kCurves);
        return object;
    }
    tokens_.take();
    object.curve = at.text == kCurves[0] ? CurveKind::Bezier : CurveKind::Bspline;
    tokens_.expect("{", "a curve");
    tokens_.expect("controls", "the curve's '{'");
    while (tokens_.accept("[")) {
        object.profile.emplace_back(tokens_.vec3("a control point"));
        tokens_.expect("]", "a control point");
    }
    tokens_.expect("}", "the control points");
    const size_t points = object.profile.size();
    if (object.curve == CurveKind::Bezier && (points < 4 || points % 3 != 1)) {
        tokens_.fail(
            at, fmt::format("this BezierCurve has {} points; expected 3k + 1 of them, at least 4", points));
    } else if (points < 4) {
        tokens_.fail(at, fmt::format("this BsplineCurve has {} points; expected at least 4", points));
    }
    return object;
}

void SceneTextReader::addObject(const TextToken& at, ShapeKind shape, const Affine& toWorld, int mesh,
                                bool frontOnly) {
    if (!tokens_.failed() && !isInvertible(toWorld)) {
        tokens_.fail(at, "this object is flattened or not finite; expected numbers that leave it a size");
    }
    if (tokens_.failed()) { return; }
    Object object;
    object.name =
        fmt::format("object {} ({})", scene_.objects.size() + 1,
                    shape == ShapeKind::Mesh ? scene_.meshes[static_cast<size_t>(mesh)].name : nameOf(shape));
    object.shape = shape;
    object.mesh = mesh;
    object.material = materialIndex_;
    object.objectToWorld = toWorld;
    object.frontOnly = frontOnly;
    scene_.objects.push_back(std::move(object));
}

int SceneTextReader::addMesh(const std::string& path, int part, std::shared_ptr<const MeshData> data) {
    const std::pair<std::string, int> key(path, part);
    if (const auto found = meshes_.find(key); !path.empty() && found != meshes_.end()) {
        return found->second;
    }
    const auto index = static_cast<int>(scene_.meshes.size());
    Mesh& mesh = scene_.meshes.emplace_back();
    mesh.name =
        path.empty() ? fmt::format("triangle {}", index + 1) : path.substr(path.find_last_of('/') + 1);
    // The original shades triangles without normals as they are.
    if (!path.empty()) { mesh.source = FileSource{path, part, true}; }
    mesh.data = std::move(data);
    if (!path.empty()) { meshes_[key] = index; }
    return index;
}

}  // namespace glint
