// Walking the flat tree, and JSON strings to text and back.
#include "engine/io/json_value.h"

#include <charconv>

#include <fmt/format.h>

namespace glint {
namespace {

uint32_t hexCode(std::string_view digits) {
    uint32_t code = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), code, 16);
    return code;
}

void appendUtf8(uint32_t code, std::string* out) {
    if (code < 0x80) {
        *out += static_cast<char>(code);
    } else if (code < 0x800) {
        *out += static_cast<char>(0xC0 | (code >> 6));
        *out += static_cast<char>(0x80 | (code & 0x3F));
    } else if (code < 0x10000) {
        *out += static_cast<char>(0xE0 | (code >> 12));
        *out += static_cast<char>(0x80 | ((code >> 6) & 0x3F));
        *out += static_cast<char>(0x80 | (code & 0x3F));
    } else {
        *out += static_cast<char>(0xF0 | (code >> 18));
        *out += static_cast<char>(0x80 | ((code >> 12) & 0x3F));
        *out += static_cast<char>(0x80 | ((code >> 6) & 0x3F));
        *out += static_cast<char>(0x80 | (code & 0x3F));
    }
}

/// The code point of the \u escape at `text[at]` ('u'), and how many characters it takes; surrogate pairs
/// take two escapes. The parser has checked the digits.
uint32_t unicodeEscape(std::string_view text, size_t at, size_t* length) {
    const uint32_t high = hexCode(text.substr(at + 1, 4));
    *length = 5;
    const bool pair = high >= 0xD800 && high < 0xDC00 && text.substr(at + 5, 2) == "\\u";
    if (pair) {
        const uint32_t low = hexCode(text.substr(at + 7, 4));
        if (low >= 0xDC00 && low < 0xE000) {
            *length = 11;
            return 0x10000 + ((high - 0xD800) << 10) + (low - 0xDC00);
        }
    }
    return high >= 0xD800 && high < 0xE000 ? 0xFFFD : high;
}

}  // namespace

std::string_view JsonValue::raw() const {
    return std::string_view(document_->source.text).substr(node().begin, node().end - node().begin);
}

Error JsonValue::error(std::string message) const {
    const size_t quote = type() == JsonType::String ? 1 : 0;
    return document_->source.error(node().begin - quote, std::move(message));
}

std::string JsonValue::string() const {
    const std::string_view text = raw();
    std::string out;
    out.reserve(text.size());
    for (size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '\\') {
            out += text[i];
            continue;
        }
        const char escape = text[++i];
        constexpr std::string_view kNames = "bfnrt";
        if (const size_t name = kNames.find(escape); name != std::string_view::npos) {
            out += "\b\f\n\r\t"[name];
        } else if (escape == 'u') {
            size_t length = 0;
            appendUtf8(unicodeEscape(text, i, &length), &out);
            i += length - 1;
        } else {
            out += escape;
        }
    }
    return out;
}

JsonValue JsonValue::first() const {
    const bool empty = node().next == index_ + 1;
    return empty ? JsonValue() : JsonValue(document_, index_ + 1);
}

JsonValue JsonValue::next(const JsonValue& child) const {
    const uint32_t index = child.node().next;
    return index == node().next ? JsonValue() : JsonValue(document_, index);
}

uint32_t JsonValue::size() const {
    uint32_t count = 0;
    for (JsonValue child = first(); child.present(); child = next(child)) {
        ++count;
    }
    return type() == JsonType::Object ? count / 2 : count;
}

std::string_view describe(JsonType type) {
    constexpr std::string_view kNames[] = {"null",     "true or false", "a number",
                                           "a string", "an array",      "an object"};
    return kNames[static_cast<int>(type)];
}

std::string quoteJson(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') {
            out += '\\';
            out += c;
        } else if (static_cast<unsigned char>(c) < 0x20) {
            out += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
        } else {
            out += c;
        }
    }
    return out + "\"";
}

}  // namespace glint
