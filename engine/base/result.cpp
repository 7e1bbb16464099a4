// Formats an Error the way compilers do, with a caret below the offending column.
#include "engine/base/result.h"

#include <algorithm>

namespace glint {
namespace {

constexpr size_t kShownColumns = 100;

std::string printable(std::string text) {
    for (char& c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (c == '\t') {
            c = ' ';
        } else if (code < 0x20 || code == 0x7f) {
            c = '?';
        }
    }
    return text;
}

std::string caretLines(const SourcePlace& place) {
    const size_t caret = static_cast<size_t>(place.column - 1);
    const size_t start = caret > kShownColumns / 2 ? caret - kShownColumns / 2 : 0;
    if (start > place.lineText.size()) { return {}; }
    const std::string shown = printable(place.lineText.substr(start, kShownColumns));
    return "\n  " + shown + "\n  " + std::string(std::min(caret - start, shown.size()), ' ') + "^";
}

}  // namespace

std::string Error::format() const {
    std::string out;
    if (!place.file.empty()) {
        out = printable(place.file);
        if (place.line > 0) {
            out += ":" + std::to_string(place.line);
            if (place.column > 0) { out += ":" + std::to_string(place.column); }
        }
        out += ": ";
    }
    out += printable(message);
    if (place.column > 0 && !place.lineText.empty()) { out += caretLines(place); }
    return out;
}

}  // namespace glint
