// Glint JSON: where a shape stands. Center, radius, edges and normals first, then the "transform" steps.
#include <fmt/format.h>

#include "engine/base/nearest_name.h"
#include "engine/io/angle.h"
#include "engine/io/scene_json_keys.h"
#include "engine/io/scene_json_reader.h"

namespace glint {

Affine SceneJsonReader::readPlacement(const ShapeForm& form, const JsonFields& fields) {
    Placement values;
    bool isPlaced = false;
    for (size_t i = 0; i < form.keys().size(); ++i) {
        const PlacementKey& key = form.keys()[i];
        values[i] = key.usual;
        isPlaced |= fields.find(key.key).present();
        switch (key.form) {
            case PlacementForm::Point:
                fields.vec3(key.key, &values[i]);
                break;
            case PlacementForm::Direction:
                fields.direction(key.key, &values[i]);
                break;
            case PlacementForm::Length:
                fields.number(key.key, kPositive, &values[i].x);
                break;
        }
    }
    // Without any of the keys exactly the canonical shape: a saved matrix must come back bit for bit.
    if (!isPlaced) { return {}; }
    Affine placed;
    if (!form.transform(values, &placed)) { errors_.add(fields.object(), form.refusal); }
    return placed;
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
    const JsonFields fields = fieldsOf(value, "transform step", formKeys("transformStep"));
    if (errors_.failed()) { return {}; }
    if (value.size() != 1) {
        errors_.add(value, fmt::format("a transform step has {} keys; expected one of {}", value.size(),
                                       joinNames(formKeys("transformStep"))));
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
        const JsonFields turn = fieldsOf(rotation, "rotate", formKeys("rotation"));
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
        return {Mat3(m[0], m[4], m[8], m[1], m[5], m[9], m[2], m[6], m[10]), {m[3], m[7], m[11]}};
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
