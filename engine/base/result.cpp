// Formats an Error the way compilers do, with a caret below the offending column.
#include "engine/base/result.h"

#include <algorithm>

#include "engine/base/console.h"

namespace glint {
namespace {

constexpr size_t kShownColumns = 100;

std::string oneLine(const std::string& text) { return printable(text, '?'); }

std::string caretLines(const SourcePlace& place) {
    const size_t caret = static_cast<size_t>(place.column - 1);
    const size_t start = caret > kShownColumns / 2 ? caret - kShownColumns / 2 : 0;
    if (start > place.lineText.size()) { return {}; }
    const std::string shown = oneLine(place.lineText.substr(start, kShownColumns));
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
