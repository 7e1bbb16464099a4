// How the picture is shown. Nothing here reaches the renderer, but for the extra pictures it is asked
// to make.
#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "viewer/model/convergence_watch.h"
#include "viewer/model/display_settings.h"
#include "viewer/model/key_map.h"
#include "viewer/model/ocio_chooser.h"
#include "viewer/model/scene_document.h"
#include "viewer/panels/compare_view.h"
#include "viewer/panels/panel.h"
#include "viewer/ui/widgets.h"

namespace glint {
namespace {

constexpr std::array<std::string_view, kToneMapCount> kToneMaps{"Clamp (linear)", "sRGB", "Filmic",
                                                                "Reinhard", "Soft highlights"};

void drawShown(DisplaySettings* display) {
    std::vector<std::string_view> names;
    for (const ShownImageInfo& info : shownImages()) {
        names.emplace_back(info.name);
    }
    int shown = static_cast<int>(display->shown);
    if (ui::choice("Shown", &shown, names,
                   "The render, what the camera's first hit tells, or how far the render may be off")) {
        display->shown = static_cast<ShownImage>(shown);
    }
}

/// Why the radiance is shown instead; "" when nothing is missing.
std::string missing(const DisplaySettings& display, IntegratorKind own, const ConvergenceWatch& convergence) {
    const ShownImageInfo& info = infoOf(display.shown);
    const bool isOfOther = display.split && info.isOf(display.otherOf(own));
    if (!info.isOf(own) && !isOfOther) {
        const auto hasIt = [&info](const IntegratorInfo& each) { return info.isOf(each.kind); };
        return fmt::format("{} has no {}: choose {} as the integrator.", integratorInfo(own).displayName,
                           info.lacking, std::ranges::find_if(kIntegratorTable, hasIt)->displayName);
    }
    if (!info.isAgainstReference) { return ""; }
    if (!convergence.reference.loaded()) { return "Load a reference in the Convergence panel first."; }
    return convergence.usableReference() ? "" : "The reference does not fit: see the Convergence panel.";
}

/// The choice of the other integrator is worth a row where there are several.
void drawComparison(DisplaySettings* display, IntegratorKind own, const KeyMap& keys) {
    const auto [left, right] = display->pairOf(own);
    const std::string tooltip =
        keys.tip(fmt::format("{} left of the divider, {} right of it, at equal render time",
                             integratorInfo(left).displayName, integratorInfo(right).displayName),
                 KeyAction::Compare);
    ui::toggle("Compare", &display->split, tooltip.c_str());
    if (!display->split) { return; }
    drawCompareView(display, keys);
    if (kIntegratorTable.size() < 3) { return; }
    std::vector<std::string_view> names;
    std::vector<IntegratorKind> kinds;
    int index = 0;
    for (const IntegratorInfo& info : kIntegratorTable) {
        if (info.kind == own) { continue; }
        if (info.kind == display->otherOf(own)) { index = static_cast<int>(kinds.size()); }
        names.emplace_back(info.displayName);
        kinds.push_back(info.kind);
    }
    if (ui::choice("Compare with", &index, names, "The other integrator of the comparison")) {
        display->comparedWith = kinds[static_cast<size_t>(index)];
    }
}

/// A row for each choice that the configuration offers.
void drawOcioView(const OcioView& view, OcioChooser* ocio) {
    std::vector<std::string_view> displays;
    int display = 0;
    for (const OcioDisplay& each : view.displays) {
        if (each.name == view.choice.display) { display = static_cast<int>(displays.size()); }
        displays.emplace_back(each.name);
    }
    if (ui::choice("OCIO display", &display, displays, "What the picture is to be seen on")) {
        ocio->load({view.choice.config, std::string(displays[static_cast<size_t>(display)]), ""});
    }
    const std::vector<std::string>& names = view.displays[static_cast<size_t>(display)].views;
    const std::vector<std::string_view> views(names.begin(), names.end());
    int index = static_cast<int>(std::ranges::find(names, view.choice.view) - names.begin());
    if (ui::choice("OCIO view", &index, views, "In place of the tone map; also in PNGs that are saved")) {
        ocio->load({view.choice.config, view.choice.display, names[static_cast<size_t>(index)]});
    }
}

/// What leads from radiance to the screen. An OpenColorIO configuration is the choice after the tone maps.
void drawCurve(DisplaySettings* display, OcioChooser* ocio) {
    std::vector<std::string_view> names(kToneMaps.begin(), kToneMaps.end());
    if (hasOcio()) { names.emplace_back("OpenColorIO"); }
    int index = display->view || ocio->isWanted ? kToneMapCount : static_cast<int>(display->toneMap);
    if (ui::choice("Tone map", &index, names, "From radiance to the screen; never restarts")) {
        ocio->giveUp();
        ocio->isWanted = index == kToneMapCount;
        if (!ocio->isWanted) {
            display->toneMap = static_cast<ToneMap>(index);
            display->view = nullptr;
        } else if (!ocio->config.empty()) {
            ocio->load({ocio->config, "", ""});
        }
    }
    if (!display->view && !ocio->isWanted) { return; }
    if (ui::file("OCIO config", &ocio->config, "config.ocio",
                 "An OpenColorIO configuration. Enter reads it") &&
        !ocio->config.empty()) {
        ocio->load({ocio->config, "", ""});
    }
    if (!display->view) {
        if (ui::button(ocio->isLoading() ? "Reading…" : "Read the configuration", ui::buttonWidth(1)) &&
            !ocio->config.empty()) {
            ocio->load({ocio->config, "", ""});
        }
        return;
    }
    drawOcioView(*display->view, ocio);
}

void drawLook(DisplaySettings* display, OcioChooser* ocio, const KeyMap& keys) {
    const std::string tip = fmt::format("Doubles the brightness with each stop; never restarts ({} and {})",
                                        keys.textOf(KeyAction::Darker), keys.textOf(KeyAction::Brighter));
    ui::number(
        "Exposure", &display->exposureStops,
        {.format = "%+.2f stops", .min = -10.0f, .max = 10.0f, .slider = true, .tooltip = tip.c_str()});
    if (display->exposureStops != 0.0f && display->exposureStops == display->chosenExposureStops) {
        ui::hint("chosen when the scene was opened: it would be black or white");
    }
    drawCurve(display, ocio);
    ui::number("White", &display->white.kelvin,
               {.format = "%.0f K",
                .min = kLeastKelvin,
                .max = kMostKelvin,
                .slider = true,
                .tooltip = "Temperature of the light that is shown white; 6504 K changes nothing"});
    ui::number("Tint", &display->white.tint,
               {.format = "%+.0f",
                .min = -kMostTint,
                .max = kMostTint,
                .slider = true,
                .tooltip = "To the right less green, to the left more"});
    ui::toggle("Dither", &display->dithers, "Rounds to 8 bits by a fine pattern: gradients show no steps");
    ui::toggle(
        "Denoise", &display->denoises,
        "Shows and saves the radiance without its noise, guided by albedo, normals and depth: quickly while "
        "it renders, carefully once it rests. The film and its error stay as they are");
}

void draw(DisplaySettings* display, const SceneDocument* document, const ConvergenceWatch* convergence,
          OcioChooser* ocio, const KeyMap* keys) {
    const IntegratorKind own = document->draft().options.integrator;
    drawLook(display, ocio, *keys);
    drawShown(display);
    if (const std::string why = missing(*display, own, *convergence); !why.empty()) { ui::hint(why.c_str()); }
    drawComparison(display, own, *keys);
    int size = display->framing.choice();
    const std::vector<std::string> sizes = ImageFraming::choices();
    if (ui::choice("Size", &size, std::vector<std::string_view>(sizes.begin(), sizes.end()),
                   "Screen pixels per picture pixel (Ctrl + wheel); automatic: as many as there is room for. "
                   "Never restarts")) {
        display->framing.choose(size);
    }
}

}  // namespace

Panel displayPanel() { return {"Display", true, OfParts<draw>::call}; }

}  // namespace glint
