// Plain HTML with its style inside: no script, no link, no font from elsewhere.
#include "engine/stress/stress_html.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "engine/report/html_text.h"
#include "engine/stress/stress_summary.h"

namespace glint {
namespace {

constexpr const char* kStyle = R"(
body { font: 15px/1.5 system-ui, sans-serif; color: #1d2733; background: #fff; margin: 2rem auto; max-width: 75rem; padding: 0 1rem }
h1 { font-size: 1.5rem; margin-bottom: .2rem } h2 { font-size: 1.1rem; margin: 2rem 0 .2rem } p { margin: .3rem 0; color: #4a5866 }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums }
th { text-align: left; font-weight: 600; border-bottom: 2px solid #c8d1da; padding: .25rem .6rem }
td { border-bottom: 1px solid #e4e9ee; padding: .25rem .6rem; vertical-align: top } td.n, th.n { text-align: right } td.n { white-space: nowrap }
td:first-child { white-space: nowrap } .short { width: auto } th.v, td.v { width: 24% } th.e { width: 22% } th.d { width: 6rem }
tr.ok td.v { color: #14713d } .degraded { color: #8a5a00; background: #fff6dc } .broken { color: #b3261e; background: #fdebe9 }
td.v { font-weight: 600 } small { color: #4a5866; font-weight: 400 } svg { display: block }
@media (prefers-color-scheme: dark) { body { color: #dde5ec; background: #14191f } p, small { color: #9fb0bf }
th { border-color: #3a4754 } td { border-color: #28323c } tr.ok td.v { color: #6fd39b } .degraded { color: #f0c25e; background: #2e2716 } .broken { color: #ff9d94; background: #361b1a } }
)";

/// Place on a logarithmic axis from 1e-6 to 1, in pixels.
double logPlace(double value) {
    constexpr double kPixelsPerDecade = 20.0;
    return std::clamp((std::log10(std::max(value, 1e-6)) + 6.0) * kPixelsPerDecade, 0.0, 120.0);
}

/// The deviation as a bar that ends at |deviation|, with its interval's upper end and the tolerance as ticks.
std::string bar(const StressResult& result) {
    const StressJudgement& j = result.judgement;
    if (!std::isfinite(j.deviation)) { return ""; }
    const double size = std::abs(j.deviation);
    return fmt::format(
        R"(<svg width="122" height="14" role="img" aria-label="deviation"><rect y="4" width="{:.1f}" height="6" fill="currentColor" opacity=".55"/><path d="M{:.1f} 2v10" stroke="currentColor"/><path d="M{:.1f} 0v14" stroke="#3a7bd5" stroke-dasharray="2 2"/></svg>)",
        logPlace(size), logPlace(size + j.halfWidth), logPlace(result.stressCase->tolerance));
}

std::string row(const StressResult& result) {
    const StressCase& c = *result.stressCase;
    const StressJudgement& j = result.judgement;
    const char* verdict = stressVerdictName(j.verdict);
    std::string remark = htmlText(j.reason);
    if (!c.limit.empty()) {
        remark += (remark.empty() ? "" : "<br>") + ("known limit: " + htmlText(c.limit));
    }
    if (!remark.empty()) { remark = "<br><small>" + remark + "</small>"; }
    return fmt::format(
        "<tr class=\"{}\"><td>{}</td><td>{}</td><td class=\"n\">{}</td><td>{}</td><td class=\"n\">{:g} %</td>"
        "<td class=\"n\">{}</td><td class=\"v\">{}{}</td><td class=\"n\">{:.2f}</td></tr>\n",
        verdict, htmlText(c.grade), htmlText(c.extreme), stressErrorText(j), bar(result), 100.0 * c.tolerance,
        result.outcome.dropped(), verdict, remark, result.seconds);
}

std::string summaryTable(const std::vector<StressResult>& results) {
    std::string text =
        "<table class=\"short\"><tr><th>family</th><th class=\"n\">ok</th><th class=\"n\">degraded</th>"
        "<th class=\"n\">broken</th><th>not ok</th></tr>\n";
    for (const StressFamilySummary& f : summarizeStress(results)) {
        text += fmt::format(
            "<tr><td><a href=\"#{}\">{}</a></td><td class=\"n\">{}</td><td class=\"n\">{}</td>"
            "<td class=\"n\">{}</td><td>{}</td></tr>\n",
            htmlText(f.family), htmlText(f.family), f.counts[0], f.counts[1], f.counts[2],
            htmlText(f.firstNotOk));
    }
    return text + "</table>\n";
}

}  // namespace

std::string stressHtml(const std::vector<StressResult>& results, bool quick) {
    std::string page = fmt::format(
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
        "content=\"width=device-width\"><title>Glint: numerical "
        "stability</title><style>{}</style></head><body>\n"
        "<h1>Numerical stability</h1>\n<p><code>glint stress{}</code>, Glint " GLINT_VERSION
        ": {} cases.</p>\n<p>{} "
        "Bars are deviations on a logarithmic axis from 10<sup>-6</sup> to 1; the tick is the interval's "
        "end, the "
        "dashed line the tolerance.</p>\n",
        kStyle, quick ? " --quick" : "", results.size(), htmlText(stressRuleText()));
    page += summaryTable(results);
    std::string family;
    std::string truth;
    for (const StressResult& result : results) {
        const StressCase& c = *result.stressCase;
        if (c.family != family || c.truth != truth) {
            if (!family.empty()) { page += "</table>\n"; }
            const std::string anchor = c.family != family ? " id=\"" + htmlText(c.family) + "\"" : "";
            const std::string_view about = c.family != family ? stressFamilyAbout(c.family) : "";
            page += fmt::format(
                "<h2{}>{}</h2>\n<p>Truth: {}.</p>\n<table><tr><th>case</th><th class=\"e\">what is "
                "extreme</th>"
                "<th class=\"n\">error</th><th>10<sup>-6</sup> … 1</th><th class=\"n\">tolerance</th>"
                "<th class=\"n d\">not finite or negative</th><th class=\"v\">verdict</th><th "
                "class=\"n\">s</th></tr>\n",
                anchor, htmlText(c.family + (about.empty() ? "" : ": " + std::string(about))),
                htmlText(c.truth));
            family = c.family;
            truth = c.truth;
        }
        page += row(result);
    }
    if (!family.empty()) { page += "</table>\n"; }
    return page + "</body></html>\n";
}

bool looksLikeStressHtml(std::string_view head) {
    return head.starts_with("<!doctype html>") &&
           head.find("<title>Glint: numerical") != std::string_view::npos;
}

}  // namespace glint
