// The stability suite's results as one HTML page that needs nothing else.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/stress/stress_suite.h"

namespace glint {

/// The whole page: the rule of the verdicts, a summary by family, and a row for each case with its deviation
/// drawn beside its tolerance. `quick`: says so.
std::string stressHtml(const std::vector<StressResult>& results, bool quick);

/// Whether a file that begins so is such a page.
bool looksLikeStressHtml(std::string_view head);

}  // namespace glint
