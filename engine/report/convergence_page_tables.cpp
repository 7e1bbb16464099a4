// The page's two tables.
#include <cmath>

#include <fmt/format.h>

#include "engine/report/convergence_charts.h"
#include "engine/report/convergence_page_parts.h"
#include "engine/report/html_text.h"

namespace glint {
namespace {

std::string figures(double value) { return std::isfinite(value) ? fmt::format("{:.3g}", value) : "–"; }

std::string row(const std::vector<std::string>& cells, const char* tag = "td") {
    std::string out = "<tr>";
    for (const std::string& cell : cells) {
        out += fmt::format("<{0}>{1}</{0}>", tag, cell);
    }
    return out + "</tr>\n";
}

std::string table(const std::string& rows) {
    return "<div class=\"scroll\"><table>\n" + rows + "</table></div>\n";
}

std::string timeText(const TimeToReach& time) {
    switch (time.kind) {
        case TimeToReach::Kind::Never:
            return "not reached";
        case TimeToReach::Kind::Before:
            return fmt::format("&lt; {} s", secondsText(time.seconds));
        case TimeToReach::Kind::Measured:
            return secondsText(time.seconds) + " s";
        case TimeToReach::Kind::Predicted:
            return fmt::format("<span title=\"{} to {} s by the slope’s interval\">({} s)</span>",
                               secondsText(time.low), secondsText(time.high), secondsText(time.seconds));
    }
    return "";
}

std::string speedRow(const ConvergenceReport& report, size_t index) {
    const VariantSummary& summary = report.summary.variants[index];
    if (summary.points.empty()) { return row({pageName(report, index), "nothing measured"}); }
    const SummaryPoint& last = summary.points.back();
    const Spread& error = last.errors[static_cast<size_t>(ErrorMeasure::RelativeError)];
    std::vector<std::string> cells = {
        pageName(report, index), fmt::to_string(last.passes), secondsText(last.seconds.mean),
        pagePercent(error.mean) + (last.seeds > 1 ? " ± " + pagePercent(error.deviation) : ""),
        summary.fit ? fmt::format("{:.3f} ({:.3f} … {:.3f})", summary.fit->slope, summary.fit->slopeLow,
                                  summary.fit->slopeHigh)
                    : "–"};
    for (size_t t = 0; t < kTargetErrors.size(); ++t) {
        const std::string text = timeText(summary.targets[t]);
        cells.push_back(kTargetErrors[t] < report.summary.floor ? "<s>" + text + "</s>" : text);
    }
    return row(cells);
}

std::string labelled(std::string_view title, std::string_view unit) {
    return unit.empty() ? std::string(title) : fmt::format("{} <small>({})</small>", title, unit);
}

template <class TextOf>
std::string variantRow(const ConvergenceReport& report, const std::string& title, TextOf textOf) {
    std::vector<std::string> cells = {title};
    for (const VariantSummary& variant : report.summary.variants) {
        cells.push_back(variant.points.empty() ? "–" : textOf(variant));
    }
    return row(cells);
}

}  // namespace

std::string pagePercent(double share) {
    return std::isfinite(share) ? fmt::format("{:.3g} %", 100.0 * share) : "–";
}

std::string pageName(const ConvergenceReport& report, size_t variant) {
    return htmlText(report.result.variants[variant].variant.name) +
           (report.summary.variants[variant].sameMethodAsReference ? " *" : "");
}

std::string pageSpeedTable(const ConvergenceReport& report) {
    std::vector<std::string> head = {"variant", "passes", "seconds", "relative error",
                                     "slope (95 % interval)"};
    for (const double target : kTargetErrors) {
        head.push_back(fmt::format("time to {:g} %", 100.0 * target));
    }
    std::string rows = row(head, "th");
    for (size_t i = 0; i < report.summary.variants.size(); ++i) {
        rows += speedRow(report, i);
    }
    return "<h2>How fast</h2>\n" + table(rows) +
           "<p class=\"soft\">(…): not reached, predicted by the fit from the last point. Errors below "
           "the "
           "reference’s own are struck through: they cannot be told from it.</p>\n";
}

std::string pageMetricsTable(const ConvergenceReport& report) {
    std::vector<std::string> head = {"at the last point"};
    for (size_t i = 0; i < report.summary.variants.size(); ++i) {
        head.push_back(pageName(report, i));
    }
    std::string rows = row(head, "th");
    for (size_t m = 0; m < kErrorMeasureCount; ++m) {
        const auto measure = static_cast<ErrorMeasure>(m);
        const MeasureName& name = kMeasureNames[m];
        rows += variantRow(report, labelled(name.title, name.unit), [&](const VariantSummary& variant) {
            const Spread& spread = variant.points.back().errors[m];
            return measureText(measure, spread.mean) + " <small>± " + measureText(measure, spread.deviation) +
                   "</small>";
        });
    }
    rows += variantRow(report, labelled("variance", "radiance²"),
                       [](const auto& v) { return figures(v.variance); });
    rows += variantRow(report, labelled("bias²", "radiance²"),
                       [](const auto& v) { return figures(v.biasSquared); });
    rows += variantRow(report, labelled("efficiency", "1/(radiance² s)"),
                       [](const auto& v) { return figures(v.efficiency); });
    rows += variantRow(report, "relative efficiency",
                       [](const auto& v) { return figures(v.relativeEfficiency); });
    return "<h2>All measures</h2>\n" + table(rows) +
           "<p class=\"soft\">Mean and standard deviation over the seeds. Efficiency: 1 / (variance · "
           "seconds); relative: to the first variant’s. Every point is in curve.csv and "
           "summary.csv.</p>\n";
}

}  // namespace glint
