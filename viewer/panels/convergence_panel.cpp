// How far the picture is from the truth over render time, for both integrators: against a loaded reference,
// or as the render estimates it; when a target is reached; the curves as a file.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <imgui.h>

#include "viewer/panels/convergence_curves.h"
#include "viewer/panels/panels.h"
#include "viewer/panels/units.h"
#include "viewer/window/theme.h"
#include "viewer/window/widgets.h"

namespace glint {
namespace {

constexpr float kPlotHeightUnits = 200.0f;
constexpr std::array<const char*, 2> kForecastNames{"PT to target", "SPPM to target"};

void drawPlot(const ViewerModel& model) {
    const std::vector<CurveSource> sources = curveSources(model);
    const LogLogPlot plot = convergencePlot(model, sources);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 size{ImGui::GetContentRegionAvail().x, kPlotHeightUnits * ui::scale()};
    ImGui::Dummy(size);
    const PlotHover hover =
        drawLogLogPlot(plot, {corner.x, corner.y}, {corner.x + size.x, corner.y + size.y});
    std::string shown;
    for (size_t i = 0; i < hover.size(); ++i) {
        if (hover[i]) { shown += (shown.empty() ? "" : "\n") + pointText(model, sources[i], *hover[i]); }
    }
    if (!shown.empty()) {
        ui::tooltip(shown.c_str());
    } else {
        for (size_t i = 0; i < kBothIntegrators.size(); ++i) {
            shown += fmt::format("{}{} {} points", i > 0 ? ", " : "", kIntegratorNames[i],
                                 plot.curves[i].points.size());
        }
    }
    ui::itemArea("Curve", shown);
}

/// A row for each integrator, also while nothing is known: what stands below must not jump under the mouse
/// when a film restarts.
void drawErrors(const ViewerModel& model) {
    const bool reference = hasReference(model);
    for (size_t kind = 0; kind < kBothIntegrators.size(); ++kind) {
        const auto& estimates = model.curve(kBothIntegrators[kind])->points();
        const auto& measured = model.reference.points(kBothIntegrators[kind]);
        if (reference && !measured.empty()) {
            const ReferencePoint& last = measured.back();
            ui::value(
                kIntegratorNames[kind],
                fmt::format("{}, {}", percent(last.error(model.convergence.metric)), passesText(last.passes)),
                fmt::format("Against the reference. Mean signed difference: {:+.3g} % of its mean",
                            last.relativeBias * 100.0)
                    .c_str());
        } else if (!reference && !estimates.empty()) {
            const ConvergencePoint& last = estimates.back();
            ui::value(kIntegratorNames[kind],
                      fmt::format("{}  ({} – {})", percent(last.relativeError),
                                  percent(last.relativeErrorLow), percent(last.relativeErrorHigh)),
                      "The estimate and its 90 % band. Light that no path has found yet is not in it");
        } else {
            ui::value(kIntegratorNames[kind], "–", "Nothing is known before the second pass");
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

void drawTarget(ViewerModel* model) {
    auto target = static_cast<float>(targetOf(*model) * 100.0);
    bool stops = model->limits.relativeError > 0.0;
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
        model->convergence.targetError = static_cast<double>(target) / 100.0;
        model->limits.relativeError = stops ? model->convergence.targetError : 0.0;
    }
    for (size_t kind = 0; kind < kBothIntegrators.size(); ++kind) {
        const ConvergenceCurve curve =
            hasReference(*model)
                ? asCurve(model->reference.points(kBothIntegrators[kind]), model->convergence.metric)
                : *model->curve(kBothIntegrators[kind]);
        ui::value(kForecastNames[kind], curve.empty() ? "–" : forecastText(curve, targetOf(*model)),
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
std::string whyUnfit(const ViewerModel& model) {
    const Resolution& size = model.draft().resolution;
    std::string mismatch = model.reference.mismatch(size.width, size.height);
    const ReferenceFit& fit = model.referenceFit;
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
bool sharesSeed(const ViewerModel& model) {
    const auto& attributes = model.reference.image()->attributes;
    const auto seed = attributes.find("setting.seed");
    return seed != attributes.end() && !attributes.contains("referenceSeeds") &&
           seed->second == std::to_string(model.draft().options.seed);
}

void drawReferenceState(const ViewerModel& model) {
    const ReferenceErrors& reference = model.reference;
    if (reference.loadError()) { warn("Load error", reference.loadError()->format()); }
    if (!reference.image()) {
        if (!reference.loading() && !reference.loadError()) {
            ui::hint(
                "Without a reference the error is estimated. Drop an EXR, HDR or PNG file on the window.");
        }
        return;
    }
    const std::string mismatch = whyUnfit(model);
    ui::value("In use",
              fmt::format("{} × {} px", reference.image()->image.width, reference.image()->image.height),
              reference.image()->path.c_str());
    if (!mismatch.empty()) { warn("Mismatch", mismatch); }
    drawOwnError(*reference.image());
    if (sharesSeed(model)) {
        warn("Seed note",
             "The reference has this scene's seed: noise that both share is not seen as an error.");
    }
    if (reference.image()->isEightBit) {
        warn("Note", "An 8-bit reference knows no values above 1: lamps will seem wrong.");
    }
}

/// It has the right size, and shows something else.
bool isDoubtful(const ViewerModel& model) {
    const Resolution& size = model.draft().resolution;
    const ReferenceFit& fit = model.referenceFit;
    return model.reference.image() && model.reference.mismatch(size.width, size.height).empty() &&
           !fit.fits() && !fit.checking();
}

void drawReference(ViewerModel* model) {
    static constexpr std::array<std::string_view, 3> kMetrics{"Relative RMSE", "RMSE / mean", "MAPE"};
    ui::heading("Reference");
    const bool entered =
        ui::text("Reference file", &model->files.reference, "reference.exr, .hdr, .png",
                 "A picture of the same scene and size, as exact as possible. Enter loads it");
    const float half = ui::buttonWidth(2);
    const bool loading = model->reference.loading();
    const bool pressed = ui::button(loading ? "Loading…" : "Load", half, "Compares with this file");
    if ((pressed || entered) && !loading) { model->reference.load(model->files.reference); }
    ImGui::SameLine();
    if (ui::button("Clear", half, "Back to the estimate")) { model->reference.clear(); }
    drawReferenceState(*model);
    if (isDoubtful(*model)) {
        ui::toggle("Use anyway", &model->referenceFit.useAnyway,
                   "Measures against it although it seems to show something else");
    }
    int metric = static_cast<int>(model->convergence.metric);
    if (hasReference(*model) &&
        ui::choice(
            "Measured as", &metric, kMetrics,
            "Relative RMSE: root of relMSE. RMSE / mean: what the estimate is of, too; it is drawn behind. "
            "MAPE: mean absolute relative error")) {
        model->convergence.metric = static_cast<ReferenceMetric>(metric);
    }
}

void drawExport(ViewerModel* model) {
    ui::gap();
    ui::text("CSV file", &model->files.csv, "convergence.csv", "Every point of the curves, as a table");
    if (ui::button("Export CSV", ui::buttonWidth(1))) { model->saveConvergenceCsv(); }
    if (model->csvMessage().empty()) { return; }
    if (model->csvMessageIsError()) {
        warn("CSV message", model->csvMessage());
    } else {
        ui::hint(model->csvMessage().c_str());
    }
}

}  // namespace

void drawConvergencePanel(ViewerModel* model) {
    if (!model->hasScene()) { return; }
    if (!ui::section("Convergence", true, "The error over render time, on logarithmic axes")) { return; }
    ImGui::PushID("convergence");
    drawPlot(*model);
    drawErrors(*model);
    drawTarget(model);
    drawReference(model);
    drawExport(model);
    ImGui::PopID();
    ui::gap();
}

}  // namespace glint
