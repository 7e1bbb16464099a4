// The memory of a render by part, for `glint info`: what is in use, what stands in the scene file and is
// never read by a kernel, and what is not allocated because the scene and the settings do without it. All
// from engine/render/memory_use.h, but for what was left on the disk.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "engine/render/memory_use.h"

namespace glint {

struct MemoryRow {
    std::string part;
    uint64_t used = 0;
    uint64_t heldUnused = 0;
    uint64_t notAllocated = 0;
    std::string why;  ///< of the two; empty where both are 0
};

struct MemoryTable {
    std::vector<MemoryRow> rows;
    uint64_t used = 0;
    uint64_t heldUnused = 0;
    uint64_t notAllocated = 0;
    /// On top of what is used, while a checkpoint is saved: a copy of films and statistics, and the file.
    uint64_t checkpointPeak = 0;
};

/// What images that were not read would take.
struct LeftOnDisk {
    uint64_t textures = 0;
    uint64_t environment = 0;
};

/// With the scene's own resolution and integrator, without a window.
MemoryTable memoryTableOf(const SceneDescription& scene, const BuiltScene& built, const LeftOnDisk& left);

/// "512 B", "20.7 MB".
std::string formatBytes(uint64_t bytes);
void printMemory(const MemoryTable& table);
nlohmann::ordered_json memoryJson(const MemoryTable& table);

}  // namespace glint
