// The page is written from top to bottom; each function is one of its parts.
#include "engine/report/convergence_page.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "engine/io/atomic_file.h"
#include "engine/io/image_io.h"
#include "engine/report/convergence_charts.h"
#include "engine/report/html_text.h"

namespace glint {
namespace {

constexpr const char* kStyle = R"(
:root { color-scheme: light dark; --ink: #1b1f24; --soft: #59636e; --paper: #fff; --line: #d5dae0; --tint: #f4f6f8; --warn: #fff4d6; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e4e8ec; --soft: #9aa5b1; --paper: #15181c; --line: #343b43; --tint: #1d2126; --warn: #3a3013; }
  svg { filter: invert(0.92) hue-rotate(180deg); }
}
body { margin: 0 auto; padding: 1.5rem; max-width: 76rem; background: var(--paper); color: var(--ink);
  font: 15px/1.5 Roboto, "DejaVu Sans", Arial, sans-serif; }
h1 { font-size: 1.5rem; margin: 0 0 .2rem; } h2 { font-size: 1.1rem; margin: 2rem 0 .5rem; }
p { margin: .3rem 0; } .soft { color: var(--soft); } code { font-size: .9em; overflow-wrap: anywhere; }
.warn { background: var(--warn); border-radius: 6px; padding: .6rem 1rem; margin: 1rem 0; }
.warn ul { margin: 0; padding-left: 1.1rem; }
.scroll { overflow-x: auto; } table { border-collapse: collapse; white-space: nowrap; font-variant-numeric: tabular-nums; }
th, td { padding: .3rem .7rem; text-align: right; border-bottom: 1px solid var(--line); }
th { font-weight: 600; background: var(--tint); } th:first-child, td:first-child { text-align: left; }
svg { max-width: 100%; height: auto; display: block; border-radius: 6px; }
svg polygon:hover { stroke: #000; stroke-width: 2; }
.charts { display: grid; grid-template-columns: repeat(auto-fit, minmax(20rem, 1fr)); gap: 1rem; }
.pictures { display: flex; flex-wrap: wrap; gap: 1rem; }
figure { margin: 0; max-width: 22.5rem; } figure img { width: 100%; display: block; border-radius: 4px; image-rendering: pixelated; }
figcaption { font-size: .85rem; color: var(--soft); } h3 { font-size: 1rem; margin: 1rem 0 .4rem; }
.ramp { display: inline-block; width: 10rem; height: .8em; vertical-align: middle; border-radius: 3px; }
)";

std::string percent(double share) {
    return std::isfinite(share) ? fmt::format("{:.3g} %", 100.0 * share) : "–";
}
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

/// Box-filtered down by a whole factor, in display values.
Image8 reduced(const Image8& image, int factor) {
    Image8 out{image.width / factor, image.height / factor, {}};
    for (int y = 0; y < out.height; ++y) {
        for (int x = 0; x < 3 * out.width; ++x) {
            int sum = 0;
            for (int k = 0; k < factor * factor; ++k) {
                const int row = y * factor + k / factor, column = x / 3 * factor + k % factor;
                sum += image.rgb[3 * (static_cast<size_t>(row) * static_cast<size_t>(image.width) +
                                      static_cast<size_t>(column)) +
                                 static_cast<size_t>(x % 3)];
            }
            out.rgb.push_back(static_cast<uint8_t>(sum / (factor * factor)));
        }
    }
    return out;
}

class Page {
  public:
    Page(const ConvergenceReport& report, const std::string& folder, const PictureLegend& legend)
        : report_(report), folder_(folder), legend_(legend) {}

    std::string write() {
        const ConvergenceContext& context = report_.context;
        const std::string title = htmlText(context.title.empty() ? context.scene : context.title);
        std::string out = fmt::format(
            "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
            "content=\"width=device-width, initial-scale=1\">\n<title>Error against render time: {}</title>\n"
            "<style>{}</style>\n</head>\n<body>\n",
            title, kStyle);
        out += fmt::format(
            "<h1>Error against render time: {}</h1>\n<p class=\"soft\">{}, {}x{} pixels · {}, {} "
            "threads · Glint {} · {}</p>\n",
            title, htmlText(context.scene), report_.scene.resolution.width, report_.scene.resolution.height,
            htmlText(context.processor), context.threads, GLINT_VERSION, htmlText(context.date));
        out += warnings() + chartSvg(errorChart(report_, ErrorMeasure::RelativeError)) + speedTable() +
               metricsTable() + moreCharts() + pictures() + reference() + method();
        return out + "</body>\n</html>\n";
    }

  private:
    std::string nameOf(size_t index) const {
        return htmlText(report_.result.variants[index].variant.name) +
               (report_.summary.variants[index].sameMethodAsReference ? " *" : "");
    }

    std::string warnings() const {
        std::string items;
        for (const std::string& warning : reportWarnings(report_)) {
            items += fmt::format("<li>{}</li>\n", htmlText(warning));
        }
        return items.empty() ? "" : "<div class=\"warn\"><ul>\n" + items + "</ul></div>\n";
    }

    std::string speedTable() const {
        std::vector<std::string> head = {"variant",        "passes", "seconds",
                                         "relative error", "slope",  "95 % interval"};
        for (const double target : kTargetErrors) {
            head.push_back(fmt::format("time to {:g} %", 100.0 * target));
        }
        for (const char* name : {"variance", "bias²", "efficiency", "relative"}) {
            head.emplace_back(name);
        }
        std::string rows = row(head, "th");
        for (size_t i = 0; i < report_.summary.variants.size(); ++i) {
            rows += speedRow(i);
        }
        return "<h2>How fast</h2>\n" + table(rows) +
               "<p class=\"soft\">(…): not reached, predicted by the fit from the last point. Times below "
               "the "
               "reference's own error are struck through. Efficiency: 1 / (variance · seconds) at the last "
               "point; relative: to the first variant's.</p>\n";
    }

    std::string speedRow(size_t index) const {
        const VariantSummary& summary = report_.summary.variants[index];
        if (summary.points.empty()) {
            return row({nameOf(index), "nothing measured"});
        }
        const SummaryPoint& last = summary.points.back();
        const Spread& error = last.errors[static_cast<size_t>(ErrorMeasure::RelativeError)];
        std::vector<std::string> cells = {
            nameOf(index),
            fmt::to_string(last.passes),
            figures(last.seconds.mean),
            percent(error.mean) + (last.seeds > 1 ? " ± " + percent(error.deviation) : ""),
            summary.fit ? fmt::format("{:.3f}", summary.fit->slope) : "–",
            summary.fit ? fmt::format("{:.3f} … {:.3f}", summary.fit->slopeLow, summary.fit->slopeHigh)
                        : "–"};
        for (size_t t = 0; t < kTargetErrors.size(); ++t) {
            const std::string text = timeText(summary.targets[t]);
            cells.push_back(kTargetErrors[t] < report_.summary.floor ? "<s>" + text + "</s>" : text);
        }
        for (const double value :
             {summary.variance, summary.biasSquared, summary.efficiency, summary.relativeEfficiency}) {
            cells.push_back(figures(value));
        }
        return row(cells);
    }

    static std::string timeText(const TimeToReach& time) {
        switch (time.kind) {
            case TimeToReach::Kind::Never:
                return "not reached";
            case TimeToReach::Kind::Before:
                return fmt::format("&lt; {:.3g} s", time.seconds);
            case TimeToReach::Kind::Measured:
                return fmt::format("{:.3g} s", time.seconds);
            case TimeToReach::Kind::Predicted:
                return fmt::format(
                    "<span title=\"{:.3g} to {:.3g} s by the slope's interval\">({:.3g} s)</span>", time.low,
                    time.high, time.seconds);
        }
        return "";
    }

    std::string metricsTable() const {
        std::vector<std::string> head = {"variant"};
        for (const MeasureName& name : kMeasureNames) {
            head.push_back(
                fmt::format("{}{}", name.title,
                            name.unit.empty() ? "" : fmt::format("<br><small>{}</small>", name.unit)));
        }
        std::string rows = row(head, "th");
        for (size_t i = 0; i < report_.summary.variants.size(); ++i) {
            if (report_.summary.variants[i].points.empty()) {
                continue;
            }
            const SummaryPoint& last = report_.summary.variants[i].points.back();
            std::vector<std::string> cells = {nameOf(i)};
            for (size_t m = 0; m < kErrorMeasureCount; ++m) {
                const auto measure = static_cast<ErrorMeasure>(m);
                cells.push_back(fmt::format("{}<br><small>± {}</small>",
                                            measureText(measure, last.errors[m].mean),
                                            measureText(measure, last.errors[m].deviation)));
            }
            rows += row(cells);
        }
        return "<h2>All measures at the last point</h2>\n" + table(rows) +
               "<p class=\"soft\">Mean and standard deviation over the seeds. Every point is in curve.csv "
               "and "
               "summary.csv.</p>\n";
    }

    std::string moreCharts() const {
        std::string out = "<h2>Other measures</h2>\n<div class=\"charts\">\n";
        for (const ErrorMeasure measure : {ErrorMeasure::RelMse, ErrorMeasure::Mape, ErrorMeasure::Flip}) {
            LogLogChart chart = errorChart(report_, measure);
            chart.title = kMeasureNames[static_cast<size_t>(measure)].title;
            chart.subtitle.clear();
            chart.note.clear();
            chart.width = 480;
            chart.height = 380;
            out += chartSvg(chart);
        }
        return out + "</div>\n";
    }

    /// An <img> with the picture inside, or nothing.
    std::string image(const std::string& file, const std::string& about) const {
        const std::string path = (std::filesystem::path(folder_) / file).string();
        Result<std::string> bytes = readFile(path);
        if (!bytes) {
            return {};
        }
        const int width = report_.scene.resolution.width;
        if (width > kMostPagePixels) {
            const auto whole = loadImage8(path);
            const std::string small = path + ".small.png";
            const int factor = (width + kMostPagePixels - 1) / kMostPagePixels;
            if (whole && (*whole)->height >= factor && savePng(small, reduced(**whole, factor))) {
                Result<std::string> fewer = readFile(small);
                bytes = fewer ? std::move(fewer) : std::move(bytes);
            }
            std::error_code ignored;
            std::filesystem::remove(small, ignored);
        }
        return fmt::format("<img alt=\"{0}\" title=\"{0}\" src=\"data:image/png;base64,{1}\">",
                           htmlText(about), base64(*bytes));
    }

    std::string figure(const std::string& file, const std::string& caption) const {
        const std::string picture = image(file, caption);
        return picture.empty() ? ""
                               : fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n", picture,
                                             htmlText(caption));
    }

    std::string pictures() const {
        std::string out = fmt::format(
            "<h2>Pictures of the first seed, and where they are wrong</h2>\n<p class=\"soft\">Error maps: "
            "relative "
            "squared error, logarithmic from {:.0e} (dark) to {:.0e} (bright), the same for all.</p>\n"
            "<h3>Reference</h3>\n<div class=\"pictures\">\n",
            legend_.low, legend_.high);
        out += figure("pictures/reference.png", "the reference");
        if (report_.reference.knowsItsError()) {
            out += figure("pictures/reference-error.png", "its own squared standard error");
        }
        out += "</div>\n";
        for (size_t i = 0; i < report_.result.variants.size(); ++i) {
            const MeasuredVariant& variant = report_.result.variants[i];
            std::string figuresOf;
            for (const KeptPicture& kept : variant.pictures) {
                const MeasuredPoint& point = variant.curves.front().points[kept.point];
                const std::string when = fmt::format("{:.3g} s, {} passes", point.seconds, point.passes);
                figuresOf += figure(kept.file, when);
                figuresOf += figure(
                    kept.errorFile,
                    fmt::format("relative error {}", percent(at(point.errors, ErrorMeasure::RelativeError))));
            }
            if (!figuresOf.empty()) {
                out += fmt::format("<h3>{}</h3>\n<div class=\"pictures\">\n{}</div>\n", nameOf(i), figuresOf);
            }
        }
        return out;
    }

    std::string reference() const {
        const ReferencePicture& r = report_.reference;
        std::string out = fmt::format("<h2>The reference</h2>\n<p><code>{}</code>, by {}", htmlText(r.path),
                                      r.method.empty() ? "an unknown method" : htmlText(r.method));
        if (r.renderSeconds > 0.0) {
            out += fmt::format(" in {:.3g} s", r.renderSeconds);
        }
        if (r.passes > 0) {
            out += fmt::format(", {} passes", r.passes);
        }
        if (!r.seeds.empty()) {
            out += fmt::format(", seeds {}", fmt::join(r.seeds, ", "));
        }
        out += r.cached ? ", from an earlier run.</p>\n" : ".</p>\n";
        if (!r.knowsItsError()) {
            return out;
        }
        return out + fmt::format(
                         "<p>Its own relative error is {}: {:.2g} of the smallest error measured. It adds "
                         "{:.3g} to every MSE{}.</p>\n",
                         percent(report_.summary.floor), report_.summary.floorRatio, r.mse,
                         report_.summary.withoutReference
                             ? ", which is subtracted in the first chart, the fits and the times"
                             : "; the column “MSE − reference” is without it");
    }

    std::string method() const {
        return fmt::format(
            "<h2>How it was measured</h2>\n<p>{}</p>\n<p>Each variant and seed starts from cold, on the same "
            "threads. The first seed stops at about logarithmically spaced seconds, the others after the "
            "same "
            "passes. Seeds: {}.</p>\n<p>Relative error: RMSE over the mean of the reference. Slope: least "
            "squares "
            "on log-log axes for each seed; its interval is Student’s over the seeds (with one seed that of "
            "the "
            "regression, which is too narrow). Points whose MSE is less than {:g} times the reference’s own "
            "are "
            "left out of fits. Bias²: MSE of the mean of the seeds’ pictures, less variance / seeds, less "
            "the "
            "reference’s own; noise can make it negative.</p>\n<p>To repeat it: <code>{}</code></p>\n",
            kSecondsMeaning, fmt::join(report_.plan.seeds, ", "), kFitMargin,
            htmlText(report_.context.command));
    }

    const ConvergenceReport& report_;
    const std::string& folder_;
    const PictureLegend& legend_;
};

}  // namespace

std::string convergencePage(const ConvergenceReport& report, const std::string& folder,
                            const PictureLegend& legend) {
    return Page(report, folder, legend).write();
}

}  // namespace glint
