// The keys of objects in a Glint JSON scene: those of a type's fields, and forms that are no type's fields.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "engine/scene/scene_fields.h"

namespace glint {

/// A key with what the schema says of its value: the inside of a JSON object.
struct JsonKey {
    std::string_view key;
    std::string_view schema;
};

/// An object whose keys are not the fields of a type.
struct JsonForm {
    std::string_view name;  ///< of the schema's definition
    std::string_view help;
    std::string_view required;  ///< the inside of a JSON array
    std::vector<JsonKey> keys;
};

/// Of an object that is in SceneDescription::hiddenObjects.
constexpr std::string_view kHiddenKey = "hidden";

std::span<const JsonForm> jsonForms();
/// The keys of one of these forms, which must exist.
std::vector<std::string_view> formKeys(std::string_view name);

/// The keys that objects of some kinds of a type have, see FieldTraits::kinds, and `more`.
template <class Owner>
std::vector<std::string_view> fieldKeys(uint32_t kinds = ~0u, std::vector<std::string_view> more = {}) {
    std::vector<std::string_view> keys;
    forEachField<Owner>([&](const auto& field) {
        if (!field.key.empty() && (field.traits.kinds & kinds) != 0) { keys.push_back(field.key); }
    });
    keys.insert(keys.end(), more.begin(), more.end());
    return keys;
}

}  // namespace glint
