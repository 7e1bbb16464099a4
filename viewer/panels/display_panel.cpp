// How the picture is shown. Nothing here reaches the renderer, but for the extra pictures it is asked to
// make.
#include <array>
#include <string_view>

#include <imgui.h>

#include "viewer/panels/panels.h"
#include "viewer/window/widgets.h"

namespace glint {
namespace {

constexpr std::array<std::string_view, 4> kToneMaps{"Clamp (linear)", "sRGB", "Filmic", "Reinhard"};
constexpr std::array<std::string_view, 11> kPictures{
    "Radiance",    "Albedo",         "Shading normal", "Geometric normal", "Depth",         "Object id",
    "Material id", "Standard error", "SPPM radius",    "Photon count",     "Visible points"};
constexpr std::array<std::string_view, 2> kSizes{"Fit the window", "1:1 pixels"};

}  // namespace

void drawDisplayPanel(ViewerModel* model) {
    if (!ui::section("Display", true)) return;
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
    if (ui::choice("Shown", &shown, kPictures, "The render, or what the camera's first hit tells")) {
        display.shown = static_cast<ShownPicture>(shown);
    }
    const bool hasPhotons = display.split || model->draft().options.integrator == IntegratorKind::Sppm;
    if (isOfPhotons(display.shown) && !hasPhotons)
        ui::hint("Path tracing has no photons: choose SPPM as the integrator.");
    ui::toggle("Compare", &display.split,
               "Path tracing left of the divider, SPPM right of it, at equal render time (C)");
    int size = display.pixelScale ? 1 : 0;
    if (ui::choice("Size", &size, kSizes)) display.pixelScale = size == 1;
    ImGui::PopID();
    ui::gap();
}

}  // namespace glint
