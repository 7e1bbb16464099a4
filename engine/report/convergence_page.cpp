// The page is written from top to bottom; each function is one of its parts.
#include "engine/report/convergence_page.h"

#include <fmt/format.h>

#include "engine/report/convergence_charts.h"
#include "engine/report/convergence_page_parts.h"
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
svg polygon:has(title):hover { stroke: #000; stroke-width: 2; }
.charts { display: grid; grid-template-columns: repeat(auto-fit, minmax(28rem, 1fr)); gap: 1rem; }
.pictures { display: flex; flex-wrap: wrap; gap: 1rem; }
figure { margin: 0; width: 15rem; } figure img { width: 100%; display: block; border-radius: 4px; image-rendering: pixelated; }
figcaption { font-size: .85rem; color: var(--soft); } h3 { font-size: 1rem; margin: 1rem 0 .4rem; }
.ramp { display: inline-block; width: 10rem; height: .8em; vertical-align: middle; border-radius: 3px; }
)";

class Page {
  public:
    Page(const ConvergenceReport& report, const std::string& folder, const ImageLegend& legend)
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
        out += warnings() + chartSvg(errorChart(report_, ErrorMeasure::RelativeError)) +
               pageSpeedTable(report_) + pageMetricsTable(report_) + moreCharts() +
               pageImages(report_, folder_, legend_) + reference() + method();
        return out + "</body>\n</html>\n";
    }

  private:
    std::string warnings() const {
        std::string items;
        for (const std::string& warning : reportWarnings(report_)) {
            items += fmt::format("<li>{}</li>\n", htmlText(warning));
        }
        return items.empty() ? "" : "<div class=\"warn\"><ul>\n" + items + "</ul></div>\n";
    }

    std::string moreCharts() const {
        std::string out = "<h2>Other measures</h2>\n<div class=\"charts\">\n";
        for (const ErrorMeasure measure :
             {ErrorMeasure::PictureError, ErrorMeasure::RelMse, ErrorMeasure::RelMseTrimmed,
              ErrorMeasure::Mape, ErrorMeasure::Flip}) {
            LogLogChart chart = errorChart(report_, measure);
            chart.title = kMeasureNames[static_cast<size_t>(measure)].title;
            chart.subtitle.clear();
            chart.note.clear();
            chart.width = 640;
            chart.height = 400;
            out += chartSvg(chart);
        }
        return out + "</div>\n";
    }

    std::string reference() const {
        const ReferenceImage& r = report_.reference;
        std::string out = fmt::format("<h2>The reference</h2>\n<p><code>{}</code>, by {}", htmlText(r.path),
                                      r.method.empty() ? "an unknown method" : htmlText(r.method));
        if (r.renderSeconds > 0.0) { out += fmt::format(" in {:.3g} s", r.renderSeconds); }
        if (r.passes > 0) { out += fmt::format(", {} passes", r.passes); }
        if (!r.seeds.empty()) { out += fmt::format(", seeds {}", fmt::join(r.seeds, ", ")); }
        if (!r.endedBy.empty()) {
            out += r.endedBy == "precision" ? "; it was precise enough"
                   : r.endedBy == "time"    ? "; its time was up"
                                            : "; it was interrupted";
        }
        out += r.cached ? "; from an earlier run.</p>\n" : ".</p>\n";
        if (!r.knowsItsError()) { return out; }
        return out + fmt::format(
                         "<p>Its own relative error is {}: {:.2g} of the smallest error measured. It adds "
                         "{:.3g} to every MSE{}.</p>\n",
                         pagePercent(report_.summary.floor), report_.summary.floorRatio, r.mse,
                         report_.summary.withoutReference
                             ? ", which is subtracted in the first chart, the fits and the times"
                             : "; the column “MSE − reference” is without it");
    }

    std::string method() const {
        constexpr const char* kText =
            "<h2>How it was measured</h2>\n<p>{}</p>\n"
            "<p>Each variant and seed starts from cold, on the same threads. The first seed stops at about\n"
            "logarithmically spaced seconds, the others after the same passes. Seeds: {}.</p>\n"
            "<p>Relative error: RMSE over the mean of the reference. Slope: least squares on log-log axes "
            "over\n"
            "the last tenfold of time, for each seed; its interval is Student’s over the seeds (with one "
            "seed\n"
            "that of the regression, which is too narrow). Points whose MSE is less than {:g} times the\n"
            "reference’s own are left out of fits. Bias²: MSE of the mean of the seeds’ pictures, less\n"
            "variance / seeds, less the reference’s own; noise can make it negative.</p>\n"
            "<p>To repeat it: <code>{}</code></p>\n";
        return fmt::format(kText, kSecondsMeaning, fmt::join(report_.plan.seeds, ", "), kFitMargin,
                           htmlText(report_.context.command));
    }

    const ConvergenceReport& report_;
    const std::string& folder_;
    const ImageLegend& legend_;
};

}  // namespace

std::string convergencePage(const ConvergenceReport& report, const std::string& folder,
                            const ImageLegend& legend) {
    return Page(report, folder, legend).write();
}

}  // namespace glint
