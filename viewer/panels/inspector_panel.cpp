// One pixel in numbers, an area, and the picture's histogram or waveform.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>
#include <imgui.h>

#include "engine/render/first_hits.h"
#include "engine/render/integrator.h"
#include "viewer/base/units.h"
#include "viewer/model/display_settings.h"
#include "viewer/model/inspector.h"
#include "viewer/model/render_control.h"
#include "viewer/model/scene_document.h"
#include "viewer/panels/image_scopes.h"
#include "viewer/panels/panel.h"
#include "viewer/ui/widgets.h"

namespace glint {
namespace {

std::string numbersText(const Vec3& v) { return fmt::format("{:.4g}  {:.4g}  {:.4g}", v.x, v.y, v.z); }

template <class Item>
std::string nameOf(const std::vector<Item>& items, uint32_t number, const char* what) {
    if (number == 0) { return "–"; }
    const bool isNamed = number <= items.size() && !items[number - 1].name.empty();
    return isNamed ? items[number - 1].name : fmt::format("{} {}", what, number);
}

void drawColors(const FilmSnapshot& snapshot, const DisplaySettings& display, Vec2i pixel) {
    const Vec3 linear = colorAt(snapshot, pixel);
    const size_t index = indexOf(snapshot, pixel);
    const Vec3 shown = ToneMapper(display.look())(linear);
    const std::array<int, 3> bytes{displayByte(shown.x), displayByte(shown.y), displayByte(shown.z)};
    ui::value("Linear", numbersText(linear), "Radiance, Rec.709 primaries, W/(sr m²)");
    ui::value("Shown",
              fmt::format("{} {} {}   #{:02x}{:02x}{:02x}", bytes[0], bytes[1], bytes[2], bytes[0], bytes[1],
                          bytes[2]),
              "With white balance, exposure and tone map");
    const float l = luminance(linear);
    const bool hasError =
        index < snapshot.standardError.size() && std::isfinite(snapshot.standardError[index]);
    ui::value("Luminance",
              hasError ? fmt::format("{:.4g} ± {:.2g}", l, snapshot.standardError[index])
                       : fmt::format("{:.4g}", l),
              "With its standard error, from the second pass on");
    for (const IntegratorMapInfo& map : integratorType(snapshot.integrator).maps()) {
        const std::vector<float>& values = snapshot.map(map.values);
        if (index < values.size()) {
            ui::value(map.label, infoOf(*imageNamed(map.label)).readout(values[index]));
        }
    }
}

void drawHit(const RenderControl& render, const SceneDescription& scene, Vec2i pixel) {
    const auto built = render.builtScene();
    const Resolution& size = scene.resolution;
    const bool isInside = pixel.x < size.width && pixel.y < size.height;
    const FirstHit hit =
        built && isInside ? firstHit(*built, size.width, size.height, pixel.x, pixel.y) : FirstHit{};
    ui::value("Depth", hit.depth > 0.0f ? length(static_cast<double>(hit.depth)) : "–",
              "Along the view axis, in the pixel's middle");
    ui::value("Object", nameOf(scene.objects, hit.object, "object"));
    ui::value("Material", nameOf(scene.materials, hit.material, "material"));
}

void drawMeasured(const std::shared_ptr<const FilmSnapshot>& snapshot, Inspector* inspector) {
    const char* label = inspector->picksArea ? "Drag on the picture…"
                        : inspector->area    ? "Forget the area"
                                             : "Measure an area…";
    if (ui::button(label, ui::buttonWidth(1),
                   "The next drag on the picture draws it: its mean and deviation")) {
        inspector->picksArea = !inspector->picksArea && !inspector->area;
        inspector->area.reset();
    }
    if (!inspector->area) { return; }
    const FilmRegion& area = *inspector->area;
    if (inspector->statisticsOf != snapshot) {
        inspector->statisticsOf = snapshot;
        inspector->statistics = statisticsOf(*snapshot, area);
    }
    const AreaStatistics& measured = inspector->statistics;
    ui::value("Area", fmt::format("{} × {} px", area.x1 - area.x0, area.y1 - area.y0));
    ui::value("Area mean", numbersText(measured.mean), "Linear radiance");
    ui::value("Area deviation", numbersText(measured.deviation),
              "From pixel to pixel, of the linear radiance");
}

void draw(RenderControl* render, const DisplaySettings* display, const SceneDocument* document,
          Inspector* inspector) {
    inspector->isOpen = true;
    const auto& snapshot = render->snapshot();
    if (!snapshot || snapshot->radiance.empty()) { return ui::hint("No picture yet."); }
    if (inspector->pixel) {
        const Vec2i pixel = *inspector->pixel;
        ui::value("Pixel", fmt::format("{}, {}", pixel.x, pixel.y), "The last one that the mouse was over");
        drawColors(*snapshot, *display, pixel);
        if (const auto& other = render->otherSnapshot();
            display->split && other && !other->radiance.empty()) {
            ui::value(inCapitals(integratorInfo(other->integrator).alias).c_str(),
                      numbersText(colorAt(*other, pixel)), "The same pixel of what is compared");
        }
        drawHit(*render, document->draft(), pixel);
    } else {
        ui::hint("Move the mouse over the picture.");
    }
    drawMeasured(snapshot, inspector);
    drawScopes(inspector->image ? inspector->image : snapshot, display->look(), inspector);
}

}  // namespace

Panel inspectorPanel() { return {"Inspector", false, OfParts<draw>::call, WithoutScene::Hides}; }

}  // namespace glint
