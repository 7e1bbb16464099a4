// Fingerprints of everything in a scene that changes its picture, part by part, and its settings as text.
//
// Checkpoints and EXR files carry them. Names, titles, paths, and meshes and images that nothing uses do not
// enter: only what the renderer sees.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "engine/base/content_hash.h"
#include "engine/scene/scene.h"

namespace glint {

enum class ScenePart : uint8_t { Camera, Geometry, Materials, Textures, Lights };
constexpr int kScenePartCount = 5;

/// "the camera", "the geometry", …: for messages.
const char* scenePartName(ScenePart part);

struct SceneHashes {
    std::array<Hash128, kScenePartCount> parts{};  ///< by ScenePart

    bool operator==(const SceneHashes&) const = default;
};

/// Geometry: meshes, shapes, transforms and which material an object has. Lights: lights, environment and
/// its image.
SceneHashes hashSceneParts(const SceneDescription& scene);

/// One setting as text; numbers in the shortest form that reads back exactly.
struct Setting {
    std::string name;  ///< "maxDepth", as in the scene file
    std::string value;

    bool operator==(const Setting&) const = default;
};

/// Resolution and render options in a fixed order, and those that the integrator alone has.
std::vector<Setting> renderSettings(const SceneDescription& scene);

/// All parts and settings together.
Hash128 sceneHash(const SceneDescription& scene);

}  // namespace glint
