// Photon mapping's settings: edits of them restart its statistics and nothing else. Shown while SPPM is.
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>
#include <imgui.h>

#include "engine/render/sppm_state.h"
#include "viewer/base/units.h"
#include "viewer/model/display_settings.h"
#include "viewer/model/render_control.h"
#include "viewer/model/scene_document.h"
#include "viewer/panels/panel.h"
#include "viewer/ui/theme.h"
#include "viewer/ui/widgets.h"

namespace glint {
namespace {

constexpr float kFirstAbsoluteShare = 0.005f;  // of the scene's size: where an absolute radius begins
constexpr double kMiB = 1024.0 * 1024.0;

void drawRadius(SppmOptions* sppm, float sceneSize) {
    static constexpr std::array<std::string_view, 2> kKinds{"Pixel footprints", "Absolute"};
    int kind = sppm->radiusWorld > 0.0f ? 1 : 0;
    if (ui::choice("Radius from", &kind, kKinds,
                   "Each pixel's own footprint, or one length for the whole picture")) {
        sppm->radiusWorld = kind == 1 ? sceneSize * kFirstAbsoluteShare : 0.0f;
    }
    if (sppm->radiusWorld > 0.0f) {
        float millimetres = sppm->radiusWorld * 1000.0f;
        if (ui::number("Radius", &millimetres,
                       {.format = "%.3f mm",
                        .speed = std::max(millimetres * 0.01f, 1e-4f),
                        .min = 1e-6f,
                        .max = 1e9f,
                        .tooltip = "Initial radius. Larger: smoother and more blurred at first"})) {
            sppm->radiusWorld = millimetres / 1000.0f;
        }
        return;
    }
    ui::number("Radius", &sppm->radiusFootprints,
               {.format = "%.2f px",
                .speed = 0.02f,
                .min = 0.1f,
                .max = 1000.0f,
                .tooltip = "Initial radius in pixels. Larger: smoother and more blurred at first"});
}

void drawPhotons(SppmOptions* sppm) {
    ui::number("Alpha", &sppm->alpha,
               {.format = "%.3f",
                .min = 0.05f,
                .max = 0.95f,
                .slider = true,
                .tooltip = "Share of each pass's photons that is kept: smaller shrinks radii faster"});
    int photons = static_cast<int>(std::min<uint32_t>(sppm->photonsPerPass, 1u << 30));
    if (ui::integer("Photons", &photons,
                    {.format = "%d a pass",
                     .speed = std::max(static_cast<float>(photons) * 0.01f, 1.0f),
                     .min = 1.0f,
                     .max = 1e9f,
                     .tooltip = "Emitted from all lights in each pass"})) {
        sppm->photonsPerPass = static_cast<uint32_t>(photons);
    }
    static constexpr std::array<std::string_view, 2> kDirect{"Sampled", "By photons"};
    int direct = sppm->sampleDirectLight ? 0 : 1;
    if (ui::choice("Direct light", &direct, kDirect,
                   "Sampled: shadow rays, and photons carry only what was scattered")) {
        sppm->sampleDirectLight = direct == 0;
    }
    static constexpr ui::KindLabel<PhotonLookupKind> kLookups[]{{PhotonLookupKind::Grid, "Hash grid"},
                                                                {PhotonLookupKind::Tree, "Kd-tree"}};
    ui::kindChoice("Look-up", &sppm->lookup, kLookups, "How photons are found; the picture stays the same");
    ui::number(
        "Store from", &sppm->storeRoughness,
        {.format = "%.3f",
         .max = 1.0f,
         .slider = true,
         .tooltip = "Metal and glass of at least this roughness gather photons; smoother ones reflect"});
}

void drawMemory(const SceneDescription& scene, size_t filmBytes, SppmOptions* sppm) {
    int budget = static_cast<int>(std::min<uint32_t>(sppm->memoryBudgetMiB, 1u << 20));
    if (ui::integer("Memory limit", &budget,
                    {.format = "%d MiB",
                     .speed = 4.0f,
                     .min = 1.0f,
                     .max = 1048576.0f,
                     .tooltip = "For statistics and photons; photons per pass are reduced to fit"})) {
        sppm->memoryBudgetMiB = static_cast<uint32_t>(budget);
    }
    const SppmMemory memory = planSppmMemory(scene);
    ui::value(
        "Planned", fmt::format("{:.1f} MiB", static_cast<double>(memory.total()) / kMiB),
        fmt::format("Pixels {:.1f} MiB, photons {:.1f} MiB", static_cast<double>(memory.pixelBytes) / kMiB,
                    static_cast<double>(memory.photonBytes) / kMiB)
            .c_str());
    ui::value("Films", fmt::format("{:.1f} MiB", static_cast<double>(filmBytes) / kMiB),
              "In use now by the films and statistics of both integrators, previews included");
    if (memory.photonsPerPass >= sppm->photonsPerPass) { return; }
    ImGui::PushStyleColor(ImGuiCol_Text, theme::kTextWarning);
    ui::value("Reduced to", fmt::format("{} photons a pass", grouped(memory.photonsPerPass)),
              "As many as fit the memory limit");
    ImGui::PopStyleColor();
}

void draw(SceneDocument* document, const RenderControl* render) {
    SppmOptions* sppm = &document->draft().sppm;
    const float size = maxComponent(document->bounds().extent());
    drawRadius(sppm, std::isfinite(size) && size > 0.0f ? size : 1.0f);
    drawPhotons(sppm);
    drawMemory(document->draft(), render->status().filmBytes, sppm);
}

bool isShown(const SceneDocument* document, const DisplaySettings* display) {
    return display->shows(IntegratorKind::Sppm, document->draft().options.integrator);
}

}  // namespace

Panel sppmPanel() {
    return {"SPPM",
            true,
            OfParts<draw>::call,
            WithoutScene::Hides,
            "Stochastic progressive photon mapping (Hachisuka and Jensen 2009)",
            OfParts<isShown>::call};
}

}  // namespace glint
