#include "viewer/model/copy_name.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>

#include <fmt/format.h>

namespace glint {
namespace {

constexpr std::string_view kCopy = " copy";

struct NumberedCopy {
    std::string_view original;
    uint32_t number = 1;
};

/// Of "ball copy" and "ball copy 7".
std::optional<NumberedCopy> numberedCopy(std::string_view name) {
    const size_t at = name.rfind(kCopy);
    if (at == std::string_view::npos || at == 0) { return std::nullopt; }
    NumberedCopy copy{name.substr(0, at)};
    const std::string_view rest = name.substr(at + kCopy.size());
    if (rest.empty()) { return copy; }
    const auto [end, problem] = std::from_chars(rest.data() + 1, rest.data() + rest.size(), copy.number);
    const bool isNumber = rest.front() == ' ' && problem == std::errc() && end == rest.data() + rest.size();
    return isNumber && copy.number < UINT32_MAX ? std::optional(copy) : std::nullopt;
}

}  // namespace

std::string copyName(std::string_view name, const std::vector<std::string_view>& taken) {
    const auto itself = numberedCopy(name);
    const std::string_view original = itself ? itself->original : name;
    uint32_t last = itself ? itself->number : 0;
    for (const std::string_view other : taken) {
        const auto copy = numberedCopy(other);
        if (copy && copy->original == original) { last = std::max(last, copy->number); }
    }
    return last == 0 ? fmt::format("{}{}", original, kCopy)
                     : fmt::format("{}{} {}", original, kCopy, last + 1);
}

}  // namespace glint
