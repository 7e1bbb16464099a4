// What may be written on a drawing: valid UTF-8, as long as there is room.
#include "engine/report/drawing.h"

namespace glint {
namespace {

constexpr std::string_view kReplacement = "\xef\xbf\xbd";
constexpr std::string_view kEllipsis = "\xe2\x80\xa6";

bool isContinuation(char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; }

/// Bytes of the valid, printable character at the front; 0 when there is none (Unicode 15, table 3-7).
size_t characterLength(std::string_view text) {
    const auto first = static_cast<unsigned char>(text[0]);
    if (first < 0x80) { return first >= 0x20 && first != 0x7f ? 1 : 0; }
    const size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
    if (first < 0xc2 || first > 0xf4 || text.size() < length) { return 0; }
    for (size_t i = 1; i < length; ++i) {
        if (!isContinuation(text[i])) { return 0; }
    }
    const auto second = static_cast<unsigned char>(text[1]);
    const bool tooLong = (first == 0xe0 && second < 0xa0) || (first == 0xf0 && second < 0x90);
    const bool noCharacter = (first == 0xed && second > 0x9f) || (first == 0xf4 && second > 0x8f) ||
                             (first == 0xc2 && second < 0xa0);  // surrogates, beyond U+10FFFF, C1 controls
    return tooLong || noCharacter ? 0 : length;
}

}  // namespace

std::string cleanText(std::string_view text) {
    std::string out;
    while (!text.empty()) {
        const size_t length = characterLength(text);
        out += length > 0 ? text.substr(0, length) : kReplacement;
        text.remove_prefix(length > 0 ? length : 1);
    }
    return out;
}

std::string shortened(const std::string& text, double size, double width, bool bold) {
    if (textWidth(text, size, bold) <= width) { return text; }
    std::string start = text;
    while (!start.empty()) {
        while (!start.empty() && isContinuation(start.back())) {
            start.pop_back();
        }
        if (!start.empty()) { start.pop_back(); }
        std::string cut = start + std::string(kEllipsis);
        if (textWidth(cut, size, bold) <= width) { return cut; }
    }
    return std::string(kEllipsis);
}

}  // namespace glint
