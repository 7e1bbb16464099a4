// The stability suite: all cases in order, which of them a filter means, and running them.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/stress/stress_case.h"
#include "engine/stress/stress_verdict.h"

namespace glint {

/// Every case, family by family, from benign to extreme within each.
std::vector<StressCase> stressCases();

/// What is extreme in a family's cases, in a few words: "needles" -> "aspect up to 1e7". Empty: no
/// such family.
std::string_view stressFamilyAbout(std::string_view family);

/// The cases of a family ("scale"), or those whose "family/grade" contains the text; empty: all. Error: none
/// does, naming the nearest family.
Result<std::vector<StressCase>> filterStressCases(const std::vector<StressCase>& cases,
                                                  const std::string& filter);

struct StressResult {
    const StressCase* stressCase = nullptr;
    StressOutcome outcome;
    StressJudgement judgement;
    double seconds = 0.0;

    /// Worse than what is documented as a limit of float.
    bool unexpected() const { return judgement.verdict > stressCase->documented; }
};

/// Runs the cases on effort.threads threads, each case on one of them, and hands out the results in order,
/// each as soon as all before it are there. Error: stopped; the results before are handed out.
Status runStressCases(const std::vector<StressCase>& cases, const StressEffort& effort,
                      const std::function<void(StressResult)>& onResult);

/// Runs one case. A scene that is refused is broken, with the message as its reason. Error: stopped.
Result<StressResult> runStressCase(const StressCase& stressCase, const StressEffort& effort);

}  // namespace glint
