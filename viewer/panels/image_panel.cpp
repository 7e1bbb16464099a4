// The picture's size, how it is sampled, and all that makes it as the original's.

#include <imgui.h>

#include "engine/scene/as_original.h"
#include "viewer/model/display_settings.h"
#include "viewer/model/ocio_chooser.h"
#include "viewer/model/scene_document.h"
#include "viewer/panels/panel.h"
#include "viewer/ui/widgets.h"

namespace glint {
namespace {

void drawSize(Resolution* resolution) {
    ui::integer("Width", &resolution->width,
                {.format = "%d px",
                 .speed = 4.0f,
                 .min = 16.0f,
                 .max = 16384.0f,
                 .tooltip = "Of the picture that is rendered and saved"});
    ui::integer("Height", &resolution->height,
                {.format = "%d px",
                 .speed = 4.0f,
                 .min = 16.0f,
                 .max = 16384.0f,
                 .tooltip = "Of the picture that is rendered and saved"});
}

void drawSampling(RenderOptions* options) {
    static constexpr ui::KindLabel<FilterKind> kFilters[]{{FilterKind::Box, "Box"},
                                                          {FilterKind::Gaussian, "Gaussian"},
                                                          {FilterKind::BlackmanHarris, "Blackman-Harris"}};
    static constexpr ui::KindLabel<SamplerKind> kSamplers[]{{SamplerKind::Sobol, "Sobol"},
                                                            {SamplerKind::Independent, "Independent"}};
    ui::integer("Max depth", &options->maxDepth,
                {.format = "%d bounces",
                 .speed = 0.1f,
                 .max = 1024.0f,
                 .tooltip = "Most scattering events of a path"});
    ui::integer("Roulette from", &options->rouletteStartDepth,
                {.format = "bounce %d",
                 .speed = 0.1f,
                 .max = 1024.0f,
                 .tooltip = "Paths are ended at random from this bounce on; the mean stays the same"});
    ui::kindChoice("Filter", &options->filter, kFilters, "How a pixel weighs the light around it");
    ui::number(
        "Filter radius", &options->filterRadius,
        {.format = "%.2f px", .speed = 0.01f, .min = 0.1f, .max = 8.0f, .tooltip = "Larger is softer"});
    ui::kindChoice("Sampler", &options->sampler, kSamplers, "Sobol's points lie evenly and converge faster");
    int seed = static_cast<int>(options->seed);
    if (ui::integer("Seed", &seed,
                    {.format = "%d",
                     .speed = 0.1f,
                     .max = 1e9f,
                     .tooltip = "Another number gives another noise; the same one the same picture"})) {
        options->seed = static_cast<uint32_t>(seed);
    }
    ui::number(
        "Firefly clamp", &options->fireflyClamp,
        {.format = "%.2f W/(sr m²)",
         .speed = 0.05f,
         .max = 1e9f,
         .zeroText = "off",
         .tooltip =
             "The most radiance one sample may bring. Hides fireflies, and darkens the picture a little"});
}

void drawAsOriginal(SceneDescription* scene, DisplaySettings* display, OcioChooser* ocio) {
    if (!ui::button(
            "As the original", ui::buttonWidth(1),
            "As the program that 6.837 texts were written for: depth 20, a box filter of 1 pixel each way, a "
            "square lens, and a display that clamps, without exposure")) {
        return;
    }
    setAsOriginal(scene);
    ocio->giveUp();
    display->view = nullptr;
    display->toneMap = ToneMap::Clamp;
    display->exposureStops = 0.0f;
}

void draw(SceneDocument* document, DisplaySettings* display, OcioChooser* ocio) {
    drawSize(&document->draft().resolution);
    drawSampling(&document->draft().options);
    drawAsOriginal(&document->draft(), display, ocio);
}

}  // namespace

Panel imagePanel() { return {"Picture", false, OfParts<draw>::call, WithoutScene::Hints}; }

}  // namespace glint
