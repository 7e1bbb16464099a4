// `glint info SCENE`: what it holds, what it needs, what is left out, memory by part.
#include <algorithm>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "engine/build/scene_builder.h"
#include "engine/io/scene_loader.h"
#include "engine/render/photon_store.h"
#include "engine/render/sppm_state.h"
#include "viewer/commands/commands.h"
#include "viewer/commands/json_output.h"
#include "viewer/commands/memory_table.h"
#include "viewer/commands/scene_report.h"

namespace glint {
namespace {

struct InfoOptions {
    std::string scene;
    bool allowMissing = false;
    bool memory = false;
    std::string json;
};

std::string listed(const std::vector<NamedCount>& counts) {
    std::vector<std::string> parts;
    for (const NamedCount& item : counts) {
        parts.push_back(fmt::format("{} {}", item.count, item.name));
    }
    return parts.empty() ? "none" : fmt::format("{}", fmt::join(parts, ", "));
}

std::string listed(const std::vector<std::string>& names) {
    return names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "));
}

void printPhotons(const SceneDescription& scene, const SceneReport& report) {
    const SppmMemory& plan = report.sppm;
    const uint32_t asked = scene.sppm.photonsPerPass;
    fmt::print("photon map {} photons a pass, {} bytes a pixel, {} bytes a stored photon: {} in all{}\n",
               plan.photonsPerPass, kSppmBytesPerPixel, PhotonStore::kBytesPerPhoton,
               formatBytes(plan.total()),
               scene.options.integrator == IntegratorKind::Sppm ? "" : " (with --integrator sppm)");
    if (plan.photonsPerPass < asked) {
        fmt::print("           fewer than the {} asked for, which do not fit into {} MiB\n", asked,
                   scene.sppm.memoryBudgetMiB);
    }
    if (!report.hasCausticCaster) {
        fmt::print(
            "           gains nothing here: no mirror, glass, metal or coating gathers light into "
            "caustics\n");
    }
    if (report.hasGlowingPlane) {
        fmt::print(
            "           infinite planes that shine send no photons: what they light only by way of other "
            "surfaces stays dark; a large rectangle does it\n");
    }
}

/// A library of a thousand textures needs a few lines to make the point.
void printNotRead(const std::vector<NotRead>& items) {
    constexpr size_t kMostLines = 8;
    for (size_t i = 0; i < std::min(items.size(), kMostLines); ++i) {
        const NotRead& item = items[i];
        const std::string file = item.file.empty() ? "generated"
                                 : item.fileBytes
                                     ? fmt::format("{}, {}", item.file, formatBytes(*item.fileBytes))
                                     : fmt::format("{}, missing", item.file);
        fmt::print("{}{} '{}' ({}): {}\n", i == 0 ? "not read   " : "           ", item.kind, item.name, file,
                   item.why);
    }
    if (items.size() > kMostLines) {
        fmt::print("           and {} more (--json lists them)\n", items.size() - kMostLines);
    }
}

nlohmann::ordered_json jsonOf(const std::vector<NotRead>& items) {
    nlohmann::ordered_json out = nlohmann::ordered_json::array();
    const auto orNull = [](const std::optional<uint64_t>& bytes) {
        return bytes ? nlohmann::ordered_json(*bytes) : nlohmann::ordered_json();
    };
    for (const NotRead& item : items) {
        out.push_back({{"kind", item.kind},
                       {"name", item.name},
                       {"file", item.file},
                       {"file_bytes", orNull(item.fileBytes)},
                       {"memory_bytes", orNull(item.memoryBytes)},
                       {"why", item.why}});
    }
    return out;
}

void printReport(const SceneDescription& scene, const SceneReport& report) {
    fmt::print("{}\n", scene.title.empty() ? scene.path : scene.title);
    fmt::print("picture    {}x{} pixels, depth {}\n", scene.resolution.width, scene.resolution.height,
               scene.options.maxDepth);
    fmt::print("objects    {}\n", listed(report.objects));
    const std::string placed = report.placedMeshes < report.meshes
                                   ? fmt::format(", {} of them placed", report.placedMeshes)
                                   : std::string();
    fmt::print("meshes     {}{} with {} triangles, {} as placed\n", report.meshes, placed, report.triangles,
               report.placedTriangles);
    fmt::print("materials  {}\n", listed(report.materials));
    fmt::print("textures   {}\n", report.textures);
    fmt::print("lights     {}\n", listed(report.lights));
    fmt::print("needs      {}\n", listed(report.features));
    fmt::print("kernel     {}; photon mapping: {}\n", report.kernel, report.sppmKernel);
    fmt::print("left out   {}\n", listed(report.leftOut));
    printNotRead(report.notRead);
    printPhotons(scene, report);
    fmt::print("memory     {} in use, {} not allocated (--memory: by part)\n",
               formatBytes(report.memory.used), formatBytes(report.memory.notAllocated));
    for (const std::string& warning : scene.warnings) {
        fmt::print("warning    {}\n", warning);
    }
}

nlohmann::ordered_json jsonOf(const std::vector<NamedCount>& counts) {
    nlohmann::ordered_json out = nlohmann::ordered_json::object();
    for (const NamedCount& item : counts) {
        out[item.name] = item.count;
    }
    return out;
}

nlohmann::ordered_json usedByPart(const MemoryTable& table) {
    nlohmann::ordered_json out = nlohmann::ordered_json::object();
    for (const MemoryRow& row : table.rows) {
        out[row.part] = row.used;
    }
    return out;
}

nlohmann::ordered_json jsonReport(const SceneDescription& scene, const SceneReport& report) {
    return {{"scene", scene.path},
            {"title", scene.title},
            {"width", scene.resolution.width},
            {"height", scene.resolution.height},
            {"objects", jsonOf(report.objects)},
            {"meshes", report.meshes},
            {"placed_meshes", report.placedMeshes},
            {"triangles", report.triangles},
            {"placed_triangles", report.placedTriangles},
            {"materials", jsonOf(report.materials)},
            {"textures", report.textures},
            {"lights", jsonOf(report.lights)},
            {"features", report.features},
            {"kernel", report.kernel},
            {"sppm_kernel", report.sppmKernel},
            {"left_out", report.leftOut},
            {"not_read", jsonOf(report.notRead)},
            {"integrator", scene.options.integrator == IntegratorKind::Sppm ? "sppm" : "path"},
            {"sppm",
             {{"photons_per_pass", report.sppm.photonsPerPass},
              {"photons_asked", scene.sppm.photonsPerPass},
              {"bytes_per_pixel", kSppmBytesPerPixel},
              {"bytes_per_stored_photon", PhotonStore::kBytesPerPhoton},
              {"total_bytes", report.sppm.total()},
              {"has_caustic_caster", report.hasCausticCaster},
              {"has_glowing_plane", report.hasGlowingPlane}}},
            {"memory_bytes", usedByPart(report.memory)},
            {"memory_total_bytes", report.memory.used},
            {"memory", memoryJson(report.memory)},
            {"warnings", scene.warnings}};
}

int runInfo(const InfoOptions& options) {
    auto loaded = loadScene(options.scene, {.allowMissing = options.allowMissing});
    if (!loaded) {
        return complain(loaded.error(), kExitBadInput);
    }
    const auto scene = std::make_shared<SceneDescription>(std::move(*loaded));
    const auto built = buildScene({scene, EditKind::Everything}, nullptr, 0, nullptr, nullptr);
    if (!built) {
        return complain(built.error(), kExitBadInput);
    }
    const SceneReport report = reportOf(*scene, **built);
    if (!jsonTakesOutput(options.json)) {
        printReport(*scene, report);
        if (options.memory) {
            printMemory(report.memory);
        }
    }
    const Status written = writeJson(options.json, jsonReport(*scene, report));
    return written ? kExitDone : complain(written.error(), kExitFailed);
}

}  // namespace

void addInfoCommand(CLI::App& app, int* exitCode) {
    CLI::App* command = app.add_subcommand("info", "What a scene holds, needs and leaves out");
    const auto options = std::make_shared<InfoOptions>();
    command->add_option("scene", options->scene, "The scene")->required()->type_name("SCENE");
    command->add_flag("--allow-missing", options->allowMissing, "Go on when parts of the scene are missing");
    command->add_flag("--memory", options->memory,
                      "Memory by part: used, and not allocated because nothing needs it");
    addJsonOption(*command, &options->json);
    command->callback([options, exitCode] { *exitCode = runInfo(*options); });
}

}  // namespace glint
