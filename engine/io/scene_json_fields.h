// Glint JSON: reads the fields of a type into an object. For the scene reader's files.
#pragma once

#include <fmt/format.h>

#include "engine/io/scene_json_keys.h"
#include "engine/io/scene_json_reader.h"
#include "engine/scene/kind_names.h"

namespace glint {

template <class Member>
void SceneJsonReader::readValue(const JsonFields& fields, std::string_view key, const FieldTraits& traits,
                                Member* out) {
    if constexpr (std::is_enum_v<Member>) {
        const int index = fields.word(key, namesOf<Member>());
        if (index >= 0) { *out = kindNames<Member>()[static_cast<size_t>(index)].kind; }
    } else if constexpr (std::is_same_v<Member, bool>) {
        if (traits.whenTrue.empty()) {
            fields.boolean(key, out);
        } else if (const int index = fields.word(key, std::array{traits.whenTrue, traits.whenFalse});
                   index >= 0) {
            *out = index == 0;
        }
    } else if constexpr (std::is_integral_v<Member>) {
        fields.integer(key, traits.range, out);
    } else if constexpr (std::is_same_v<Member, float>) {
        fields.number(key, traits.range, out);
    } else if constexpr (std::is_same_v<Member, std::string>) {
        fields.string(key, out);
    } else if constexpr (std::is_same_v<Member, Vec2>) {
        fields.vec2(key, out);
    } else if constexpr (std::is_same_v<Member, Vec3>) {
        switch (traits.form) {
            case VectorForm::Point:
                return fields.vec3(key, out);
            case VectorForm::Direction:
                return fields.direction(key, out);
            case VectorForm::Color:
                return fields.color(key, traits.range, out);
        }
    } else if constexpr (std::is_same_v<Member, std::vector<Vec2>> ||
                         std::is_same_v<Member, std::vector<Vec3>>) {
        readPoints(fields.find(key), key, out);
    } else if constexpr (kIsInput<Member>) {
        readInput(fields, key, traits.range, out);
    } else if constexpr (std::is_same_v<Member, SceneImage>) {
        FileSource file;
        fields.string(key, &file.path);
        out->source = file;
    }
}

template <class Owner>
void SceneJsonReader::readFields(const JsonFields& fields, uint32_t kinds, Owner* owner) {
    forEachField<Owner>([&](const auto& field) {
        if (field.key.empty() || field.traits.custom || (field.traits.kinds & kinds) == 0) { return; }
        const JsonValue value = field.traits.required ? fields.require(field.key) : fields.find(field.key);
        if (field.hooks.setDefault != nullptr) { field.hooks.setDefault(owner); }
        if (!value.present()) { return; }
        readValue(fields, field.key, field.traits, &(owner->*field.member));
        if (field.hooks.holds != nullptr && !errors_.failed() && !field.hooks.holds(*owner)) {
            errors_.add(value, fmt::format(fmt::runtime(field.hooks.message), shownValue(value)));
        }
    });
}

}  // namespace glint
