// `glint stress`: the numerical stability suite as a table, with exit codes for automatic runs.
#include <atomic>
#include <thread>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "engine/base/console.h"
#include "engine/io/atomic_file.h"
#include "engine/stress/stress_html.h"
#include "engine/stress/stress_suite.h"
#include "engine/stress/stress_summary.h"
#include "viewer/base/interrupt.h"
#include "viewer/base/run_files.h"
#include "viewer/bench/measuring.h"
#include "viewer/commands/command_line.h"
#include "viewer/commands/commands.h"
#include "viewer/commands/json_output.h"
#include "viewer/commands/measuring_program.h"

namespace glint {
namespace {

struct StressOptions {
    std::string filter;
    std::string html;
    std::string json;
    bool quick = false;
    bool list = false;
    bool summary = false;
    int threads = 0;
};

/// Raises a flag for the running case when the user interrupts.
class InterruptWatch {
  public:
    InterruptWatch()
        : thread_([this](const std::stop_token& done) {
              while (!done.stop_requested()) {
                  if (guard_.interrupted()) { stop = true; }
                  std::this_thread::sleep_for(std::chrono::milliseconds(20));
              }
          }) {}

    std::atomic<bool> stop{false};

  private:
    InterruptGuard guard_;
    std::jthread thread_;
};

void printHeading(const StressCase& c, std::string* last) {
    const std::string heading = c.family + ": truth: " + c.truth;
    if (heading == *last) { return; }
    put("\n{}\n", heading);
    *last = heading;
}

void printList(const std::vector<StressCase>& cases) {
    std::string heading;
    for (const StressCase& c : cases) {
        printHeading(c, &heading);
        put("  {:<36} {}{}\n", c.grade, c.extreme, c.quick ? "" : " (not in --quick)");
    }
    put("\n{} cases\n", cases.size());
}

void printRow(const StressResult& result) {
    const StressCase& c = *result.stressCase;
    const bool known = result.judgement.verdict != StressVerdict::Ok && !result.unexpected();
    std::string remark = result.judgement.reason;
    if (known) { remark += ", a documented limit"; }
    put("  {:<32} {:<72} {:>22} {:>8} {:<9}{}\n", c.grade, c.extreme, stressErrorText(result.judgement),
        result.outcome.dropped(), stressVerdictName(result.judgement.verdict),
        remark.empty() ? "" : " " + remark);
    std::fflush(stdout);
}

nlohmann::ordered_json jsonRow(const StressResult& result) {
    const StressCase& c = *result.stressCase;
    const auto fault = [&](SampleFault f) { return result.outcome.faults[static_cast<size_t>(f)]; };
    return {{"family", c.family},
            {"grade", c.grade},
            {"extreme", c.extreme},
            {"truth", c.truth},
            {"deviation", result.judgement.deviation},
            {"half_width", result.judgement.halfWidth},
            {"tolerance", c.tolerance},
            {"samples", result.outcome.samples},
            {"dropped",
             {{"not_a_number", fault(SampleFault::NotANumber)},
              {"infinite", fault(SampleFault::Infinite)},
              {"negative", fault(SampleFault::Negative)}}},
            {"verdict", stressVerdictName(result.judgement.verdict)},
            {"reason", result.judgement.reason},
            {"documented", stressVerdictName(c.documented)},
            {"limit", c.limit},
            {"unexpected", result.unexpected()},
            {"seconds", result.seconds}};
}

nlohmann::ordered_json jsonReport(const std::vector<StressResult>& results, const StressOptions& options) {
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    int counts[3] = {};
    int unexpected = 0;
    for (const StressResult& result : results) {
        rows.push_back(jsonRow(result));
        ++counts[static_cast<int>(result.judgement.verdict)];
        unexpected += result.unexpected() ? 1 : 0;
    }
    return {{"quick", options.quick}, {"significance", kStressSignificance},
            {"ok", counts[0]},        {"degraded", counts[1]},
            {"broken", counts[2]},    {"unexpected", unexpected},
            {"cases", rows}};
}

void printEnd(const std::vector<StressResult>& results) {
    double seconds = 0.0;
    int counts[3] = {};
    int unexpected = 0;
    for (const StressResult& result : results) {
        seconds += result.seconds;
        ++counts[static_cast<int>(result.judgement.verdict)];
        unexpected += result.unexpected() ? 1 : 0;
    }
    put("\n{}\n{} ok, {} degraded, {} broken; {} worse than documented; {:.0f} s\n", stressRuleText(),
        counts[0], counts[1], counts[2], unexpected, seconds);
}

/// Runs the cases and prints each as it ends. False: interrupted.
bool runCases(const std::vector<StressCase>& cases, const StressOptions& options, InterruptWatch* watch,
              std::vector<StressResult>* results) {
    const bool silent = jsonTakesOutput(options.json);
    const StressEffort effort{options.quick, options.threads, &watch->stop};
    std::string heading;
    const Status done = runStressCases(cases, effort, [&](StressResult result) {
        results->push_back(std::move(result));
        if (silent || options.summary) { return; }
        printHeading(*results->back().stressCase, &heading);
        printRow(results->back());
    });
    return done.ok();
}

int runStress(const StressOptions& options) {
    auto cases = filterStressCases(stressCases(), options.filter);
    if (!cases) { return reportError(cases.error(), kExitBadInput); }
    if (options.list) {
        printList(*cases);
        return kExitDone;
    }
    RunFiles files;
    for (const std::string& output : {options.html, options.json}) {
        if (Status writable = files.writes(output); !writable) {
            return reportError(writable.error(), kExitBadInput);
        }
    }
    if (Status replaces = checkReplaces(options.html, looksLikeStressHtml, "a page of glint stress");
        !replaces) {
        return reportError(replaces.error(), kExitBadInput);
    }
    const size_t leftOut =
        options.quick ? std::erase_if(*cases, [](const StressCase& c) { return !c.quick; }) : 0;
    if (cases->empty()) {
        return reportError({"the filter leaves no case that is part of --quick", {}}, kExitBadInput);
    }

    std::vector<StressResult> results;
    InterruptWatch watch;  // until the results are saved
    const bool finished = runCases(*cases, options, &watch, &results);
    if (!jsonTakesOutput(options.json)) {
        if (options.summary) { put("{}", stressMarkdown(results)); }
        if (!options.summary) { printEnd(results); }
        if (leftOut > 0) { put("\n{} more cases are not part of --quick\n", leftOut); }
    }
    const Status page = options.html.empty()
                            ? Status()
                            : writeFileAtomically(options.html, stressHtml(results, options.quick));
    const Status report = writeJson(options.json, "stress", jsonReport(results, options));
    const Status& written = page ? report : page;
    if (!written) { return reportError(written.error(), kExitFailed); }
    if (!finished) { return kExitInterrupted; }
    const bool asDocumented =
        std::ranges::none_of(results, [](const StressResult& result) { return result.unexpected(); });
    return asDocumented ? kExitDone : kExitBeyondLimit;
}

}  // namespace

void addStressCommand(const Command& program) {
    const Command command = program.subcommand(kStress.name, kStress.about);
    const auto options = std::make_shared<StressOptions>();
    command
        .option("--filter", &options->filter,
                "Only the family NAME, or the cases whose family/grade contains it")
        .typeName("NAME");
    command.flag("--quick", &options->quick, "Fewer cases and samples, for automatic runs");
    command.flag("--list", &options->list, "List the cases and run none");
    command.flag("--summary", &options->summary,
                 "Print one Markdown row for each family instead of the cases");
    command.option("--html", &options->html, "Write the table as one self-contained page to FILE")
        .typeName("FILE")
        .accepts(checkWritable);
    addJsonOption(command, &options->json);
    command.option("--threads", &options->threads, "Render threads; all by default").range(1, 1024);
    command.footer(
        "Exit codes: 0 every case is as good as documented, 1 the options are wrong, 2 a file could not be\n"
        "written, 3 a case is worse than documented, 130 interrupted (what was measured is written).");
    command.onRun([options] { return runStress(*options); });
}

}  // namespace glint
