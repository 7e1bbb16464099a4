// 6.837-style scenes: groups, transforms and shapes.
#include <fmt/format.h>

#include "engine/io/scene_text_reader.h"
#include "engine/math/frame.h"
#include "engine/scene/kind_names.h"
#include "engine/scene/profile.h"

namespace glint {
namespace {

constexpr int kMaxDepth = 64;
constexpr std::string_view kObjects[] = {"Sphere",      "Plane",       "Triangle",      "TriangleMesh",
                                         "Transform",   "Group",       "MaterialIndex", "RevSurface",
                                         "BezierCurve", "BsplineCurve"};

float radians(float degrees) { return degrees * (kPi / 180.0f); }

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

void SceneTextReader::readGroup(const Affine& toWorld, int depth) {
    const TextToken at = tokens_.take();
    if (depth > kMaxDepth) {
        tokens_.fail(at, fmt::format("groups and transforms nested deeper than {} levels", kMaxDepth));
        return;
    }
    tokens_.expect("{", "Group");
    tokens_.expect("numObjects", "'Group {'");
    const int count = tokens_.integer("numObjects", 0, 100'000'000);
    int read = 0;
    while (!tokens_.failed() && !tokens_.accept("}")) {
        if (tokens_.accept("MaterialIndex")) {
            const int last = std::max(0, static_cast<int>(scene_.materials.size()) - 1);
            materialIndex_ = tokens_.integer("MaterialIndex", 0, last);
        } else if (tokens_.atEnd()) {
            tokens_.fail(at, "this Group is never closed; expected '}' before the file ends");
        } else if (read == count) {
            tokens_.fail(tokens_.peek(),
                         fmt::format("more than the {} objects that numObjects promised", count));
        } else {
            readObject(toWorld, depth + 1);
            ++read;
        }
    }
    if (!tokens_.failed() && read != count) {
        tokens_.fail(at, fmt::format("this Group has {} objects; numObjects promised {}", read, count));
    }
}

void SceneTextReader::readObject(const Affine& toWorld, int depth) {
    const std::string_view word = tokens_.peek().text;
    if (word == "Sphere") {
        readSphere(toWorld);
    } else if (word == "Plane") {
        readPlane(toWorld);
    } else if (word == "Triangle") {
        readTriangle(toWorld);
    } else if (word == "TriangleMesh") {
        readMesh(toWorld);
    } else if (word == "Transform") {
        readTransform(toWorld, depth);
    } else if (word == "Group") {
        readGroup(toWorld, depth);
    } else if (word == "RevSurface") {
        readRevSurface(toWorld);
    } else if (word == "BezierCurve" || word == "BsplineCurve") {
        remark(tokens_.peek(), "curves have no surface, so nothing of them is drawn", word);
        readCurve();
    } else {
        tokens_.failUnknown("Group", kObjects);
    }
}

void SceneTextReader::readTransform(const Affine& toWorld, int depth) {
    const TextToken at = tokens_.take();
    if (depth > kMaxDepth) {
        tokens_.fail(at, fmt::format("groups and transforms nested deeper than {} levels", kMaxDepth));
        return;
    }
    tokens_.expect("{", "Transform");
    Affine transform;
    while (!tokens_.failed() && readOperation(&transform)) {}
    if (!tokens_.failed() && !isInvertible(transform)) {
        tokens_.fail(at, "this Transform flattens its object; expected scales other than 0");
    }
    if (!tokens_.failed()) { readObject(toWorld == Affine() ? transform : toWorld * transform, depth + 1); }
    tokens_.expect("}", "the object of a Transform");
}

bool SceneTextReader::readOperation(Affine* transform) {
    if (tokens_.accept("Translate")) {
        *transform = *transform * translate(tokens_.vec3("Translate"));
    } else if (tokens_.accept("Scale")) {
        *transform = *transform * scale(tokens_.vec3("Scale"));
    } else if (tokens_.accept("UniformScale")) {
        *transform = *transform * scale(Vec3(tokens_.number("UniformScale")));
    } else if (tokens_.accept("XRotate")) {
        *transform = *transform * rotate(Vec3(1.0f, 0.0f, 0.0f), radians(tokens_.number("XRotate")));
    } else if (tokens_.accept("YRotate")) {
        *transform = *transform * rotate(Vec3(0.0f, 1.0f, 0.0f), radians(tokens_.number("YRotate")));
    } else if (tokens_.accept("ZRotate")) {
        *transform = *transform * rotate(Vec3(0.0f, 0.0f, 1.0f), radians(tokens_.number("ZRotate")));
    } else if (tokens_.accept("Rotate")) {
        tokens_.expect("{", "Rotate");
        const Vec3 axis = tokens_.direction("the axis of Rotate");
        const float angleDeg = tokens_.number("the angle of Rotate");
        tokens_.expect("}", "Rotate's axis and angle");
        if (!tokens_.failed()) { *transform = *transform * rotate(axis, radians(angleDeg)); }
    } else if (tokens_.peek().text == "Matrix4f") {
        const TextToken at = tokens_.take();
        tokens_.expect("{", "Matrix4f");
        float m[16];
        for (float& entry : m) {
            entry = tokens_.number("Matrix4f");
        }
        tokens_.expect("}", "the 16 numbers of Matrix4f");
        if (m[3] != 0.0f || m[7] != 0.0f || m[11] != 0.0f || m[15] != 1.0f) {
            tokens_.fail(
                at,
                "this Matrix4f is projective; expected a last row of 0 0 0 1 (numbers go column by column)");
        }
        const Affine matrix{Mat3(m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]),
                            Vec3(m[12], m[13], m[14])};
        *transform = matrix * *transform;
    } else {
        return false;
    }
    return true;
}

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
    const auto file = assets_.meshFile(located);
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
    if (!path.empty()) { mesh.source = FileSource{path, part}; }
    mesh.data = std::move(data);
    if (!path.empty()) { meshes_[key] = index; }
    return index;
}

}  // namespace glint
