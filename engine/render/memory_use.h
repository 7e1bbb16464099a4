// Where a render's memory goes, by part: what is allocated, counted by the parts themselves, and what a
// render will take, by the functions that the parts are sized with.
//
// Filled by the session for its status and by `glint info --memory`. Nothing is estimated here but what is
// said to be.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "engine/builders/built_scene.h"
#include "engine/scene/scene.h"

namespace glint {

enum class MemoryPart : uint8_t {
    Vertices,        ///< positions and indices
    VertexShading,   ///< normals, texture coordinates, vertex colours
    MeshStructures,  ///< acceleration structures of meshes
    Instances,       ///< objects and the structure above them
    Materials,
    Textures,
    Lights,       ///< emitters and how they are chosen
    Environment,  ///< the image around the scene and its distribution
    Film,
    PassSamples,  ///< one pass before it is added to the film
    Preview,      ///< low-resolution films after edits
    Aovs,
    SppmStatistics,  ///< radius, photons and flux of every pixel
    SppmVisiblePoints,
    Photons,   ///< with the structure that finds them
    Emission,  ///< how photons choose their lights
};
constexpr size_t kMemoryPartCount = 16;

struct MemoryUse {
    std::array<uint64_t, kMemoryPartCount> bytes{};

    uint64_t& operator[](MemoryPart part) { return bytes[static_cast<size_t>(part)]; }
    uint64_t operator[](MemoryPart part) const { return bytes[static_cast<size_t>(part)]; }
    uint64_t total() const;
    void add(const MemoryUse& other);
};

/// "mesh acceleration structures" and the like, for tables.
const char* memoryPartName(MemoryPart part);

/// What the built scene holds and its kernels may read. Meshes and images that are shared count once.
MemoryUse memoryOf(const BuiltScene& scene);

/// What rendering takes beside the scene at its resolution, by one integrator, without previews. Photons are
/// a guess before any is traced (planSppmMemory).
MemoryUse plannedMemory(const SceneDescription& scene, IntegratorKind integrator, bool aovs);

/// What the description holds and a render of these features never reads: what stands in the
/// scene file itself and could not be read again, and what edits used before. Loaders leave out
/// the rest (io/used_assets.h).
MemoryUse unusedMemory(const SceneDescription& scene, FeatureMask features);

/// Texture coordinates that loaders left out.
uint64_t leftOutUvBytes(const SceneDescription& scene);

}  // namespace glint
