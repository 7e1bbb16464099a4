#include "engine/io/remarks.h"

#include <algorithm>

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

void Remarks::add(const Remarks& more) {
    for (const Entry& other : more.entries_) {
        const auto same =
            std::ranges::find(entries_, other.kind.data(), [](const Entry& e) { return e.kind.data(); });
        if (same != entries_.end()) {
            same->count += other.count;
        } else {
            entries_.push_back(other);
        }
    }
}

void boundLines(std::vector<std::string>* lines) {
    constexpr size_t kMostLines = 40;
    if (lines->size() <= kMostLines) { return; }
    const size_t more = lines->size() - (kMostLines - 1);
    lines->resize(kMostLines - 1);
    lines->push_back(fmt::format("and {} more like these", more));
}

}  // namespace glint
