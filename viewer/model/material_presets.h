// Materials by name, to begin with: metals and glasses by their measured constants, plastics, paints and
// layers.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/scene/material.h"

namespace glint {

struct MaterialPreset {
    std::string name;
    Material material;
};

struct MaterialPresetGroup {
    std::string name;
    std::vector<MaterialPreset> presets;
};

/// All of them, made once.
std::span<const MaterialPresetGroup> materialPresets();

/// Takes everything of `from` but its name, as one preset or another material has it.
void takeMaterial(const Material& from, Material* to);

/// What the library's panel remembers.
struct MaterialLibrary {
    int group = 0;
    std::optional<Material> copied;
};

}  // namespace glint
