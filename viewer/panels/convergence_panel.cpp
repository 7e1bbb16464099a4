// How far the picture is from the truth over render time, for each integrator: against a loaded reference,
// or as the render estimates it; when a target is reached; the curves as a file.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <imgui.h>

#include "viewer/base/units.h"
#include "viewer/model/convergence_watch.h"
#include "viewer/model/curve_export.h"
#include "viewer/model/render_control.h"
#include "viewer/model/scene_document.h"
#include "viewer/panels/convergence_curves.h"
#include "viewer/panels/panel.h"
#include "viewer/ui/theme.h"
#include "viewer/ui/widgets.h"

namespace glint {
namespace {

constexpr float kPlotHeightUnits = 200.0f;

/// The relative error to reach.
double targetOf(const ConvergenceWatch& convergence, const RenderControl& render) {
    const double limit = render.request.limits.relativeError;
    return limit > 0.0 ? limit : convergence.targetError;
}

void drawPlot(const ConvergenceWatch& convergence, double target) {
    const std::vector<CurveSource> sources = curveSources(convergence);
    const LogLogPlot plot = convergencePlot(convergence, sources, target);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 size{ImGui::GetContentRegionAvail().x, kPlotHeightUnits * ui::scale()};
    ImGui::Dummy(size);
    const PlotHover hover =
        drawLogLogPlot(plot, {corner.x, corner.y}, {corner.x + size.x, corner.y + size.y});
    std::string shown;
    for (size_t i = 0; i < hover.size(); ++i) {
        if (hover[i]) {
            shown += (shown.empty() ? "" : "\n") + pointText(convergence, sources[i], *hover[i]);
        }
    }
    if (!shown.empty()) {
        ui::tooltip(shown.c_str());
    } else {
        for (size_t i = 0; i < convergence.integrators().size(); ++i) {
            const PlotCurve& curve = plot.curves[i];
            shown += fmt::format("{}{} {} points", i > 0 ? ", " : "", curve.name, curve.points.size());
        }
    }
    ui::itemArea("Curve", shown);
}

/// A row for each integrator, also while nothing is known: what stands below must not jump under the mouse
/// when a film restarts.
void drawErrors(const ConvergenceWatch& convergence) {
    const bool reference = hasReference(convergence);
    for (const IntegratorKind kind : convergence.integrators()) {
        const char* name = integratorInfo(kind).displayName;
        const auto& estimates = convergence.curve(kind)->points();
        const auto& measured = convergence.reference.points(kind);
        if (reference && !measured.empty()) {
            const ReferencePoint& last = measured.back();
            ui::value(name,
                      fmt::format("{}, {}", percent(last.error(convergence.metric)), passCount(last.passes)),
                      fmt::format("Against the reference. Mean signed difference: {:+.3g} % of its mean",
                                  last.relativeBias * 100.0)
                          .c_str());
        } else if (!reference && !estimates.empty()) {
            const ConvergencePoint& last = estimates.back();
            ui::value(name,
                      fmt::format("{}  ({} – {})", percent(last.relativeError),
                                  percent(last.relativeErrorLow), percent(last.relativeErrorHigh)),
                      "The estimate and its 90 % band. Light that no path has found yet is not in it");
        } else {
            ui::value(name, "–", "Nothing is known before the second pass");
        }
    }
}

std::string forecastText(const ConvergenceCurve& curve, double target) {
    if (curve.points().back().relativeError <= target) {
        for (const ConvergencePoint& point : curve.points()) {
            if (point.relativeError <= target) { return "reached at " + duration(point.renderSeconds); }
        }
    }
    const auto forecast = forecastError(curve, target);
    if (!forecast || !std::isfinite(forecast->secondsLeft)) { return "not to be told yet"; }
    std::string left = "in " + duration(forecast->secondsLeft);
    if (!(forecast->secondsHigh > forecast->secondsLow * 1.02)) { return left; }
    const bool isBounded = std::isfinite(forecast->secondsHigh);
    return fmt::format("{}  ({} – {})", left, duration(forecast->secondsLow),
                       isBounded ? duration(forecast->secondsHigh) : "never");
}

void drawTarget(ConvergenceWatch* convergence, RenderControl* render) {
    double& limit = render->request.limits.relativeError;
    auto target = static_cast<float>(targetOf(*convergence, *render) * 100.0);
    bool stops = limit > 0.0;
    const bool changed = ui::number("Target error", &target,
                                    {.format = "%.3g %%",
                                     .speed = std::max(target * 0.01f, 1e-4f),
                                     .min = 1e-4f,
                                     .max = 100.0f,
                                     .tooltip = "The error to reach; the dashed line"});
    const bool switched = ui::toggle("Stop there", &stops,
                                     "Ends the render when the estimate is below the target. It is the error "
                                     "limit of the Render panel");
    if (changed || switched) {
        convergence->targetError = static_cast<double>(target) / 100.0;
        limit = stops ? convergence->targetError : 0.0;
    }
}

void drawForecasts(const ConvergenceWatch& convergence, double target) {
    for (const IntegratorKind kind : convergence.integrators()) {
        const ConvergenceCurve curve = hasReference(convergence)
                                           ? asCurve(convergence.reference.points(kind), convergence.metric)
                                           : *convergence.curve(kind);
        const std::string label = fmt::format("{} to target", inCapitals(integratorInfo(kind).alias));
        ui::value(label.c_str(), curve.empty() ? "–" : forecastText(curve, target),
                  "Render time that is left, from how the curve fell so far, with a 90 % band");
    }
}

void warn(const char* label, const std::string& text) {
    ImGui::PushStyleColor(ImGuiCol_Text, theme::kTextWarning);
    ImGui::TextWrapped("%s", text.c_str());
    ImGui::PopStyleColor();
    ui::itemArea(label, text);
}

/// Why nothing can be measured against the reference, or why that is doubtful.
std::string whyUnfit(const ConvergenceWatch& convergence, const Resolution& size) {
    std::string mismatch = convergence.reference.mismatch(size.width, size.height);
    const ReferenceFit& fit = convergence.fit;
    if (!mismatch.empty() || fit.fits()) { return mismatch; }
    if (fit.checking()) { return "Checking whether the reference shows this scene…"; }
    return fmt::format(
        "The reference does not fit: {}. {}", fit.difference(),
        fit.useAnyway ? "The errors are measured all the same." : "Until it does, the error is estimated.");
}

void drawOwnError(const LoadedReference& reference) {
    const auto found = reference.attributes.find("referenceRelativeError");
    if (found == reference.attributes.end()) { return; }
    ui::value("Its own error", percent(std::strtod(found->second.c_str(), nullptr)),
              "RMSE / mean of the reference itself. Errors close to it say little");
}

/// It was rendered from the same random numbers as one of the pictures here.
bool sharesSeed(const LoadedReference& reference, uint32_t sceneSeed) {
    const auto& attributes = reference.attributes;
    const auto seed = attributes.find("setting.seed");
    return seed != attributes.end() && !attributes.contains("referenceSeeds") &&
           seed->second == std::to_string(sceneSeed);
}

void drawReferenceState(const ConvergenceWatch& convergence, const SceneDescription& scene) {
    const ReferenceErrors& reference = convergence.reference;
    if (reference.loadError()) { warn("Load error", reference.loadError()->format()); }
    if (!reference.loaded()) {
        if (!reference.loading() && !reference.loadError()) {
            ui::hint(
                "Without a reference the error is estimated. Drop an EXR, HDR or PNG file on the window.");
        }
        return;
    }
    const std::string mismatch = whyUnfit(convergence, scene.resolution);
    ui::value("In use",
              fmt::format("{} × {} px", reference.loaded()->image.width, reference.loaded()->image.height),
              reference.loaded()->path.c_str());
    if (!mismatch.empty()) { warn("Mismatch", mismatch); }
    drawOwnError(*reference.loaded());
    if (sharesSeed(*reference.loaded(), scene.options.seed)) {
        warn("Seed note",
             "The reference has this scene's seed: noise that both share is not seen as an error.");
    }
    if (reference.loaded()->isEightBit) {
        warn("Note", "An 8-bit reference knows no values above 1: lamps will seem wrong.");
    }
}

/// It has the right size, and shows something else.
bool isDoubtful(const ConvergenceWatch& convergence, const Resolution& size) {
    const ReferenceErrors& reference = convergence.reference;
    return reference.loaded() && reference.mismatch(size.width, size.height).empty() &&
           !convergence.fit.fits() && !convergence.fit.checking();
}

void drawReference(ConvergenceWatch* convergence, const SceneDescription& scene) {
    static constexpr std::array<std::string_view, 4> kMetrics{"Picture error", "Relative RMSE", "RMSE / mean",
                                                              "MAPE"};
    ui::heading("Reference");
    const bool entered =
        ui::file("Reference file", &convergence->referencePath, "reference.exr, .hdr, .png",
                 "A picture of the same scene and size, as exact as possible. Enter loads it");
    const float half = ui::buttonWidth(2);
    const bool loading = convergence->reference.loading();
    const bool pressed = ui::button(loading ? "Loading…" : "Load", half, "Compares with this file");
    if ((pressed || entered) && !loading) {
        convergence->reference.load(convergence->referencePath, scene.resolution);
    }
    ImGui::SameLine();
    if (ui::button("Clear", half, "Back to the estimate")) { convergence->reference.clear(); }
    drawReferenceState(*convergence, scene);
    if (isDoubtful(*convergence, scene.resolution)) {
        ui::toggle("Use anyway", &convergence->fit.useAnyway,
                   "Measures against it although it seems to show something else");
    }
    int metric = static_cast<int>(convergence->metric);
    if (hasReference(*convergence) &&
        ui::choice(
            "Measured as", &metric, kMetrics,
            "Picture error: what the estimate is of, too; it is drawn behind. Relative RMSE: root of relMSE. "
            "MAPE: mean absolute relative error")) {
        convergence->metric = static_cast<ReferenceMetric>(metric);
    }
}

void drawExport(CurveExport* curves, const ConvergenceWatch& convergence) {
    ui::gap();
    ui::file("CSV file", &curves->path, "convergence.csv", "Every point of the curves, as a table");
    if (ui::button("Export CSV", ui::buttonWidth(1))) { curves->save(convergence); }
    const Notice& result = curves->result();
    if (result.text().empty()) { return; }
    if (result.isError()) {
        warn("CSV message", result.text());
    } else {
        ui::hint(result.text().c_str());
    }
}

void draw(ConvergenceWatch* convergence, RenderControl* render, CurveExport* curves,
          const SceneDocument* document) {
    drawPlot(*convergence, targetOf(*convergence, *render));
    drawErrors(*convergence);
    drawTarget(convergence, render);
    drawForecasts(*convergence, targetOf(*convergence, *render));
    drawReference(convergence, document->draft());
    drawExport(curves, *convergence);
}

}  // namespace

Panel convergencePanel() {
    return {"Convergence", true, OfParts<draw>::call, WithoutScene::Hides,
            "The error over render time, on logarithmic axes"};
}

}  // namespace glint
