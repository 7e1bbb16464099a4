// Glint JSON: where a shape stands. Center, radius, edges and normals first, then the "transform" steps.
#include <fmt/format.h>

#include "engine/base/nearest_name.h"
#include "engine/io/scene_json_keys.h"
#include "engine/io/scene_json_reader.h"
#include "engine/math/frame.h"

namespace glint {
namespace {

float radians(float degrees) { return degrees * (kPi / 180.0f); }

/// Columns x, y and z and the origin.
Affine axes(const Vec3& x, const Vec3& y, const Vec3& z, const Vec3& origin) {
    return {Mat3(x, y, z), origin};
}

Affine facing(const Vec3& normal, float radius, const Vec3& origin) {
    const Frame frame = Frame::fromNormal(glm::normalize(normal));
    return axes(radius * frame.s, radius * frame.t, radius * frame.n, origin);
}

}  // namespace

Affine SceneJsonReader::readPlacement(ShapeKind shape, const JsonFields& fields) {
    if (!fields.hasAny({"center", "radius", "point", "normal", "edgeU", "edgeV"})) {
        return {};  // Exactly the canonical shape: a saved matrix must come back bit for bit.
    }
    Vec3 center(0.0f);
    Vec3 normal(0.0f, 0.0f, 1.0f);
    float radius = 1.0f;
    switch (shape) {
        case ShapeKind::Sphere:
            fields.vec3("center", &center);
            fields.number("radius", kPositive, &radius);
            return {Mat3(radius), center};
        case ShapeKind::Plane:
            fields.vec3("point", &center);
            fields.direction("normal", &normal);
            return facing(normal, 1.0f, center);
        case ShapeKind::Disc:
            fields.vec3("center", &center);
            fields.direction("normal", &normal);
            fields.number("radius", kPositive, &radius);
            return facing(normal, radius, center);
        case ShapeKind::Rectangle: {
            Vec3 edgeU(2.0f, 0.0f, 0.0f);
            Vec3 edgeV(0.0f, 2.0f, 0.0f);
            fields.vec3("center", &center);
            fields.direction("edgeU", &edgeU);
            fields.direction("edgeV", &edgeV);
            const Vec3 across = glm::cross(glm::normalize(edgeU), glm::normalize(edgeV));
            if (lengthSquared(across) < 1e-12f) {
                errors_.add(fields.object(),
                            "\"edgeU\" and \"edgeV\" are parallel; expected two edges of a rectangle");
                return {};
            }
            const float depth = 0.5f * std::sqrt(glm::length(edgeU)) * std::sqrt(glm::length(edgeV));
            return axes(0.5f * edgeU, 0.5f * edgeV, depth * glm::normalize(across), center);
        }
        case ShapeKind::Mesh:
            break;
    }
    return {};
}

Affine SceneJsonReader::readTransform(const JsonValue& value) {
    Affine transform;
    if (!value.present()) { return transform; }
    if (value.is(JsonType::Object)) { return readTransformStep(value); }
    if (!expectType(errors_, value, "transform", JsonType::Array)) { return transform; }
    forEachItem(errors_, value, [&](const JsonValue& step, size_t number) {
        const Affine next = readTransformStep(step);
        transform = number == 0 ? next : next * transform;
    });
    return transform;
}

Affine SceneJsonReader::readTransformStep(const JsonValue& value) {
    const JsonFields fields = fieldsOf(value, "transform step", "transformStep");
    if (errors_.failed()) { return {}; }
    if (value.size() != 1) {
        errors_.add(value, fmt::format("a transform step has {} keys; expected one of {}", value.size(),
                                       joinNames(sceneJsonKeys("transformStep"))));
        return {};
    }
    Vec3 vector(0.0f);
    float angleDeg = 0.0f;
    if (fields.find("translate").present()) {
        fields.vec3("translate", &vector);
        return translate(vector);
    }
    if (fields.find("scale").present()) {
        fields.color("scale", kAnyNumber, &vector);
        return scale(vector);
    }
    if (const JsonValue rotation = fields.find("rotate"); rotation.present()) {
        const JsonFields turn = fieldsOf(rotation, "rotate", "rotation");
        turn.require("axis");
        turn.require("angleDeg");
        vector = Vec3(0.0f, 1.0f, 0.0f);
        turn.direction("axis", &vector);
        turn.number("angleDeg", kAnyNumber, &angleDeg);
        return errors_.failed() ? Affine() : rotate(vector, radians(angleDeg));
    }
    if (const JsonValue matrix = fields.find("matrix"); matrix.present()) {
        float m[12] = {};
        readNumbers(errors_, matrix, "matrix", kAnyNumber, 12, m);
        return axes({m[0], m[4], m[8]}, {m[1], m[5], m[9]}, {m[2], m[6], m[10]}, {m[3], m[7], m[11]});
    }
    constexpr std::string_view kTurns[] = {"rotateXDeg", "rotateYDeg", "rotateZDeg"};
    for (int axis = 0; axis < 3; ++axis) {
        if (fields.find(kTurns[axis]).present()) {
            fields.number(kTurns[axis], kAnyNumber, &angleDeg);
            vector[axis] = 1.0f;
        }
    }
    return rotate(vector, radians(angleDeg));
}

}  // namespace glint
