// Indented JSON text.
#include "engine/io/json_writer.h"

#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "engine/io/json_value.h"

namespace glint {

void JsonWriter::separate() {
    if (afterKey_) {
        afterKey_ = false;
        return;
    }
    if (depth_ > 0) {
        text_ += isFirst_ ? "\n" : ",\n";
        text_.append(2 * static_cast<size_t>(depth_), ' ');
    }
    isFirst_ = false;
}

void JsonWriter::open(char bracket) {
    separate();
    text_ += bracket;
    ++depth_;
    isFirst_ = true;
}

void JsonWriter::close(char bracket) {
    --depth_;
    if (!isFirst_) {
        text_ += '\n';
        text_.append(2 * static_cast<size_t>(depth_), ' ');
    }
    text_ += bracket;
    isFirst_ = false;
}

void JsonWriter::key(std::string_view name) {
    separate();
    text_ += quoteJson(name);
    text_ += ": ";
    afterKey_ = true;
}

void JsonWriter::append(float x) {
    allFinite_ &= std::isfinite(x);
    fmt::format_to(std::back_inserter(text_), "{}", x);
}

void JsonWriter::numbers(const float* values, int count) {
    separate();
    text_ += '[';
    for (int i = 0; i < count; ++i) {
        text_ += i == 0 ? "" : ", ";
        append(values[i]);
    }
    text_ += ']';
}

void JsonWriter::indices(const uint32_t* values, int count) {
    separate();
    fmt::format_to(std::back_inserter(text_), "[{}]", fmt::join(values, values + count, ", "));
}

void JsonWriter::value(float x) {
    separate();
    append(x);
}

void JsonWriter::value(const Vec2& v) { numbers(&v.x, 2); }

void JsonWriter::value(const Vec3& v) { numbers(&v.x, 3); }

void JsonWriter::value(const Vec4& v) { numbers(&v.x, 4); }

void JsonWriter::value(int64_t x) {
    separate();
    fmt::format_to(std::back_inserter(text_), "{}", x);
}

void JsonWriter::value(bool x) {
    separate();
    text_ += x ? "true" : "false";
}

void JsonWriter::value(std::string_view text) {
    separate();
    text_ += quoteJson(text);
}

}  // namespace glint
