#include "engine/base/number_range.h"

#include <cstdint>

#include <fmt/format.h>

namespace glint {

std::string NumberRange::wholeNumbers() const {
    return fmt::format("a whole number from {} to {}", static_cast<int64_t>(lo), static_cast<int64_t>(hi));
}

}  // namespace glint
