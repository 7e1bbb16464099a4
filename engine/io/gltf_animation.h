// Animations of glTF files: where all stands at one time. Internal to the glTF importer.
#pragma once

#include <string>

#include "engine/io/gltf_file.h"
#include "engine/io/load_options.h"

namespace glint {

/// Moves the nodes and weights that an animation moves to where it has them at a time: by the parameters
/// "animation", its name or its number from 0 on (the first), and "time", in seconds (where it begins).
/// `note` says which one, and is empty where the file has none. Channels that cannot be read are left out
/// with a remark. Error: there is no such animation.
Status poseNodes(GltfFile* file, const SceneParameters& parameters, std::string* note);

}  // namespace glint
