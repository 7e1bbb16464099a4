// Measured dispersion of transparent materials by name.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "engine/math/dispersion.h"

namespace glint {

struct GlassConstants {
    float ior = 1.5f;  ///< at helium's d line
    Dispersion dispersion;
};

/// The constants of "BK7", "SF11", "diamond", "water", …; nothing for an unknown name.
std::optional<GlassConstants> findGlass(std::string_view name);

/// All known names in alphabetical order.
std::vector<std::string_view> glassNames();

}  // namespace glint
