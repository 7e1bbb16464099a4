// What the caller of loadScene allows and wants to know. Options of `glint` commands end here.
#pragma once

#include <cstdint>

#include "engine/scene/reading_options.h"

namespace glint {

/// What reading a scene took, beside the scene file itself. Files that several parts share count once.
struct LoadCounts {
    uint32_t meshFiles = 0;
    uint64_t meshFileBytes = 0;
    uint32_t imageFiles = 0;
    uint64_t imageFileBytes = 0;
    uint64_t pixelBytes = 0;  ///< of the images, decoded or generated
    uint32_t generatedMeshes = 0;
    uint32_t generatedImages = 0;

    bool operator==(const LoadCounts&) const = default;
};

struct LoadOptions {
    /// Missing textures and meshes, and what Glint cannot draw, become warnings: the rest of the scene
    /// is loaded.
    bool allowMissing = false;
    bool strict = false;              ///< what is repaired, guessed or left out with a warning is an error
    bool noStudio = false;            ///< models without light get a plain white environment and no ground
    LoadCounts* counts = nullptr;     ///< added to, where it is not null
    SceneParameters parameters = {};  ///< before those that the scene sets itself
};

/// Those that read a scene's file so again.
inline LoadOptions loadOptionsOf(const ReadingOptions& options) {
    return {
        .allowMissing = options.allowMissing, .noStudio = options.noStudio, .parameters = options.parameters};
}

}  // namespace glint
