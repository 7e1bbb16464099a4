// Scenes far from the origin, moved to it before anything is built: where a scene lies 1e6 times its size
// away, float has sixteen steps for all of it, and every ray would be rounded to them.
//
// What is subtracted has so few digits that the differences are exact: the rounding that remains is that of
// the numbers in the file. Scenes that are not far away stay as they are, to the bit. Where the origin lies
// follows from the objects and their meshes alone, never from earlier edits, the camera or the lights.
#pragma once

#include <memory>
#include <vector>

#include "engine/scene/scene.h"

namespace glint {

/// Far: the origin is farther from the scene's box than this many times its longest edge.
constexpr double kFarSizes = 100.0;

/// A mesh whose vertices lie far from its own origin, and the same with `center` subtracted.
struct CenteredMesh {
    std::shared_ptr<const MeshData> original;
    Vec3 center{0.0f};
    std::shared_ptr<const MeshData> centered;  ///< `original` itself where the centre is 0
};

struct Recentring {
    Vec3 origin{0.0f};                 ///< world coordinates of what kernels call (0, 0, 0)
    std::vector<CenteredMesh> meshes;  ///< same indices as SceneDescription::meshes
};

/// What has to be moved so that nothing is computed far from the origin; null: nothing (nearly always).
/// Meshes that `previous` (may be null) has centred alike at the same index are shared with it. The
/// description must be valid.
std::shared_ptr<const Recentring> findRecentring(const SceneDescription& scene, const Recentring* previous);

/// Whether both put every mesh at the same place; either may be null.
bool samePlaces(const Recentring* a, const Recentring* b);

/// The description with everything moved: the same picture. Shares what did not move.
SceneDescription recentred(const SceneDescription& scene, const Recentring& recentring);

}  // namespace glint
