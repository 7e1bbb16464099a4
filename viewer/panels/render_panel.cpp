// How the render goes: start and stop, speed, error and limits.
#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <imgui.h>

#include "engine/render/integrator.h"
#include "viewer/base/units.h"
#include "viewer/model/fault_finder.h"
#include "viewer/model/key_map.h"
#include "viewer/model/region_tool.h"
#include "viewer/model/render_control.h"
#include "viewer/model/scene_document.h"
#include "viewer/panels/panel.h"
#include "viewer/ui/theme.h"
#include "viewer/ui/widgets.h"

namespace glint {
namespace {

const char* stateText(const RenderControl& render) {
    if (render.isHeld && !render.request.paused) { return "Waits for the turntable"; }
    switch (render.status().state) {
        case SessionState::Empty:
            return "No scene";
        case SessionState::Building:
            return "Building";
        case SessionState::Rendering:
            return render.request.paused ? "Pausing" : "Rendering";
        case SessionState::Paused:
            return "Paused";
        case SessionState::Finished:
            return "Finished";
        case SessionState::Failed:
            return "Failed";
    }
    return "";
}

/// The share of the nearest stop limit that is done; negative without limits.
float progress(const SessionStatus& status, const StopLimits& limits) {
    double done = -1.0;
    if (limits.passes > 0) { done = std::max(done, static_cast<double>(status.passes) / limits.passes); }
    if (limits.renderSeconds > 0.0) { done = std::max(done, status.renderSeconds / limits.renderSeconds); }
    if (limits.relativeError > 0.0 && status.relativeError > 0.0 && std::isfinite(status.relativeError)) {
        // The error falls with the square root of the passes.
        done = std::max(done, std::pow(limits.relativeError / status.relativeError, 2.0));
    }
    return static_cast<float>(std::min(done, 1.0));
}

void drawActions(RenderControl* render, const KeyMap& keys) {
    const float width = ui::buttonWidth(2);
    const bool finished = render->status().state == SessionState::Finished;
    if (finished) {
        ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 0.5f);
        ui::button("Finished", width, "A stop limit is reached. Raise or clear it to go on.");
        ImGui::PopStyleVar();
    } else if (ui::button(render->request.paused ? "Start" : "Pause", width,
                          keys.tip("Keeps the picture", KeyAction::Pause).c_str(), true) &&
               !render->isHeld) {
        render->request.paused = !render->request.paused;
    }
    ImGui::SameLine();
    const std::string tip = keys.tip("Throws the picture away and begins again", KeyAction::Restart);
    if (ui::button("Restart", width, tip.c_str())) { render->restart(); }
}

void drawIntegrator(RenderOptions* options) {
    std::vector<std::string_view> names;
    std::string tooltip;
    for (const IntegratorInfo& info : kIntegratorTable) {
        names.emplace_back(info.displayName);
        tooltip += fmt::format("{}: {}.\n", info.displayName, integratorType(info.kind).purpose());
    }
    tooltip += "Each keeps its picture";
    int integrator = static_cast<int>(options->integrator);
    if (ui::choice("Integrator", &integrator, names, tooltip.c_str())) {
        options->integrator = kIntegratorTable[static_cast<size_t>(integrator)].kind;
    }
}

void drawAccelerator(RenderOptions* options) {
    static constexpr ui::KindLabel<AcceleratorKind> kKinds[]{{AcceleratorKind::Bvh, "Box hierarchy"},
                                                             {AcceleratorKind::KdTree, "kd-tree"},
                                                             {AcceleratorKind::Aabb, "One box each"},
                                                             {AcceleratorKind::None, "None"}};
    ui::kindChoice(
        "Accelerator", &options->accelerator, kKinds,
        "What rays find objects and triangles by: the picture stays, the speed changes. Shown: Boxes "
        "tested, Triangles tested");
}

void drawNumbers(const RenderControl& render) {
    const SessionStatus& status = render.status();
    ui::value("State", stateText(render));
    ui::value("Passes", grouped(status.passes), "Samples of each pixel so far");
    const bool isTimed = status.passesPerSecond > 0.0;
    ui::value("Speed", isTimed ? fmt::format("{:.2f} passes/s", status.passesPerSecond) : "–",
              "Of the integrator that is chosen, over its last passes");
    ui::value("Paths", isTimed ? withPrefix(status.pathsPerSecond, "paths/s") : "–",
              "Camera paths, one a pixel and pass");
    ui::value("Rays", isTimed ? withPrefix(status.raysPerSecond, "rays/s") : "–",
              "Camera, bounce and shadow rays");
    ui::value("Elapsed", duration(status.renderSeconds), "Time spent in passes since the last restart");
    ui::value(
        "Est. error",
        status.passes > 1 ? percent(status.relativeError) + (status.region ? " (region)" : "") : "–",
        "How wrong the pixels are, each relative to its own brightness and wholly at most, as a root mean "
        "square without the worst thousandth; of the picture or of the region");
    ui::value("Last edit", latency(status.lastEditToImageSeconds), "From the edit to its first new picture");
    ui::value("Device", status.backend, "What runs the passes");
    if (!status.error.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, theme::kTextError);
        ImGui::TextWrapped("%s", status.error.c_str());
        ImGui::PopStyleColor();
    }
}

void drawRegion(const RenderControl& render, RegionTool* region, const KeyMap& keys) {
    const char* label = region->picks ? "Drag on the picture…" : region->drawn ? "Whole picture" : "Region…";
    const std::string tip = keys.tip("Only what is drawn is rendered on, the rest stays", KeyAction::Region);
    if (ui::button(label, ui::buttonWidth(1), tip.c_str(), region->picks)) { region->askOrGiveUp(); }
    const SessionStatus& status = render.status();
    if (region->drawn && !status.region && integratorType(status.integrator).makeStatistics()) {
        ui::hint(fmt::format("{} renders the whole picture: photons land everywhere.",
                             integratorInfo(status.integrator).displayName)
                     .c_str());
    }
}

void drawLimits(RenderControl* render) {
    StopLimits& limits = render->request.limits;
    ui::heading("Stop at");
    int passes = static_cast<int>(limits.passes);
    auto seconds = static_cast<float>(limits.renderSeconds);
    auto error = static_cast<float>(limits.relativeError * 100.0);
    if (ui::integer("Pass limit", &passes,
                    {.format = "%d passes",
                     .speed = 1.0f,
                     .max = 1e7f,
                     .zeroText = "none",
                     .tooltip = "Never restarts anything. 0: no limit"})) {
        limits.passes = static_cast<uint32_t>(passes);
    }
    if (ui::number("Time limit", &seconds,
                   {.format = "%.0f s",
                    .speed = 1.0f,
                    .max = 1e7f,
                    .zeroText = "none",
                    .tooltip = "Render time, pauses left out. 0: no limit"})) {
        limits.renderSeconds = static_cast<double>(seconds);
    }
    if (ui::number("Error limit", &error,
                   {.format = "%.2f %%",
                    .speed = 0.01f,
                    .max = 100.0f,
                    .zeroText = "none",
                    .tooltip = "Of the estimate; the Convergence panel's target. 0: no limit"})) {
        limits.relativeError = static_cast<double>(error) / 100.0;
    }
    if (const float done = progress(render->status(), limits); done >= 0.0f) {
        ImGui::ProgressBar(done, {-FLT_MIN, ImGui::GetFontSize() * 0.45f}, "");
    }
}

void drawFaults(const SessionStatus& status, FaultFinder* faults) {
    const auto& counts = status.faultCounts;
    const uint64_t total = counts[1] + counts[2] + counts[3];
    ui::value("Dropped", total == 0 ? "none" : fmt::format("{} samples", grouped(total)),
              "Samples that were not finite or negative: counted, left out, and never clamped");
    if (total == 0) { return; }
    ui::hint(
        fmt::format("{} not a number, {} infinite, {} negative", counts[1], counts[2], counts[3]).c_str());
    if (ui::button("Find the first", ui::buttonWidth(1))) { faults->find(); }
    if (faults->replayCommand().empty()) { return; }
    std::string command = faults->replayCommand();
    ImGui::SetNextItemWidth(-FLT_MIN);
    ImGui::InputText("##replay", command.data(), command.size() + 1, ImGuiInputTextFlags_ReadOnly);
    if (ui::button("Copy command", ui::buttonWidth(1))) { ImGui::SetClipboardText(command.c_str()); }
}

void draw(RenderControl* render, SceneDocument* document, RegionTool* region, FaultFinder* faults,
          const KeyMap* keys) {
    drawActions(render, *keys);
    drawRegion(*render, region, *keys);
    drawIntegrator(&document->draft().options);
    drawAccelerator(&document->draft().options);
    drawNumbers(*render);
    drawFaults(render->status(), faults);
    drawLimits(render);
}

}  // namespace

Panel renderPanel() { return {"Render", true, OfParts<draw>::call}; }

}  // namespace glint
