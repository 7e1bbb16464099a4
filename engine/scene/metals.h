// Measured optical constants of metals by name, reduced to linear Rec.709.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "engine/scene/material.h"

namespace glint {

struct MetalConstants {
    Vec3 eta;  ///< index of refraction at R, G, B
    Vec3 k;    ///< extinction coefficient at R, G, B
};

/// The constants of "gold", "silver", "copper", "aluminium", …; nothing for an unknown name.
std::optional<MetalConstants> findMetal(std::string_view name);

/// All known names in alphabetical order, both spellings of aluminium among them.
std::vector<std::string_view> metalNames();
/// Each metal once.
std::vector<std::string_view> listedMetals();

/// How much of light from the front a metal's boundary reflects, by its name or its constants' values,
/// without its colour (Fresnel's equations at normal incidence).
Vec3 reflectanceHeadOn(const Material& metal);

}  // namespace glint
