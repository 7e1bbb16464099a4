#include "engine/stress/stress_summary.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace glint {

std::vector<StressFamilySummary> summarizeStress(const std::vector<StressResult>& results) {
    std::vector<StressFamilySummary> families;
    for (const StressResult& result : results) {
        const StressCase& c = *result.stressCase;
        if (families.empty() || families.back().family != c.family) {
            families.push_back({.family = c.family});
        }
        StressFamilySummary& family = families.back();
        ++family.counts[static_cast<int>(result.judgement.verdict)];
        family.unexpected += result.unexpected() ? 1 : 0;
        family.seconds += result.seconds;
        if (result.judgement.verdict == StressVerdict::Ok) {
            family.largestOk = std::max(family.largestOk, std::abs(result.judgement.deviation));
            continue;
        }
        if (!family.firstNotOk.empty()) { family.firstNotOk += "; "; }
        family.firstNotOk += fmt::format("{}: {}", c.grade, stressVerdictName(result.judgement.verdict));
    }
    return families;
}

std::string stressMarkdown(const std::vector<StressResult>& results) {
    std::string text =
        "| family | ok | degraded | broken | largest deviation of the ok ones | not ok |\n"
        "|---|---|---|---|---|---|\n";
    for (const StressFamilySummary& family : summarizeStress(results)) {
        const std::string_view about = stressFamilyAbout(family.family);
        text += fmt::format("| {}{}{} | {} | {} | {} | {:.2g} % | {} |\n", family.family,
                            about.empty() ? "" : ": ", about, family.counts[0], family.counts[1],
                            family.counts[2], 100.0 * family.largestOk,
                            family.firstNotOk.empty() ? "–" : family.firstNotOk);
    }
    return text;
}

std::string stressErrorText(const StressJudgement& judgement) {
    if (!std::isfinite(judgement.deviation)) { return "not a number"; }
    const double percent = 100.0 * judgement.deviation;
    const std::string deviation =
        std::abs(percent) >= 99.5 ? fmt::format("{:+.0f}", percent) : fmt::format("{:+.2g}", percent);
    return fmt::format("{} % ± {:.2g} %", deviation, 100.0 * judgement.halfWidth);
}

std::string stressRuleText() {
    return fmt::format(
        "ok: within its interval (significance {:g}) widened by the case's tolerance ({:g} % unless it says "
        "otherwise), and nothing dropped. broken: surely wrong by more than {:g} %, or more than {:g} of all "
        "samples not finite or negative. degraded: between the two, or noisier than ±{:g} %.",
        kStressSignificance, 100.0 * kStressTolerance, 100.0 * kStressBrokenDeviation, kStressBrokenDrops,
        100.0 * kStressWidestInterval);
}

}  // namespace glint
