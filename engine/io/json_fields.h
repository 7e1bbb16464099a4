// Reads the members of one JSON object into variables, checking types and ranges and naming what is wrong.
//
// Only the first error is kept, so callers read on and ask once at the end.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/base/number_range.h"
#include "engine/io/json_value.h"
#include "engine/math/vec.h"

namespace glint {

/// The first error of a document, and what was noticed on the way.
class JsonErrors {
  public:
    bool failed() const { return error_.has_value(); }
    const Error& error() const { return *error_; }
    /// Keeps the first error only; returns false, so that `return errors.add(...)` reads well.
    bool add(Error error) {
        if (!error_) { error_ = std::move(error); }
        return false;
    }
    bool add(const JsonValue& at, std::string message) {
        return failed() || add(at.error(std::move(message)));
    }

  private:
    std::optional<Error> error_;
};

/// Readers of single values. `what` names the field in messages. They leave *out alone and return false on
/// an error.
bool readNumber(JsonErrors& errors, const JsonValue& value, std::string_view what, const NumberRange& range,
                float* out);
bool readNumbers(JsonErrors& errors, const JsonValue& value, std::string_view what, const NumberRange& range,
                 int count, float* out);
bool readVec3(JsonErrors& errors, const JsonValue& value, std::string_view what, const NumberRange& range,
              Vec3* out);
/// A grey level, [r, g, b] (both linear), or "#rrggbb" (sRGB).
bool readColor(JsonErrors& errors, const JsonValue& value, std::string_view what, const NumberRange& range,
               Vec3* out);
bool readInteger(JsonErrors& errors, const JsonValue& value, std::string_view what, const NumberRange& range,
                 int64_t* out);
bool readString(JsonErrors& errors, const JsonValue& value, std::string_view what, std::string* out);
bool expectType(JsonErrors& errors, const JsonValue& value, std::string_view what, JsonType type);

/// A value as a message shows it: short ones as written, others by their type.
std::string shownValue(const JsonValue& value);

/// One object whose members are among `keys`; all others are an error that names the nearest. Every getter
/// leaves its variable alone when the key is absent.
class JsonFields {
  public:
    JsonFields(JsonErrors& errors, const JsonValue& object, std::string_view what,
               std::vector<std::string_view> keys);

    const JsonValue& object() const { return object_; }
    JsonValue find(std::string_view key) const;
    /// The member, or an error that it is missing.
    JsonValue require(std::string_view key) const;

    void number(std::string_view key, const NumberRange& range, float* out) const;
    void vec2(std::string_view key, Vec2* out) const;
    void vec3(std::string_view key, Vec3* out) const;
    /// As vec3, but not (0, 0, 0).
    void direction(std::string_view key, Vec3* out) const;
    void color(std::string_view key, const NumberRange& range, Vec3* out) const;
    void boolean(std::string_view key, bool* out) const;
    void string(std::string_view key, std::string* out) const;

    template <class Integer>
    void integer(std::string_view key, const NumberRange& range, Integer* out) const {
        int64_t number = 0;
        if (const JsonValue value = find(key);
            value.present() && readInteger(errors_, value, key, range, &number)) {
            *out = static_cast<Integer>(number);
        }
    }
    /// The index of a text among a few words; -1 where the key is absent, or with an error.
    int word(std::string_view key, std::span<const std::string_view> words) const;

  private:
    JsonErrors& errors_;
    JsonValue object_;
    std::string_view what_;
    std::vector<std::string_view> keys_;
};

}  // namespace glint
