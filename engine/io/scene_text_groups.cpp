// 6.837-style scenes: groups and transforms.
#include <fmt/format.h>

#include "engine/io/angle.h"
#include "engine/io/scene_text_reader.h"

namespace glint {
namespace {

constexpr int kMaxDepth = 64;
constexpr std::string_view kObjects[] = {"Sphere",      "Plane",       "Triangle",      "TriangleMesh",
                                         "Transform",   "Group",       "MaterialIndex", "RevSurface",
                                         "BezierCurve", "BsplineCurve"};

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

}  // namespace glint
