// A finished (or interrupted) convergence run and everything that is written about it.
//
// `glint converge` fills it; convergence_files, convergence_charts and convergence_page read it.
#pragma once

#include <string>
#include <vector>

#include "engine/report/convergence_run.h"
#include "engine/report/convergence_summary.h"

namespace glint {

/// Where and how it ran.
struct ConvergenceContext {
    std::string command;  ///< to repeat it
    std::string scene;    ///< its file
    std::string title;
    std::string processor;
    int processors = 0;  ///< that the machine offers
    int threads = 0;     ///< that 0 stands for in the settings
    std::string date;    ///< when it began, UTC
    std::vector<std::string> warnings;
};

struct ConvergenceReport {
    const ConvergenceContext& context;
    const ConvergencePlan& plan;
    const SceneDescription& scene;
    const ReferenceImage& reference;
    const ConvergenceResult& result;
    const ConvergenceSummary& summary;
};

/// What the seconds are: said in every output but the CSV files, which hold numbers only.
constexpr const char* kSecondsMeaning =
    "Seconds are render seconds: the passes alone. Loading, building the scene, adding a pass to the film, "
    "evaluating the error and saving are not in them; taking out noise is, where a variant does.";

/// Everything that a reader has to know before trusting a number: the reference's remarks, marks on variants,
/// interruptions, failures.
std::vector<std::string> reportWarnings(const ConvergenceReport& report);

/// One row for each variant, seed and point: variant, seed, point, passes, seconds and kMeasureNames.
std::string curveCsv(const ConvergenceReport& report);
/// One row for each variant and point: variant, point, passes, seeds, then the mean and standard deviation of
/// the seconds and of each measure as NAME_mean and NAME_sd. What is not known is empty.
std::string summaryCsv(const ConvergenceReport& report);
/// Keys: viewer/commands/README.md. Numbers that JSON cannot hold are null.
std::string summaryJson(const ConvergenceReport& report);

/// "reached", "predicted" ...: the JSON's word.
const char* nameOf(TimeToReach::Kind kind);
/// Three digits, or all before the point: "0.0523", "3180".
std::string secondsText(double seconds);

}  // namespace glint
