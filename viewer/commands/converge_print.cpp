#include "viewer/commands/converge_print.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <unistd.h>

#include "engine/base/console.h"

namespace glint {
namespace {

std::string shortTime(const TimeToReach& time) {
    switch (time.kind) {
        case TimeToReach::Kind::Never:
            return "-";
        case TimeToReach::Kind::Before:
            return "<" + secondsText(time.seconds);
        case TimeToReach::Kind::Measured:
            return secondsText(time.seconds);
        case TimeToReach::Kind::Predicted:
            return "~" + secondsText(time.seconds);
    }
    return "";
}

/// "1.23 %"; "–" where there is none, as beside a black reference.
std::string inPercent(double error) {
    return std::isfinite(error) ? fmt::format("{:.3g} %", 100.0 * error) : "–";
}

void printVariant(const MeasuredVariant& variant, const VariantSummary& summary) {
    const std::string name = variant.variant.name + (summary.sameMethodAsReference ? " *" : "");
    if (summary.points.empty()) {
        put("{:<34}nothing measured\n", name);
        return;
    }
    const SummaryPoint& last = summary.points.back();
    const Spread& error = last.errors[static_cast<size_t>(ErrorMeasure::RelativeError)];
    const std::string slope = summary.fit ? fmt::format("{:.3f} ({:.3f} ... {:.3f})", summary.fit->slope,
                                                        summary.fit->slopeLow, summary.fit->slopeHigh)
                                          : "-";
    put("{:<34}{:>8}{:>9.3g} {:>10}   {:<26}", name, last.passes, last.seconds.mean, inPercent(error.mean),
        slope);
    for (const TimeToReach& time : summary.targets) {
        put("{:>9}", shortTime(time));
    }
    put("\n");
}

bool isSameButDenoised(const MeasuredVariant& noisy, const MeasuredVariant& denoised) {
    std::vector<std::pair<std::string, std::string>> settings = denoised.variant.assignments;
    std::erase_if(settings, [](const auto& each) { return each.first == "denoise"; });
    return !noisy.settings.denoise && noisy.variant.integrator == denoised.variant.integrator &&
           noisy.variant.assignments == settings;
}

/// What taking out the noise gains, at the most passes that both variants have.
void printGain(const ConvergenceReport& report, size_t denoised) {
    const auto& variants = report.result.variants;
    const auto noisy = std::ranges::find_if(
        variants, [&](const MeasuredVariant& each) { return isSameButDenoised(each, variants[denoised]); });
    if (!variants[denoised].settings.denoise || noisy == variants.end()) { return; }
    const std::vector<SummaryPoint>& before =
        report.summary.variants[static_cast<size_t>(noisy - variants.begin())].points;
    const std::vector<SummaryPoint>& after = report.summary.variants[denoised].points;
    for (auto point = after.rbegin(); point != after.rend(); ++point) {
        const auto same = std::ranges::find(before, point->passes, &SummaryPoint::passes);
        if (same == before.end()) { continue; }
        const double from = same->errors[static_cast<size_t>(ErrorMeasure::RelMse)].mean;
        const double to = point->errors[static_cast<size_t>(ErrorMeasure::RelMse)].mean;
        put("{}: relMSE {:.3g} instead of {:.3g} at {} passes, {:.3g} times less\n",
            variants[denoised].variant.name, to, from, point->passes, from / to);
        return;
    }
}

}  // namespace

PartLine::PartLine() : terminal_(isatty(STDERR_FILENO) == 1) {}

void PartLine::begin(const std::string& part) {
    if (!terminal_) { say("{}\n", part); }
}

void PartLine::draw(const std::string& text) {
    if (terminal_) {
        sayOverLine(text);
        drawn_ = true;
    }
}

void PartLine::finish() {
    if (drawn_) {
        sayOverLine("");
        drawn_ = false;
    }
}

void printReport(const ConvergenceReport& report) {
    put("{:<34}{:>8}{:>9} {:>10}   {:<26}", "variant", "passes", "seconds", "error", "slope (95 % interval)");
    for (const double target : kTargetErrors) {
        put("{:>9}", fmt::format("to {:g} %", 100.0 * target));
    }
    put("\n");
    for (size_t i = 0; i < report.result.variants.size(); ++i) {
        printVariant(report.result.variants[i], report.summary.variants[i]);
    }
    for (size_t i = 0; i < report.result.variants.size(); ++i) {
        printGain(report, i);
    }
    put("{}\n", kSecondsMeaning);
    put("seconds to an error: ~ not reached, predicted by the fit; < already at the first measurement\n");
    const ReferenceImage& reference = report.reference;
    if (reference.knowsItsError()) {
        const std::string share =
            std::isfinite(report.summary.floorRatio)
                ? fmt::format(", {:.2g} of the smallest one measured", report.summary.floorRatio)
                : "";
        put("reference: {} by {}, its own error {}{}{}\n", reference.path,
            reference.method.empty() ? "an unknown method" : reference.method,
            inPercent(report.summary.floor), share,
            reference.endedBy.empty() ? "" : fmt::format(" (it ended by {})", reference.endedBy));
    }
    for (const std::string& warning : reportWarnings(report)) {
        put("! {}\n", warning);
    }
}

}  // namespace glint
