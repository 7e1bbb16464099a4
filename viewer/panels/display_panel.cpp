// How the picture is shown. Nothing here reaches the renderer, but for the extra pictures it is asked
// to make.
#include <array>
#include <string_view>

#include <imgui.h>

#include "viewer/panels/panels.h"
#include "viewer/window/widgets.h"

namespace glint {
namespace {

constexpr std::array<std::string_view, 4> kToneMaps{"Clamp (linear)", "sRGB", "Filmic", "Reinhard"};
constexpr std::array<std::string_view, kShownImageCount> kImages{"Radiance",
                                                                 "Albedo",
                                                                 "Shading normal",
                                                                 "Geometric normal",
                                                                 "Depth",
                                                                 "Object id",
                                                                 "Material id",
                                                                 "Standard error",
                                                                 "Bias",
                                                                 "Bounded at 90 %",
                                                                 "Error against reference",
                                                                 "SPPM radius",
                                                                 "Photon count",
                                                                 "Visible points"};

/// Why the radiance is shown instead; nullptr when nothing is missing.
const char* missing(const ViewerModel& model) {
    const DisplaySettings& display = model.display;
    const bool hasSppm = display.split || model.draft().options.integrator == IntegratorKind::Sppm;
    if (isOfPhotons(display.shown) && !hasSppm) {
        return "Path tracing has no photons: choose SPPM as the integrator.";
    }
    if (display.shown == ShownImage::Bias && !hasSppm) {
        return "Path tracing has no bias: choose SPPM as the integrator.";
    }
    if (display.shown != ShownImage::ReferenceError) { return nullptr; }
    if (!model.reference.image()) { return "Load a reference in the Convergence panel first."; }
    return model.usableReference() ? nullptr : "The reference does not fit: see the Convergence panel.";
}
constexpr std::array<std::string_view, 2> kSizes{"Fit the window", "1:1 pixels"};

}  // namespace

void drawDisplayPanel(ViewerModel* model) {
    if (!ui::section("Display", true)) { return; }
    ImGui::PushID("display");
    DisplaySettings& display = model->display;
    ui::number("Exposure", &display.exposureStops,
               {.format = "%+.2f stops",
                .min = -10.0f,
                .max = 10.0f,
                .slider = true,
                .tooltip = "Doubles the brightness with each stop; never restarts ([ and ])"});
    int toneMap = static_cast<int>(display.toneMap);
    if (ui::choice("Tone map", &toneMap, kToneMaps, "From radiance to the screen; never restarts")) {
        display.toneMap = static_cast<ToneMap>(toneMap);
    }
    int shown = static_cast<int>(display.shown);
    if (ui::choice("Shown", &shown, kImages,
                   "The render, what the camera's first hit tells, or how far the render may be off")) {
        display.shown = static_cast<ShownImage>(shown);
    }
    if (const char* why = missing(*model)) { ui::hint(why); }
    ui::toggle("Compare", &display.split,
               "Path tracing left of the divider, SPPM right of it, at equal render time (C)");
    int size = display.pixelScale ? 1 : 0;
    if (ui::choice("Size", &size, kSizes, "How large the picture is drawn; never restarts")) {
        display.pixelScale = size == 1;
    }
    ImGui::PopID();
    ui::gap();
}

}  // namespace glint
