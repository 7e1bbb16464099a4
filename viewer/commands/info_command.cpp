// `glint info SCENE`: what it holds, what it needs, what is left out, memory by part.
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "engine/builders/scene_builder.h"
#include "engine/io/scene_choices.h"
#include "engine/io/scene_loader.h"
#include "engine/render/photon_store.h"
#include "engine/render/sppm_state.h"
#include "viewer/commands/command_line.h"
#include "viewer/commands/commands.h"
#include "viewer/commands/json_output.h"
#include "viewer/commands/memory_table.h"
#include "viewer/commands/print_scene_report.h"
#include "viewer/commands/scene_opening.h"
#include "viewer/commands/scene_report.h"

namespace glint {
namespace {

struct InfoOptions {
    std::string scene;
    LoadOptions load;
    bool memory = false;
    std::string json;
};

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

nlohmann::ordered_json jsonOf(const std::vector<SceneChoices::Animation>& animations) {
    nlohmann::ordered_json out = nlohmann::ordered_json::array();
    for (const SceneChoices::Animation& animation : animations) {
        out.push_back({{"name", animation.name},
                       {"begin_seconds", animation.beginSeconds},
                       {"end_seconds", animation.endSeconds}});
    }
    return out;
}

nlohmann::ordered_json jsonReport(const SceneDescription& scene, const SceneChoices& choices,
                                  const SceneReport& report) {
    return {{"scene", scene.path},
            {"title", scene.title},
            {"width", scene.resolution.width},
            {"height", scene.resolution.height},
            {"objects", jsonOf(report.objects)},
            {"hiddenObjects", jsonOf(report.hiddenObjects)},
            {"meshes", report.meshes},
            {"placed_meshes", report.placedMeshes},
            {"triangles", report.triangles},
            {"placed_triangles", report.placedTriangles},
            {"materials", jsonOf(report.materials)},
            {"textures", report.textures},
            {"used_textures", report.usedTextures},
            {"lights", jsonOf(report.lights)},
            {"animations", jsonOf(choices.animations)},
            {"variants", choices.variants},
            {"features", report.features},
            {"kernel", report.kernel},
            {"sppm_kernel", report.sppmKernel},
            {"left_out", report.leftOut},
            {"not_read", jsonOf(report.notRead)},
            {"integrator", integratorInfo(scene.options.integrator).key},
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
            {"warnings", scene.warnings},
            {"notes", scene.notes}};
}

int runInfo(const InfoOptions& options) {
    auto loaded = loadScene(options.scene, options.load);
    if (!loaded) { return reportError(loaded.error(), kExitBadInput); }
    const auto scene = std::make_shared<SceneDescription>(std::move(*loaded));
    const auto built = buildScene({scene, EditKind::Everything}, nullptr, 0, nullptr, nullptr);
    if (!built) { return reportError(built.error(), kExitBadInput); }
    const SceneReport report = reportOf(*scene, **built);
    const SceneChoices choices = readSceneChoices(options.scene);
    if (!jsonTakesOutput(options.json)) {
        printSceneReport(*scene, choices, report);
        if (options.memory) { printMemory(report.memory); }
    }
    if (options.json.empty()) { return kExitDone; }
    const Status written = writeJson(options.json, "info", jsonReport(*scene, choices, report));
    return written ? kExitDone : reportError(written.error(), kExitFailed);
}

}  // namespace

void addInfoCommand(const Command& program) {
    const Command command = program.subcommand("info", "What a scene holds, needs and leaves out");
    const auto options = std::make_shared<InfoOptions>();
    command.option("scene", &options->scene, "The scene").required().typeName("SCENE");
    addLoadOptions(command, &options->load);
    command.flag("--memory", &options->memory,
                 "Memory by part: used, and not allocated because nothing needs it");
    addJsonOption(command, &options->json);
    command.onRun([options] { return runInfo(*options); });
}

}  // namespace glint
