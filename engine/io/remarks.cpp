#include "engine/io/remarks.h"

#include <fmt/format.h>

namespace glint {

std::vector<std::string> Remarks::lines() const {
    std::vector<std::string> out;
    for (const Entry& entry : entries_) {
        out.push_back(fmt::format("{}: {}{}{}{}", entry.place, entry.kind,
                                  entry.detail.empty() ? "" : fmt::format(": \"{}\"", entry.detail),
                                  entry.more,
                                  entry.count > 1 ? fmt::format(" (and {} more)", entry.count - 1) : ""));
    }
    return out;
}

void boundLines(std::vector<std::string>* lines) {
    constexpr size_t kMostLines = 40;
    if (lines->size() <= kMostLines) { return; }
    const size_t more = lines->size() - (kMostLines - 1);
    lines->resize(kMostLines - 1);
    lines->push_back(fmt::format("and {} more like these", more));
}

}  // namespace glint
