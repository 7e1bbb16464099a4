// Values of fields as text: for fingerprints of settings and for the command line.
#pragma once

#include <string>
#include <string_view>

#include <fmt/format.h>

#include "engine/base/nearest_name.h"
#include "engine/scene/field.h"
#include "engine/scene/kind_names.h"

namespace glint {

/// Reads a whole text as a number in `range`. False, and *out untouched, for anything else.
bool parseNumber(std::string_view text, const NumberRange& range, float* out);
bool parseWhole(std::string_view text, const NumberRange& range, int64_t* out);
/// "x,y,z": `count` numbers, at most three.
bool parseVector(std::string_view text, const NumberRange& range, int count, float* out);

/// Of ASCII letters.
std::string inLowerCase(std::string_view text);

/// "half the filter's width (pixels)", in lower case or not.
std::string describeField(const FieldTraits& traits, bool capitalised);

/// The value: numbers in the shortest form that reads back exactly, kinds and some bools by their words.
template <class Owner, class Member>
std::string fieldText(const Field<Owner, Member>& field, const Owner& owner) {
    const Member& value = owner.*field.member;
    if constexpr (std::is_enum_v<Member>) {
        return std::string(nameOf(value));
    } else if constexpr (std::is_same_v<Member, bool>) {
        return std::string(value ? field.traits.whenTrue : field.traits.whenFalse);
    } else if constexpr (std::is_same_v<Member, Vec3>) {
        return fmt::format("{},{},{}", value.x, value.y, value.z);
    } else if constexpr (std::is_same_v<Member, Vec2>) {
        return fmt::format("{},{}", value.x, value.y);
    } else {
        return fmt::to_string(value);
    }
}

/// Sets the field from text; the case of a kind's word counts nothing. False, and the field untouched, where
/// the text is not what expectedText() says.
template <class Owner, class Member>
bool setFromText(const Field<Owner, Member>& field, std::string_view text, Owner* owner) {
    Member& value = owner->*field.member;
    const FieldTraits& traits = field.traits;
    if constexpr (std::is_enum_v<Member>) {
        const std::optional<Member> kind = kindNamed<Member>(inLowerCase(text));
        value = kind.value_or(value);
        return kind.has_value();
    } else if constexpr (std::is_same_v<Member, bool>) {
        value = text == traits.whenTrue || (value && text != traits.whenFalse);
        return text == traits.whenTrue || text == traits.whenFalse;
    } else if constexpr (std::is_integral_v<Member>) {
        int64_t number = 0;
        if (!parseWhole(text, traits.range, &number)) { return false; }
        value = static_cast<Member>(number);
        return true;
    } else if constexpr (std::is_same_v<Member, Vec3>) {
        return parseVector(text, traits.range, 3, &value.x);
    } else if constexpr (std::is_same_v<Member, Vec2>) {
        return parseVector(text, traits.range, 2, &value.x);
    } else {
        return parseNumber(text, traits.range, &value);
    }
}

/// What setFromText() takes: "sobol or independent", "a number > 0".
template <class Owner, class Member>
std::string expectedText(const Field<Owner, Member>& field) {
    if constexpr (std::is_enum_v<Member>) {
        return joinNames(namesOf<Member>());
    } else if constexpr (std::is_same_v<Member, bool>) {
        return fmt::format("{} or {}", field.traits.whenTrue, field.traits.whenFalse);
    } else if constexpr (std::is_integral_v<Member>) {
        return field.traits.range.wholeNumbers();
    } else if constexpr (std::is_same_v<Member, Vec3>) {
        return "three numbers such as 0,1,5";
    } else if constexpr (std::is_same_v<Member, Vec2>) {
        return "two numbers such as 0,0.5";
    } else {
        return std::string(field.traits.range.expected);
    }
}

}  // namespace glint
