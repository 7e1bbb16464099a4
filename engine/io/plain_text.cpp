#include "engine/io/plain_text.h"

#include <algorithm>
#include <cstdint>

namespace glint {
namespace {

enum class Utf16 { No, LittleEndian, BigEndian };

Utf16 utf16Of(std::string_view bytes) {
    if (bytes.size() < 4) { return Utf16::No; }
    if (bytes.starts_with("\xff\xfe")) { return Utf16::LittleEndian; }
    if (bytes.starts_with("\xfe\xff")) { return Utf16::BigEndian; }
    if (bytes.size() % 2 != 0) { return Utf16::No; }
    const bool evenZero = bytes[0] == 0 && bytes[2] == 0;
    const bool oddZero = bytes[1] == 0 && bytes[3] == 0;
    if (evenZero == oddZero) { return Utf16::No; }
    return oddZero ? Utf16::LittleEndian : Utf16::BigEndian;
}

void appendUtf8(uint32_t code, std::string* out) {
    const auto tail = [&](int shift) { *out += static_cast<char>(0x80 | ((code >> shift) & 0x3f)); };
    if (code < 0x80) {
        *out += static_cast<char>(code);
    } else if (code < 0x800) {
        *out += static_cast<char>(0xc0 | (code >> 6));
        tail(0);
    } else if (code < 0x10000) {
        *out += static_cast<char>(0xe0 | (code >> 12));
        tail(6);
        tail(0);
    } else {
        *out += static_cast<char>(0xf0 | (code >> 18));
        tail(12);
        tail(6);
        tail(0);
    }
}

std::string fromUtf16(std::string_view bytes, bool bigEndian) {
    const auto unit = [&](size_t at) {
        const uint32_t first = static_cast<unsigned char>(bytes[at]);
        const uint32_t second = static_cast<unsigned char>(bytes[at + 1]);
        return bigEndian ? 256 * first + second : 256 * second + first;
    };
    std::string out;
    out.reserve(bytes.size());
    for (size_t at = 0; at + 1 < bytes.size(); at += 2) {
        uint32_t code = unit(at);
        const bool isPair = code >= 0xd800 && code < 0xdc00 && at + 3 < bytes.size() &&
                            unit(at + 2) >= 0xdc00 && unit(at + 2) < 0xe000;
        if (isPair) {
            code = 0x10000 + ((code - 0xd800) << 10) + (unit(at + 2) - 0xdc00);
            at += 2;
        }
        if (code != 0xfeff) { appendUtf8(code, &out); }
    }
    return out;
}

size_t findLoneReturn(const std::string& text, size_t from) {
    size_t at = text.find('\r', from);
    while (at != std::string::npos && text[at + 1] == '\n') {
        at = text.find('\r', at + 1);
    }
    return at;
}

bool endLinesWithFeeds(std::string* text) {
    size_t at = findLoneReturn(*text, 0);
    const bool any = at != std::string::npos;
    for (; at != std::string::npos; at = findLoneReturn(*text, at + 1)) {
        (*text)[at] = '\n';
    }
    return any;
}

}  // namespace

bool isUtf16(std::string_view bytes) { return utf16Of(bytes) != Utf16::No; }

std::optional<PlainText> asPlainText(const std::string& bytes) {
    if (const Utf16 kind = utf16Of(bytes); kind != Utf16::No) {
        PlainText plain{fromUtf16(bytes, kind == Utf16::BigEndian), "the file is UTF-16 and read as such"};
        endLinesWithFeeds(&plain.text);
        return plain;
    }
    // Which line ends a file has shows in its first lines; a large one is not gone through for them.
    constexpr size_t kFirstLines = size_t{1} << 16;
    if (findLoneReturn(bytes.substr(0, kFirstLines), 0) >= std::min(bytes.size(), kFirstLines) - 1) {
        return std::nullopt;
    }
    PlainText plain{bytes, "lines that end in a carriage return alone"};
    endLinesWithFeeds(&plain.text);
    return plain;
}

}  // namespace glint
