// Materials by name, to begin with: metals and glasses by their measured constants, plastics, paints
// and layers.
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

/// What goes with the mouse from a list of materials to an object: one of the scene's, or a preset, which
/// lives as long as the program.
struct MaterialDrag {
    static constexpr const char* kKind = "material";
    int material = -1;
    const MaterialPreset* preset = nullptr;
};

/// What the library's panel remembers.
struct MaterialLibrary {
    int group = 0;
    std::optional<Material> copied;
};

}  // namespace glint
