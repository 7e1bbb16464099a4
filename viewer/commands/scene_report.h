// What a scene holds, needs and leaves out: the figures of `glint info`, computed, not guessed.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/build/built_scene.h"
#include "engine/render/sppm_state.h"
#include "engine/scene/scene.h"
#include "viewer/commands/memory_table.h"

namespace glint {

struct NamedCount {
    std::string name;
    uint64_t count = 0;
};

struct SceneReport {
    std::vector<NamedCount> objects;    ///< by shape, those that occur
    std::vector<NamedCount> materials;  ///< by kind, those that occur
    std::vector<NamedCount> lights;     ///< emissive objects, emitters, point, spot, directional, environment
    uint64_t meshes = 0;
    uint64_t triangles = 0;        ///< stored
    uint64_t placedTriangles = 0;  ///< drawn: every instance counts
    uint64_t textures = 0;
    std::vector<std::string> features;
    std::vector<std::string>
        leftOut;         ///< features that the kernel was compiled without, and data not allocated
    std::string kernel;  ///< the path tracer's
    std::string sppmKernel;
    MemoryTable memory;
    SppmMemory sppm;                ///< what photon mapping needs here, whether or not it is the integrator
    bool hasCausticCaster = false;  ///< otherwise photon mapping gains nothing
    bool hasGlowingPlane = false;   ///< infinite planes send no photons
};

SceneReport reportOf(const SceneDescription& scene, const BuiltScene& built);

/// The features of a mask by name.
std::vector<std::string> featureNames(FeatureMask mask);

}  // namespace glint
