#include "viewer/commands/memory_table.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "engine/render/checkpoint.h"

namespace glint {
namespace {

/// Why a part is left out or unused.
const char* reasonOf(MemoryPart part) {
    switch (part) {
        case MemoryPart::Vertices:
            return "no object places them";
        case MemoryPart::VertexShading:
            return "no object places them, or texture coordinates without a texture";
        case MemoryPart::Textures:
            return "no object uses them";
        case MemoryPart::Environment:
            return "another environment is chosen";
        case MemoryPart::Aovs:
            return "until one is asked for";
        case MemoryPart::SppmStatistics:
        case MemoryPart::SppmVisiblePoints:
        case MemoryPart::Photons:
        case MemoryPart::Emission:
            return "until photon mapping is asked for";
        default:
            return "";
    }
}

std::string cell(uint64_t bytes) { return bytes == 0 ? "-" : formatBytes(bytes); }

}  // namespace

MemoryTable memoryTableOf(const SceneDescription& scene, const BuiltScene& built) {
    const IntegratorKind integrator = scene.options.integrator;
    const bool sppm = integrator == IntegratorKind::Sppm;
    const MemoryUse planned = plannedMemory(scene, integrator, false);
    const MemoryUse most = plannedMemory(scene, IntegratorKind::Sppm, true);
    const MemoryUse unused = unusedMemory(scene, built.features);
    MemoryUse used = memoryOf(built);
    used.add(planned);
    MemoryTable table;
    for (size_t i = 0; i < kMemoryPartCount; ++i) {
        const auto part = static_cast<MemoryPart>(i);
        const uint64_t left = most[part] - planned[part];
        if (used[part] + unused[part] + left == 0) {
            continue;
        }
        const char* why = unused[part] + left > 0 ? reasonOf(part) : "";
        table.rows.push_back({memoryPartName(part), used[part], unused[part], left, why});
    }
    table.used = used.total();
    table.heldUnused = unused.total();
    table.notAllocated = most.total() - planned.total();
    table.checkpointPeak = used[MemoryPart::Film] + used[MemoryPart::SppmStatistics] +
                           checkpointBytes(scene.resolution.width, scene.resolution.height, sppm);
    return table;
}

std::string formatBytes(uint64_t bytes) {
    const double value = static_cast<double>(bytes);
    return bytes < 10'000       ? fmt::format("{} B", bytes)
           : bytes < 10'000'000 ? fmt::format("{:.1f} kB", value * 1e-3)
                                : fmt::format("{:.1f} MB", value * 1e-6);
}

void printMemory(const MemoryTable& table) {
    constexpr const char* kLine = "  {:<46}{:>12}{:>14}{:>16}  {}\n";
    fmt::print("memory\n");
    fmt::print(kLine, "", "used", "held unused", "not allocated", "");
    for (const MemoryRow& row : table.rows) {
        fmt::print(kLine, row.part, cell(row.used), cell(row.heldUnused), cell(row.notAllocated), row.why);
    }
    fmt::print(kLine, "in all", cell(table.used), cell(table.heldUnused), cell(table.notAllocated), "");
    fmt::print(kLine, "on top, while a checkpoint is saved", cell(table.checkpointPeak), "", "", "");
}

nlohmann::ordered_json memoryJson(const MemoryTable& table) {
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const MemoryRow& row : table.rows) {
        rows.push_back({{"part", row.part},
                        {"used_bytes", row.used},
                        {"held_unused_bytes", row.heldUnused},
                        {"not_allocated_bytes", row.notAllocated},
                        {"why", row.why}});
    }
    return {{"parts", rows},
            {"used_bytes", table.used},
            {"held_unused_bytes", table.heldUnused},
            {"not_allocated_bytes", table.notAllocated},
            {"checkpoint_peak_bytes", table.checkpointPeak}};
}

}  // namespace glint
