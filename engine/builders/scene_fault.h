// What a scene's checks say and ask. For scene_validation and light_validation.
#pragma once

#include <cmath>
#include <string>

#include <fmt/format.h>

#include "engine/base/result.h"
#include "engine/math/vec.h"

namespace glint {

/// "light 'key'", or "light 3" where it has no name.
inline std::string label(const char* what, const std::string& name, size_t index) {
    return name.empty() ? fmt::format("{} {}", what, index + 1) : fmt::format("{} '{}'", what, name);
}

inline Error fault(const std::string& who, const std::string& what) {
    return {fmt::format("{}: {}", who, what), {}};
}

/// Finite, too.
inline bool inRange(float value, float lo, float hi) {
    return std::isfinite(value) && value >= lo && value <= hi;
}

/// Finite, too.
inline bool notNegative(const Vec3& v) { return isFinite(v) && minComponent(v) >= 0.0f; }

}  // namespace glint
