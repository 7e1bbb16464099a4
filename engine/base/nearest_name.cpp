#include "engine/base/nearest_name.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include <fmt/format.h>

namespace glint {
namespace {

// Names in scene files are short; anything longer is no slip of the finger, and must not cost quadratic time.
constexpr size_t kLongestName = 256;

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

size_t editDistance(std::string_view a, std::string_view b) {
    std::vector<size_t> beforePrevious(b.size() + 1), previous(b.size() + 1), current(b.size() + 1);
    for (size_t j = 0; j <= b.size(); ++j) {
        previous[j] = j;
    }
    for (size_t i = 1; i <= a.size(); ++i) {
        current[0] = i;
        for (size_t j = 1; j <= b.size(); ++j) {
            const bool same = lower(a[i - 1]) == lower(b[j - 1]);
            current[j] = std::min({previous[j] + 1, current[j - 1] + 1, previous[j - 1] + (same ? 0 : 1)});
            const bool exchanged =
                i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1]);
            if (exchanged) { current[j] = std::min(current[j], beforePrevious[j - 2] + 1); }
        }
        std::swap(beforePrevious, previous);
        std::swap(previous, current);
    }
    return previous[b.size()];
}

}  // namespace

std::string nearestName(std::string_view unknown, std::span<const std::string_view> known) {
    if (unknown.empty() || unknown.size() > kLongestName) { return {}; }
    std::string_view best;
    size_t bestDistance = std::numeric_limits<size_t>::max();
    for (std::string_view name : known) {
        const size_t distance = editDistance(unknown, name.substr(0, kLongestName));
        const size_t limit = std::max<size_t>(1, std::max(unknown.size(), name.size()) / 3);
        if (distance <= limit && distance < std::min(bestDistance, name.size())) {
            best = name;
            bestDistance = distance;
        }
    }
    return std::string(best);
}

std::string didYouMean(std::string_view unknown, std::span<const std::string_view> known) {
    const std::string nearest = nearestName(unknown, known);
    return nearest.empty() ? std::string() : fmt::format(" (did you mean '{}'?)", nearest);
}

std::string joinNames(std::span<const std::string_view> names) {
    std::string out;
    for (size_t i = 0; i < names.size(); ++i) {
        out += i == 0 ? "" : (i + 1 == names.size() ? " or " : ", ");
        out += names[i];
    }
    return out;
}

}  // namespace glint
