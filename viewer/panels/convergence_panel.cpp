// How far the picture is from the truth over render time, for both integrators: against a loaded reference,
// or as the render estimates it; when a target is reached; the curves as a file.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string_view>

#include <fmt/format.h>
#include <imgui.h>

#include "viewer/panels/panels.h"
#include "viewer/panels/units.h"
#include "viewer/window/loglog_plot.h"
#include "viewer/window/theme.h"
#include "viewer/window/widgets.h"

namespace glint {
namespace {

constexpr float kPlotHeightUnits = 200.0f;
constexpr std::array<IntegratorKind, 2> kBoth{IntegratorKind::PathTracing, IntegratorKind::Sppm};
constexpr std::array<const char*, 2> kNames{"Path tracing", "SPPM"};
constexpr std::array<const char*, 2> kForecastNames{"PT to target", "SPPM to target"};
// Orange and sky blue: told apart with any common colour blindness (Okabe and Ito 2002).
const std::array<Vec3, 2> kColors{Vec3(0.902f, 0.624f, 0.0f), Vec3(0.337f, 0.706f, 0.914f)};

bool hasReference(const ViewerModel& model) { return model.usableReference() != nullptr; }

double targetOf(const ViewerModel& model) {
    return model.limits.relativeError > 0.0 ? model.limits.relativeError : model.convergence.targetError;
}

PlotCurve estimateOf(const ViewerModel& model, size_t kind) {
    PlotCurve curve{.name = kNames[kind], .color = kColors[kind]};
    for (const ConvergencePoint& p : model.curve(kBoth[kind])->points()) {
        curve.points.push_back({p.renderSeconds, p.relativeError * 100.0, p.relativeErrorLow * 100.0,
                                p.relativeErrorHigh * 100.0});
    }
    return curve;
}

PlotCurve referenceOf(const ViewerModel& model, size_t kind) {
    PlotCurve curve{.name = kNames[kind], .color = kColors[kind], .hasMarkers = true};
    for (const ReferencePoint& p : model.reference.points(kBoth[kind]))
        curve.points.push_back({p.renderSeconds, p.error(model.convergence.metric) * 100.0});
    return curve;
}

/// The curves at 0 and 1 are what is shown of path tracing and of SPPM; estimates behind them may follow.
LogLogPlot plotOf(const ViewerModel& model) {
    LogLogPlot plot{.targetY = targetOf(model) * 100.0, .xTitle = "render time, s"};
    const bool reference = hasReference(model);
    for (size_t kind = 0; kind < kBoth.size(); ++kind)
        plot.curves.push_back(reference ? referenceOf(model, kind) : estimateOf(model, kind));
    plot.yTitle = reference ? "error, %" : "estimated error, %";
    if (model.reference.picture() && !reference) plot.warning = "the reference does not fit: see below";
    plot.nothing = reference ? "measuring…" : "from the second pass on";
    if (!reference || model.convergence.metric != ReferenceMetric::RmseOverMean) return plot;
    for (size_t kind = 0; kind < kBoth.size(); ++kind) {
        plot.curves.push_back(estimateOf(model, kind));
        plot.curves.back().isFaint = true;
    }
    return plot;
}

std::string bandText(double low, double high) {
    return fmt::format("90 %: {} – {}", percent(low), percent(high));
}

std::string passesText(uint32_t passes) {
    return fmt::format("{} {}", grouped(passes), passes == 1 ? "pass" : "passes");
}

/// What one point of plotOf()'s curves says.
std::string pointText(const ViewerModel& model, size_t curve, size_t point) {
    const size_t kind = curve % kBoth.size();
    if (hasReference(model) && curve < kBoth.size()) {
        const ReferencePoint& p = model.reference.points(kBoth[kind])[point];
        return fmt::format("{}: {} after {}, {}", kNames[kind], percent(p.error(model.convergence.metric)),
                           duration(p.renderSeconds), passesText(p.passes));
    }
    const ConvergencePoint& p = model.curve(kBoth[kind])->points()[point];
    std::string text =
        fmt::format("{}{}: {} after {}, {}\n    {}", kNames[kind], curve < kBoth.size() ? "" : ", estimated",
                    percent(p.relativeError), duration(p.renderSeconds), passesText(p.passes),
                    bandText(p.relativeErrorLow, p.relativeErrorHigh));
    if (p.relativeBias > 0.0) text += fmt::format(", bias {}", percent(p.relativeBias));
    return text;
}

void drawPlot(const ViewerModel& model) {
    const LogLogPlot plot = plotOf(model);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 size{ImGui::GetContentRegionAvail().x, kPlotHeightUnits * ui::scale()};
    ImGui::Dummy(size);
    const PlotHover hover =
        drawLogLogPlot(plot, {corner.x, corner.y}, {corner.x + size.x, corner.y + size.y});
    std::string shown;
    for (size_t i = 0; i < hover.size(); ++i) {
        if (hover[i]) shown += (shown.empty() ? "" : "\n") + pointText(model, i, *hover[i]);
    }
    if (!shown.empty()) {
        ui::tooltip(shown.c_str());
    } else {
        for (size_t i = 0; i < kBoth.size(); ++i)
            shown +=
                fmt::format("{}{} {} points", i > 0 ? ", " : "", kNames[i], plot.curves[i].points.size());
    }
    ui::itemArea("Curve", shown);
}

void drawErrors(const ViewerModel& model) {
    const bool reference = hasReference(model);
    for (size_t kind = 0; kind < kBoth.size(); ++kind) {
        const auto& estimates = model.curve(kBoth[kind])->points();
        const auto& measured = model.reference.points(kBoth[kind]);
        if (reference && !measured.empty()) {
            const ReferencePoint& last = measured.back();
            ui::value(
                kNames[kind],
                fmt::format("{}, {}", percent(last.error(model.convergence.metric)), passesText(last.passes)),
                fmt::format("Against the reference. Mean signed difference: {:+.3g} % of its mean",
                            last.relativeBias * 100.0)
                    .c_str());
        } else if (!reference && !estimates.empty()) {
            const ConvergencePoint& last = estimates.back();
            ui::value(kNames[kind],
                      fmt::format("{}  ({} – {})", percent(last.relativeError),
                                  percent(last.relativeErrorLow), percent(last.relativeErrorHigh)),
                      "The estimate and its 90 % band. Light that no path has found yet is not in it");
        }
    }
}

std::string forecastText(const ConvergenceCurve& curve, double target) {
    if (curve.points().back().relativeError <= target) {
        for (const ConvergencePoint& point : curve.points()) {
            if (point.relativeError <= target) return "reached at " + duration(point.renderSeconds);
        }
    }
    const auto forecast = forecastError(curve, target);
    if (!forecast || !std::isfinite(forecast->secondsLeft)) return "not to be told yet";
    const std::string left = "in " + duration(forecast->secondsLeft);
    if (!(forecast->secondsHigh > forecast->secondsLow * 1.02)) return left;
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
    for (size_t kind = 0; kind < kBoth.size(); ++kind) {
        const ConvergenceCurve curve =
            hasReference(*model) ? asCurve(model->reference.points(kBoth[kind]), model->convergence.metric)
                                 : *model->curve(kBoth[kind]);
        if (curve.empty()) continue;
        ui::value(kForecastNames[kind], forecastText(curve, targetOf(*model)),
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
    const std::string mismatch = model.reference.mismatch(size.width, size.height);
    const ReferenceFit& fit = model.referenceFit;
    if (!mismatch.empty() || fit.fits()) return mismatch;
    if (fit.checking()) return "Checking whether the reference shows this scene…";
    return fmt::format(
        "The reference does not fit: {}. {}", fit.difference(),
        fit.useAnyway ? "The errors are measured all the same." : "Until it does, the error is estimated.");
}

void drawOwnError(const LoadedReference& reference) {
    const auto found = reference.attributes.find("referenceRelativeError");
    if (found == reference.attributes.end()) return;
    ui::value("Its own error", percent(std::strtod(found->second.c_str(), nullptr)),
              "RMSE / mean of the reference itself. Errors close to it say little");
}

void drawReferenceState(const ViewerModel& model) {
    const ReferenceErrors& reference = model.reference;
    if (reference.loadError()) warn("Load error", reference.loadError()->format());
    if (!reference.picture()) {
        if (!reference.loading() && !reference.loadError())
            ui::hint(
                "Without a reference the error is estimated. Drop an EXR, HDR or PNG file on the window.");
        return;
    }
    const std::string mismatch = whyUnfit(model);
    ui::value("In use",
              fmt::format("{} × {} px", reference.picture()->image.width, reference.picture()->image.height),
              reference.picture()->path.c_str());
    if (!mismatch.empty()) warn("Mismatch", mismatch);
    drawOwnError(*reference.picture());
    if (reference.picture()->isEightBit)
        warn("Note", "An 8-bit reference knows no values above 1: lamps will seem wrong.");
}

/// It has the right size, and shows something else.
bool isDoubtful(const ViewerModel& model) {
    const Resolution& size = model.draft().resolution;
    const ReferenceFit& fit = model.referenceFit;
    return model.reference.picture() && model.reference.mismatch(size.width, size.height).empty() &&
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
    if ((pressed || entered) && !loading) model->reference.load(model->files.reference);
    ImGui::SameLine();
    if (ui::button("Clear", half, "Back to the estimate")) model->reference.clear();
    drawReferenceState(*model);
    if (isDoubtful(*model))
        ui::toggle("Use anyway", &model->referenceFit.useAnyway,
                   "Measures against it although it seems to show something else");
    int metric = static_cast<int>(model->convergence.metric);
    if (hasReference(*model) &&
        ui::choice(
            "Measured as", &metric, kMetrics,
            "Relative RMSE: root of relMSE. RMSE / mean: what the estimate is of, too; it is drawn behind. "
            "MAPE: mean absolute relative error"))
        model->convergence.metric = static_cast<ReferenceMetric>(metric);
}

void drawExport(ViewerModel* model) {
    ui::gap();
    ui::text("CSV file", &model->files.csv, "convergence.csv", "Every point of the curves, as a table");
    if (ui::button("Export CSV", ui::buttonWidth(1))) model->saveConvergenceCsv();
}

}  // namespace

void drawConvergencePanel(ViewerModel* model) {
    if (!model->hasScene()) return;
    if (!ui::section("Convergence", true, "The error over render time, on logarithmic axes")) return;
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
