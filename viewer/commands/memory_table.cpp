#include "viewer/commands/memory_table.h"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "engine/base/console.h"
#include "engine/render/checkpoint.h"

namespace glint {
namespace {

/// Why a part is left out or unused.
const char* reasonOf(MemoryPart part) {
    switch (part) {
        case MemoryPart::Vertices:
            return "no object places them";
        case MemoryPart::VertexShading:
            return "texture coordinates that no texture needs";
        case MemoryPart::Textures:
            return "no object uses them";
        case MemoryPart::Environment:
            return "the environment does not shine with it";
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

MemoryTable memoryTableOf(const SceneDescription& scene, const BuiltScene& built, const LeftOnDisk& left) {
    const IntegratorKind integrator = scene.options.integrator;
    const MemoryUse planned = plannedMemory(scene, integrator, false);
    MemoryUse most;
    for (const IntegratorInfo& info : kIntegratorTable) {
        const MemoryUse of = plannedMemory(scene, info.kind, true);
        std::ranges::transform(most.bytes, of.bytes, most.bytes.begin(), std::ranges::max);
    }
    most[MemoryPart::VertexShading] = leftOutUvBytes(scene);
    most[MemoryPart::Textures] = left.textures;
    most[MemoryPart::Environment] = left.environment;
    const MemoryUse unused = unusedMemory(scene, built.features);
    MemoryUse used = memoryOf(built);
    used.add(planned);
    MemoryTable table;
    for (size_t i = 0; i < kMemoryPartCount; ++i) {
        const auto part = static_cast<MemoryPart>(i);
        const uint64_t without = most[part] - planned[part];
        if (used[part] + unused[part] + without == 0) { continue; }
        const char* why = unused[part] + without > 0 ? reasonOf(part) : "";
        table.rows.push_back({memoryPartName(part), used[part], unused[part], without, why});
    }
    table.used = used.total();
    table.heldUnused = unused.total();
    table.notAllocated = most.total() - planned.total();
    table.checkpointPeak = used[MemoryPart::Film] + used[MemoryPart::SppmStatistics] +
                           checkpointBytes(scene.resolution.width, scene.resolution.height, integrator);
    return table;
}

std::string formatBytes(uint64_t bytes) {
    const double value = static_cast<double>(bytes);
    return bytes < 10'000          ? fmt::format("{} B", bytes)
           : bytes < 1'000'000     ? fmt::format("{:.1f} kB", value * 1e-3)
           : bytes < 1'000'000'000 ? fmt::format("{:.1f} MB", value * 1e-6)
                                   : fmt::format("{:.2f} GB", value * 1e-9);
}

/// What is held unused stands in scene files themselves: most scenes have none of it, and no such column.
void printMemory(const MemoryTable& table) {
    const auto print = [held = table.heldUnused > 0](const std::string& part, const std::string& used,
                                                     const std::string& unused, const std::string& without,
                                                     const std::string& why) {
        const std::string line = fmt::format("  {:<46}{:>12}{}{:>16}  {}", part, used,
                                             held ? fmt::format("{:>14}", unused) : "", without, why);
        put("{}\n", line.substr(0, line.find_last_not_of(' ') + 1));
    };
    put("memory\n");
    print("", "used", "held unused", "not allocated", "");
    for (const MemoryRow& row : table.rows) {
        print(row.part, cell(row.used), cell(row.heldUnused), cell(row.notAllocated), row.why);
    }
    print("in all", cell(table.used), cell(table.heldUnused), cell(table.notAllocated), "");
    print("on top, while a checkpoint is saved", cell(table.checkpointPeak), "", "", "");
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
