// What -D chooses of a glTF file. Internal to the glTF importer.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/io/gltf_file.h"
#include "engine/io/scene_choices.h"

namespace glint {

/// Which of the things of these names the parameter of that kind names, or counts from 0 on; nothing where it
/// is not given. Error: the file has no such thing.
Result<std::optional<size_t>> chosenBy(const SceneParameters& parameters, std::string_view kind,
                                       const std::vector<std::string>& names, const GltfFile& file);

/// KHR_materials_variants: gives primitives the materials of the parameter "variant". `note` says which there
/// are and which was chosen, and is empty where the file has none. Error: there is no such variant.
Status chooseVariant(GltfFile* file, const SceneParameters& parameters, std::string* note);

}  // namespace glint
