// Writes indented JSON text. For the scene writer.
//
// Floats are written with the fewest digits that give the same float back.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "engine/math/vec.h"

namespace glint {

/// Calls must nest properly. Keys and elements put their commas and line breaks themselves.
class JsonWriter {
  public:
    void beginObject() { open('{'); }
    void endObject() { close('}'); }
    void beginArray() { open('['); }
    void endArray() { close(']'); }
    void key(std::string_view name);

    void value(float x);
    void value(const Vec2& v);
    void value(const Vec3& v);
    void value(const Vec4& v);
    void value(int64_t x);
    void value(bool x);
    void value(std::string_view text);
    /// Numbers on one line.
    void numbers(const float* values, int count);
    void indices(const uint32_t* values, int count);

    template <class T>
    void field(std::string_view name, const T& x) {
        key(name);
        value(x);
    }
    void field(std::string_view name, int x) { field(name, static_cast<int64_t>(x)); }
    void field(std::string_view name, const char* text) { field(name, std::string_view(text)); }
    void field(std::string_view name, const std::string& text) { field(name, std::string_view(text)); }

    /// False once a number was written that is not finite, which JSON cannot hold.
    bool allFinite() const { return allFinite_; }
    const std::string& text() const { return text_; }

  private:
    void open(char bracket);
    void close(char bracket);
    void separate();
    void append(float x);

    std::string text_;
    int depth_ = 0;
    bool isFirst_ = true;
    bool afterKey_ = false;
    bool allFinite_ = true;
};

}  // namespace glint
