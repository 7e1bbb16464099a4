// Formats an Error the way compilers do, with a caret below the offending column.
#include "engine/base/result.h"

#include <algorithm>
#include <utility>

#include "engine/base/console.h"

namespace glint {
namespace {

constexpr size_t kShownColumns = 100;

constexpr bool isControl(char c) { return (static_cast<unsigned char>(c) < ' ' && c != '\t') || c == 0x7f; }

/// Of unprintable characters in a row one is left.
std::string oneLine(std::string text) {
    const auto repeats =
        std::unique(text.begin(), text.end(), [](char a, char b) { return isControl(a) && isControl(b); });
    text.erase(repeats, text.end());
    return printable(std::move(text), '?');
}

std::string caretLines(const SourcePlace& place) {
    const size_t caret = static_cast<size_t>(place.column - 1);
    const size_t start = caret > kShownColumns / 2 ? caret - kShownColumns / 2 : 0;
    if (start > place.lineText.size()) { return {}; }
    const std::string bytes = place.lineText.substr(start, kShownColumns);
    if (static_cast<size_t>(std::ranges::count_if(bytes, isControl)) > bytes.size() / 4) {
        return {};
    }  // no text
    const std::string shown = printable(bytes, '?');
    return "\n  " + shown + "\n  " + std::string(std::min(caret - start, shown.size()), ' ') + "^";
}

}  // namespace

std::string Error::format() const {
    std::string out;
    if (!place.file.empty()) {
        out = oneLine(place.file);
        if (place.line > 0) {
            out += ":" + std::to_string(place.line);
            if (place.column > 0) { out += ":" + std::to_string(place.column); }
        }
        out += ": ";
    }
    out += oneLine(message);
    if (place.column > 0 && !place.lineText.empty()) { out += caretLines(place); }
    return out;
}

}  // namespace glint
