// Typed access to JSON members with messages that say what was expected.
#include "engine/io/json_fields.h"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

#include "engine/base/check.h"
#include "engine/base/nearest_name.h"
#include "engine/math/color.h"

namespace glint {
namespace {

bool wrong(JsonErrors& errors, const JsonValue& value, std::string_view what, std::string_view expected) {
    return errors.add(value, fmt::format("\"{}\" is {}; expected {}", what, shownValue(value), expected));
}

bool readHexColor(JsonErrors& errors, const JsonValue& value, std::string_view what, Vec3* out) {
    const std::string_view text = value.raw();
    uint32_t code = 0;
    const char* end = text.data() + text.size();
    const bool isHex =
        text.size() == 7 && text[0] == '#' && std::from_chars(text.data() + 1, end, code, 16).ptr == end;
    if (!isHex) { return wrong(errors, value, what, "a grey level, [r, g, b] or \"#rrggbb\""); }
    const auto channel = [code](int shift) {
        return srgbToLinear(static_cast<float>((code >> shift) & 0xFF) / 255.0f);
    };
    *out = {channel(16), channel(8), channel(0)};
    return true;
}

}  // namespace

std::string shownValue(const JsonValue& value) {
    const bool isShort =
        value.raw().size() <= 24 && value.type() != JsonType::Object && value.type() != JsonType::Array;
    if (!isShort) { return std::string(describe(value.type())); }
    return value.is(JsonType::String) ? fmt::format("\"{}\"", value.raw()) : std::string(value.raw());
}

bool expectType(JsonErrors& errors, const JsonValue& value, std::string_view what, JsonType type) {
    return value.is(type) || wrong(errors, value, what, describe(type));
}

bool readNumber(JsonErrors& errors, const JsonValue& value, std::string_view what, const NumberRange& range,
                float* out) {
    if (!value.is(JsonType::Number)) { return wrong(errors, value, what, range.expected); }
    float number = 0.0f;
    if (parseFloat(value.raw(), &number) != NumberParse::Ok) {
        return wrong(errors, value, what, "a number that a 32-bit float can hold, up to 3.4e38");
    }
    if (!range.contains(static_cast<double>(number))) { return wrong(errors, value, what, range.expected); }
    *out = number;
    return true;
}

bool readNumbers(JsonErrors& errors, const JsonValue& value, std::string_view what, const NumberRange& range,
                 int count, float* out) {
    const std::string expected = fmt::format("an array of {} numbers", count);
    if (!value.is(JsonType::Array)) { return wrong(errors, value, what, expected); }
    int read = 0;
    for (JsonValue item = value.first(); item.present(); item = value.next(item)) {
        if (read == count) {
            return errors.add(
                item, fmt::format("\"{}\" has more than {} numbers; expected {}", what, count, expected));
        }
        if (!readNumber(errors, item, what, range, &out[read++])) { return false; }
    }
    return read == count || errors.add(value, fmt::format("\"{}\" has {} of {} numbers; expected {}", what,
                                                          read, count, expected));
}

bool readVec3(JsonErrors& errors, const JsonValue& value, std::string_view what, const NumberRange& range,
              Vec3* out) {
    float xyz[3];
    if (!readNumbers(errors, value, what, range, 3, xyz)) { return false; }
    *out = {xyz[0], xyz[1], xyz[2]};
    return true;
}

bool readColor(JsonErrors& errors, const JsonValue& value, std::string_view what, const NumberRange& range,
               Vec3* out) {
    if (value.is(JsonType::String)) { return readHexColor(errors, value, what, out); }
    if (value.is(JsonType::Array)) { return readVec3(errors, value, what, range, out); }
    float grey = 0.0f;
    if (!value.is(JsonType::Number)) {
        return wrong(errors, value, what, "a colour: a grey level, [r, g, b] or \"#rrggbb\"");
    }
    if (!readNumber(errors, value, what, range, &grey)) { return false; }
    *out = Vec3(grey);
    return true;
}

bool readInteger(JsonErrors& errors, const JsonValue& value, std::string_view what, const NumberRange& range,
                 int64_t* out) {
    int64_t number = 0;
    bool isInteger = value.is(JsonType::Number);
    if (isInteger) {
        const std::string_view text = value.raw();
        const char* end = text.data() + text.size();
        const auto [stop, code] = std::from_chars(text.data(), end, number);
        isInteger = stop == end && code == std::errc();
    }
    if (!isInteger || !range.contains(static_cast<double>(number))) {
        return wrong(errors, value, what, range.wholeNumbers());
    }
    *out = number;
    return true;
}

bool readString(JsonErrors& errors, const JsonValue& value, std::string_view what, std::string* out) {
    if (!expectType(errors, value, what, JsonType::String)) { return false; }
    *out = value.string();
    return out->find('\0') == std::string::npos ||
           errors.add(value, fmt::format("\"{}\" holds a zero byte", what));
}

JsonFields::JsonFields(JsonErrors& errors, const JsonValue& object, std::string_view what,
                       std::vector<std::string_view> keys)
    : errors_(errors), what_(what), keys_(std::move(keys)) {
    if (errors.failed() || !expectType(errors, object, what, JsonType::Object)) { return; }
    object_ = object;
    for (JsonValue key = object.first(); key.present() && !errors.failed();
         key = object.next(object.next(key))) {
        const std::string name = key.string();
        if (std::ranges::find(keys_, name) == keys_.end()) {
            const std::string hint = didYouMean(name, keys_);
            errors.add(key, fmt::format("unknown key \"{}\" of {}{}; expected {}", name.substr(0, 60), what,
                                        hint, joinNames(keys_)));
        }
    }
}

JsonValue JsonFields::find(std::string_view key) const {
    GLINT_CHECK(std::find(keys_.begin(), keys_.end(), key) != keys_.end());
    if (!object_.present()) { return {}; }
    for (JsonValue name = object_.first(); name.present();) {
        const JsonValue value = object_.next(name);
        if (name.raw() == key || (name.raw().find('\\') != std::string_view::npos && name.string() == key)) {
            return value;
        }
        name = object_.next(value);
    }
    return {};
}

JsonValue JsonFields::require(std::string_view key) const {
    const JsonValue value = find(key);
    if (!value.present() && object_.present()) {
        errors_.add(object_, fmt::format("{} has no \"{}\", which it needs", what_, key));
    }
    return value;
}

void JsonFields::number(std::string_view key, const NumberRange& range, float* out) const {
    if (const JsonValue value = find(key); value.present()) { readNumber(errors_, value, key, range, out); }
}

void JsonFields::vec2(std::string_view key, Vec2* out) const {
    if (const JsonValue value = find(key); value.present()) {
        readNumbers(errors_, value, key, kAnyNumber, 2, &out->x);
    }
}

void JsonFields::vec3(std::string_view key, Vec3* out) const {
    if (const JsonValue value = find(key); value.present()) {
        readVec3(errors_, value, key, kAnyNumber, out);
    }
}

void JsonFields::direction(std::string_view key, Vec3* out) const {
    const JsonValue value = find(key);
    if (value.present() && readVec3(errors_, value, key, kAnyNumber, out) && isZero(*out)) {
        errors_.add(value, fmt::format("\"{}\" is [0, 0, 0], which has no direction", key));
    }
}

void JsonFields::color(std::string_view key, const NumberRange& range, Vec3* out) const {
    if (const JsonValue value = find(key); value.present()) { readColor(errors_, value, key, range, out); }
}

void JsonFields::boolean(std::string_view key, bool* out) const {
    const JsonValue value = find(key);
    if (value.present() && expectType(errors_, value, key, JsonType::Bool)) { *out = value.raw() == "true"; }
}

void JsonFields::string(std::string_view key, std::string* out) const {
    if (const JsonValue value = find(key); value.present()) { readString(errors_, value, key, out); }
}

int JsonFields::word(std::string_view key, std::span<const std::string_view> words) const {
    const JsonValue value = find(key);
    std::string text;
    if (!value.present() || !readString(errors_, value, key, &text)) { return -1; }
    const auto found = std::find(words.begin(), words.end(), text);
    if (found == words.end()) {
        errors_.add(value, fmt::format("unknown \"{}\" \"{}\"{}; expected {}", key, text.substr(0, 60),
                                       didYouMean(text, words), joinNames(words)));
        return -1;
    }
    return static_cast<int>(found - words.begin());
}

}  // namespace glint
