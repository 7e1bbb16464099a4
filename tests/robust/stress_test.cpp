// `glint stress --quick` as a test: no case may be worse than its documented limit, and limits may not be
// added in passing. Under the sanitizers the same scenes are rendered with so few samples that only what they
// find counts. Also the command's options.

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "engine/stress/stress_suite.h"
#include "tests/support/program_test.h"

namespace glint {
namespace {

using nlohmann::json;

using Stress = test::ProgramTest;

#ifdef __SANITIZE_ADDRESS__
TEST_F(Stress, EveryQuickCaseRunsUnderTheSanitizers) {
    std::vector<StressCase> cases = stressCases();
    std::erase_if(cases, [](const StressCase& c) { return !c.quick; });
    size_t measured = 0;
    StressEffort effort;
    effort.quick = effort.touchOnly = true;
    const Status done = runStressCases(cases, effort, [&](const StressResult& result) {
        const std::string name = result.stressCase->family + "/" + result.stressCase->grade;
        EXPECT_FALSE(result.outcome.values.empty()) << name << ": " << result.judgement.reason;
        EXPECT_EQ(result.outcome.dropped(), 0u) << name;
        ++measured;
    });
    EXPECT_TRUE(done);
    EXPECT_EQ(measured, cases.size());
}
#else
TEST_F(Stress, QuickSuiteIsAsDocumented) {
    const test::ProgramRun run = test::runProgram({"stress", "--quick", "--json", "-"});
    const json report = json::parse(run.out, nullptr, false);
    ASSERT_FALSE(report.is_discarded()) << run.out << run.err;
    for (const json& row : report["cases"]) {
        EXPECT_FALSE(row["unexpected"].get<bool>()) << row.dump(2);
    }
    EXPECT_EQ(report["unexpected"], 0);
    EXPECT_EQ(run.exitCode, 0) << run.err;
    EXPECT_GT(report["ok"].get<int>(), 300);
}
#endif

/// Families in which nothing but ok will do: their grades are what users' scenes are made of.
TEST_F(Stress, CommonFamiliesHaveNoDocumentedLimit) {
    for (const StressCase& c : stressCases()) {
        for (const char* family :
             {"offset", "needles", "grazing", "roughness", "albedo", "camera", "environment", "film"}) {
            if (c.family == family) {
                EXPECT_EQ(c.documented, StressVerdict::Ok) << family << "/" << c.grade;
            }
        }
    }
}

TEST_F(Stress, ListNamesCasesAndRunsNone) {
    const test::ProgramRun run = test::runProgram({"stress", "--list", "--filter", "film"});
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_NE(run.out.find("outlier 1e9 first"), std::string::npos) << run.out;
    EXPECT_EQ(run.out.find("±"), std::string::npos) << run.out;
}

TEST_F(Stress, AnUnknownFilterNamesTheNearestFamily) {
    const test::ProgramRun run = test::runProgram({"stress", "--filter", "cammera"});
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_NE(run.err.find("did you mean 'camera'"), std::string::npos) << run.err;
}

TEST_F(Stress, WritesHtmlAndJson) {
    const test::ProgramRun run =
        test::runProgram({"stress", "--quick", "--filter", "recurrence", "--html", folder.path("stress.html"),
                          "--json", folder.path("stress.json")});
    EXPECT_EQ(run.exitCode, 0) << run.out << run.err;
    EXPECT_NE(run.out.find("±"), std::string::npos) << run.out;
    EXPECT_NE(test::TempFolder::read(folder.path("stress.html")).find("</html>"), std::string::npos);
    const json report = json::parse(test::TempFolder::read(folder.path("stress.json")), nullptr, false);
    ASSERT_FALSE(report.is_discarded());
    for (const char* key : {"quick", "significance", "ok", "degraded", "broken", "unexpected", "cases"}) {
        EXPECT_TRUE(report.contains(key)) << key;
    }
    for (const char* key :
         {"family", "grade", "extreme", "truth", "deviation", "half_width", "tolerance", "samples", "dropped",
          "verdict", "reason", "documented", "limit", "unexpected", "seconds"}) {
        EXPECT_TRUE(report["cases"][0].contains(key)) << key;
    }
}

TEST_F(Stress, SummaryIsAMarkdownTable) {
    const test::ProgramRun run =
        test::runProgram({"stress", "--quick", "--filter", "recurrence", "--summary"});
    EXPECT_EQ(run.exitCode, 0) << run.out;
    EXPECT_TRUE(run.out.starts_with("| family |")) << run.out;
}

TEST_F(Stress, AFolderThatDoesNotExistIsFoundBeforeAnythingRuns) {
    const test::ProgramRun run = test::runProgram({"stress", "--html", "/nowhere/stress.html"});
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_EQ(run.out.find("±"), std::string::npos) << run.out;
}

}  // namespace
}  // namespace glint
