// Lists are wrapped, so that a terminal's width does not cut them where it likes.
#include "viewer/commands/print_scene_report.h"

#include <algorithm>

#include <fmt/format.h>

#include "engine/base/console.h"
#include "engine/render/photon_store.h"
#include "engine/render/sppm_state.h"

namespace glint {
namespace {

constexpr size_t kWidth = 110;
constexpr size_t kIndent = 11;
constexpr std::string_view kKernelPrefix = "kernel: ";

/// "1 sphere", "5 spheres"; kinds of materials and lights are adjectives and stay.
std::string counted(const NamedCount& item) {
    static constexpr std::pair<std::string_view, std::string_view> kPlurals[] = {
        {"sphere", "spheres"},
        {"plane", "planes"},
        {"rectangle", "rectangles"},
        {"disc", "discs"},
        {"mesh", "meshes"},
        {"emissive object", "emissive objects"},
        {"emitter in the light table", "emitters in the light table"}};
    const auto* plural =
        std::ranges::find(kPlurals, item.name, &std::pair<std::string_view, std::string_view>::first);
    const bool many = item.count != 1 && plural != std::end(kPlurals);
    return fmt::format("{} {}", item.count, many ? plural->second : std::string_view(item.name));
}

/// `label` and the items, separated by commas, over as many lines as they need.
void printList(std::string_view label, std::string_view lead, const std::vector<std::string>& items) {
    std::string line = fmt::format("{:<{}}{}", label, kIndent, lead);
    if (items.empty()) { line += "none"; }
    for (size_t i = 0; i < items.size(); ++i) {
        const std::string text = items[i] + (i + 1 < items.size() ? "," : "");
        if (line.size() + text.size() > kWidth) {
            put("{}\n", line.substr(0, line.find_last_not_of(' ') + 1));
            line.assign(kIndent, ' ');
        }
        line += text + " ";
    }
    put("{}\n", line.substr(0, line.find_last_not_of(' ') + 1));
}

std::vector<std::string> counted(const std::vector<NamedCount>& counts) {
    std::vector<std::string> items;
    items.reserve(std::size(counts));
    for (const NamedCount& item : counts) {
        items.push_back(counted(item));
    }
    return items;
}

void printChoices(const SceneChoices& choices) {
    std::vector<std::string> animations;
    for (const SceneChoices::Animation& animation : choices.animations) {
        animations.push_back(fmt::format("{} ({:.4g} to {:.4g} s)", animation.name, animation.beginSeconds,
                                         animation.endSeconds));
    }
    if (!animations.empty()) { printList("animations", "", animations); }
    if (!choices.variants.empty()) { printList("variants", "", choices.variants); }
}

/// The last count is that of the light table, where a mesh that shines is as many emitters as triangles.
void printLights(const std::vector<NamedCount>& lights) {
    std::vector<std::string> items = counted(lights);
    const std::string table = items.back();
    items.pop_back();
    if (items.empty()) {
        put("lights     none: the picture is black\n");
        return;
    }
    items.back() += fmt::format(" ({})", table);
    printList("lights", "", items);
}

void printLeftOut(const std::vector<std::string>& leftOut) {
    std::vector<std::string> kernel, data;
    for (const std::string& item : leftOut) {
        const bool isKernel = item.starts_with(kKernelPrefix);
        (isKernel ? kernel : data).push_back(isKernel ? item.substr(kKernelPrefix.size()) : item);
    }
    printList("left out", "of the kernel: ", kernel);
    for (const std::string& item : data) {
        put("{:<{}}{}\n", "", kIndent, item);
    }
}

void printMeshes(const SceneReport& report) {
    if (report.meshes == 0) {
        put("meshes     none\n");
        return;
    }
    const char* triangles = report.triangles == 1 ? "triangle" : "triangles";
    const std::string placed = report.placedMeshes < report.meshes
                                   ? fmt::format(", {} of them placed,", report.placedMeshes)
                                   : std::string();
    put("meshes     {}{} with {} {}, {} as placed\n", report.meshes, placed, report.triangles, triangles,
        report.placedTriangles);
}

/// A library of a thousand textures needs a few lines to make the point.
void printNotRead(const std::vector<NotRead>& items) {
    constexpr size_t kMostLines = 8;
    for (size_t i = 0; i < std::min(items.size(), kMostLines); ++i) {
        const NotRead& item = items[i];
        const std::string name = item.name == item.file ? "" : fmt::format(" '{}'", item.name);
        const std::string size = item.fileBytes ? fmt::format(" ({})", formatBytes(*item.fileBytes)) : "";
        put("{:<{}}{}{}{}{}: {}\n", i == 0 ? "not read" : "", kIndent, item.kind, name,
            item.file.empty() ? "" : " " + item.file, size, item.why);
    }
    if (items.size() > kMostLines) {
        put("{:<{}}and {} more (--json lists them)\n", "", kIndent, items.size() - kMostLines);
    }
}

void printPhotons(const SceneDescription& scene, const SceneReport& report) {
    const SppmMemory& plan = report.sppm;
    const uint32_t asked = scene.sppm.photonsPerPass;
    put("photon map {} photons a pass, {} bytes a pixel, {} bytes a stored photon: {} in all{}\n",
        plan.photonsPerPass, kSppmBytesPerPixel, PhotonStore::kBytesPerPhoton, formatBytes(plan.total()),
        scene.options.integrator == IntegratorKind::Sppm ? "" : " (with --integrator sppm)");
    if (plan.photonsPerPass < asked) {
        const uint32_t budget = scene.sppm.memoryBudgetMiB;
        put("           fewer than the {} asked for, which do not fit into {}\n", asked,
            budget > 0 ? fmt::format("{} MiB", budget) : "a photon map at all");
    }
    if (!report.hasCausticCaster) {
        put("           gains nothing here: no mirror, glass, metal or coating gathers light into "
            "caustics\n");
    }
    if (report.hasGlowingPlane) {
        put("           infinite planes and surfaces of revolution that shine send no photons: what they "
            "light only "
            "by way of other surfaces stays dark; a large rectangle or a mesh does it\n");
    }
}

}  // namespace

void printSceneReport(const SceneDescription& scene, const SceneChoices& choices, const SceneReport& report) {
    put("{}\n", scene.title.empty() ? scene.path : scene.title);
    put("picture    {}x{} pixels, depth {}\n", scene.resolution.width, scene.resolution.height,
        scene.options.maxDepth);
    printList("objects", "", counted(report.objects));
    if (!report.hiddenObjects.empty()) { printList("hidden", "", counted(report.hiddenObjects)); }
    printMeshes(report);
    printList("materials", "", counted(report.materials));
    if (report.usedTextures < report.textures) {
        put("textures   {}, {} of them used\n", report.textures, report.usedTextures);
    } else {
        put("textures   {}\n", report.textures == 0 ? "none" : fmt::to_string(report.textures));
    }
    printLights(report.lights);
    printChoices(choices);
    printList("needs", "", report.features);
    put("kernel     {}; photon mapping: {}\n", report.kernel, report.sppmKernel);
    printLeftOut(report.leftOut);
    printNotRead(report.notRead);
    printPhotons(scene, report);
    put("memory     {} for a render, {} not allocated (--memory: by part)\n", formatBytes(report.memory.used),
        formatBytes(report.memory.notAllocated));
    for (const std::string& warning : scene.warnings) {
        put("warning    {}\n", warning);
    }
    for (const std::string& note : scene.notes) {
        put("note       {}\n", note);
    }
}

}  // namespace glint
