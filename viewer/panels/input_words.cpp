#include "viewer/panels/input_words.h"

#include <cctype>

namespace glint {

std::string inputLabel(std::string_view key) {
    if (key == "ior") { return "IOR"; }
    std::string label;
    for (const char c : key) {
        const auto letter = static_cast<unsigned char>(c);
        if (std::isupper(letter) != 0) { label += ' '; }
        label += static_cast<char>(label.empty() ? std::toupper(letter) : std::tolower(letter));
    }
    return label;
}

std::string inputTooltip(std::string_view help) {
    std::string tooltip(help);
    if (!tooltip.empty()) {
        tooltip.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(tooltip.front())));
    }
    return tooltip;
}

}  // namespace glint
