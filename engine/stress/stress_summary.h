// The stability suite's results family by family, for the README and the end of a run.
#pragma once

#include <string>
#include <vector>

#include "engine/stress/stress_suite.h"

namespace glint {

struct StressFamilySummary {
    std::string family;
    int counts[3] = {};        ///< by StressVerdict
    int unexpected = 0;        ///< worse than documented
    double largestOk = 0.0;    ///< largest deviation of the cases that are ok
    std::string firstNotOk{};  ///< grades that are not ok, separated by "; "
    double seconds = 0.0;
};

std::vector<StressFamilySummary> summarizeStress(const std::vector<StressResult>& results);

/// A Markdown table with a row for each family.
std::string stressMarkdown(const std::vector<StressResult>& results);

/// "-0.12 % ± 0.05 %", "0", "not a number".
std::string stressErrorText(const StressJudgement& judgement);

/// What ok, degraded and broken mean, in two sentences with the rule's numbers.
std::string stressRuleText();

}  // namespace glint
