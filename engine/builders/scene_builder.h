// Description in, BuiltScene out: the only place where the two meet.
#pragma once

#include <atomic>
#include <memory>

#include "engine/base/result.h"
#include "engine/builders/built_scene.h"
#include "engine/scene/scene_edit.h"

namespace glint {

/// Which parts a build made anew; the rest is shared with the previous scene.
struct BuildReport {
    int meshesBuilt = 0;
    bool topLevelBuilt = false;
    bool materialsBuilt = false;
    bool texturesBuilt = false;
    bool lightsBuilt = false;
    bool featuresScanned = false;
    double seconds = 0.0;
};

/// Builds what `edit` names and shares the rest with `previous` (null: builds everything). Meshes whose
/// MeshData is the same object are always shared. Error: a description that no picture can be made of (an
/// index out of range, a singular transform, a non-finite number), naming the object; or `stop` (may be null)
/// was raised meanwhile. threads 0: all.
Result<std::shared_ptr<const BuiltScene>> buildScene(const SceneEdit& edit, const BuiltScene* previous,
                                                     int threads, const std::atomic<bool>* stop,
                                                     BuildReport* report);

/// Triangles of the meshes that objects place and over which `previous` (null: none) has no structure of
/// any kind.
size_t trianglesToBuild(const SceneDescription& scene, const BuiltScene* previous);

}  // namespace glint
