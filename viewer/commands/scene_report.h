// What a scene holds, needs and leaves out: the figures of `glint info`, computed, not guessed.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/builders/built_scene.h"
#include "engine/render/sppm_state.h"
#include "engine/scene/scene.h"
#include "viewer/commands/memory_table.h"

namespace glint {

struct NamedCount {
    std::string name;
    uint64_t count = 0;
};

/// What the scene names and does not use: it stays on the disk, or ungenerated.
struct NotRead {
    std::string kind;  ///< mesh, texture, environment image
    std::string name;
    std::string file;                       ///< as written; empty: generated
    std::optional<uint64_t> fileBytes{};    ///< nothing: no file, or missing
    std::optional<uint64_t> memoryBytes{};  ///< what its pixels would take, where that is known
    std::string why;
};

struct SceneReport {
    std::vector<NamedCount> objects;  ///< by shape, those that occur
    std::vector<NamedCount> hiddenObjects;
    std::vector<NamedCount> materials;  ///< by kind, those that occur
    std::vector<NamedCount> lights;     ///< emissive objects, emitters, point, spot, directional, environment
    uint64_t meshes = 0;
    uint64_t placedMeshes = 0;     ///< of them, those that an object has
    uint64_t triangles = 0;        ///< stored
    uint64_t placedTriangles = 0;  ///< drawn: every instance counts
    uint64_t textures = 0;
    uint64_t usedTextures = 0;
    std::vector<std::string> features;
    /// features that the kernel was compiled without, and data not allocated
    std::vector<std::string> leftOut;
    std::string kernel;  ///< the path tracer's
    std::string sppmKernel;
    std::vector<NotRead> notRead;
    MemoryTable memory;
    SppmMemory sppm;                ///< what photon mapping needs here, whether or not it is the integrator
    bool hasCausticCaster = false;  ///< otherwise photon mapping gains nothing
    bool hasGlowingPlane = false;   ///< of what shines: infinite planes, surfaces of revolution
};

SceneReport reportOf(const SceneDescription& scene, const BuiltScene& built);

/// The features of a mask by name.
std::vector<std::string> featureNames(FeatureMask mask);

}  // namespace glint
