// Reads the members of one JSON object into variables, checking types and ranges and naming what is wrong.
//
// Used by the scene reader. Only the first error is kept, so callers read on and ask once at the end.
#pragma once

#include <initializer_list>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

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

/// The numbers a field takes, and how a message puts it.
struct NumberRange {
    float lo = -std::numeric_limits<float>::max();
    float hi = std::numeric_limits<float>::max();
    bool openLo = false;  ///< lo itself is outside
    bool openHi = false;
    std::string_view expected = "a finite number";

    bool contains(float x) const { return (openLo ? x > lo : x >= lo) && (openHi ? x < hi : x <= hi); }
};

constexpr NumberRange kAnyNumber{};
constexpr NumberRange kPositive{.lo = 0.0f, .openLo = true, .expected = "a number > 0"};
constexpr NumberRange kNotNegative{.lo = 0.0f, .expected = "a number >= 0"};
constexpr NumberRange kUnitInterval{.lo = 0.0f, .hi = 1.0f, .expected = "a number from 0 to 1"};

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
bool readInteger(JsonErrors& errors, const JsonValue& value, std::string_view what, int64_t lo, int64_t hi,
                 int64_t* out);
bool readString(JsonErrors& errors, const JsonValue& value, std::string_view what, std::string* out);
bool expectType(JsonErrors& errors, const JsonValue& value, std::string_view what, JsonType type);

/// One object whose members are among `keys`; all others are an error that names the nearest. Every getter
/// leaves its variable alone when the key is absent.
class JsonFields {
  public:
    JsonFields(JsonErrors& errors, const JsonValue& object, std::string_view what,
               std::span<const std::string_view> keys);

    const JsonValue& object() const { return object_; }
    JsonValue find(std::string_view key) const;
    /// True when the object has one of these keys, which need not be known ones.
    bool hasAny(std::initializer_list<std::string_view> keys) const;
    /// The member, or an error that it is missing.
    JsonValue require(std::string_view key) const;

    void number(std::string_view key, const NumberRange& range, float* out) const;
    void vec3(std::string_view key, Vec3* out) const;
    /// As vec3, but not (0, 0, 0).
    void direction(std::string_view key, Vec3* out) const;
    void color(std::string_view key, const NumberRange& range, Vec3* out) const;
    void boolean(std::string_view key, bool* out) const;
    void string(std::string_view key, std::string* out) const;

    template <class Integer>
    void integer(std::string_view key, int64_t lo, int64_t hi, Integer* out) const {
        int64_t number = 0;
        if (const JsonValue value = find(key);
            value.present() && readInteger(errors_, value, key, lo, hi, &number)) {
            *out = static_cast<Integer>(number);
        }
    }

    /// One of a few words.
    template <class Enum, size_t kCount>
    void choice(std::string_view key, const std::pair<std::string_view, Enum> (&words)[kCount],
                Enum* out) const {
        std::string_view names[kCount];
        for (size_t i = 0; i < kCount; ++i) {
            names[i] = words[i].first;
        }
        if (const int index = word(key, names); index >= 0) { *out = words[index].second; }
    }

  private:
    int word(std::string_view key, std::span<const std::string_view> names) const;

    JsonErrors& errors_;
    JsonValue object_;
    std::string_view what_;
    std::span<const std::string_view> keys_;
};

}  // namespace glint
