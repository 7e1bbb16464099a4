// `glint stress` with all its cases and samples: no case may be worse than its documented limit.

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/program_test.h"

namespace glint {
namespace {

using StressLong = test::ProgramTest;

TEST_F(StressLong, TheWholeSuiteIsAsDocumented) {
    const test::ProgramRun run = test::runProgram({"stress", "--json", "-"});
    const nlohmann::json report = nlohmann::json::parse(run.out, nullptr, false);
    ASSERT_FALSE(report.is_discarded()) << run.out << run.err;
    for (const nlohmann::json& row : report["cases"]) {
        EXPECT_FALSE(row["unexpected"].get<bool>()) << row.dump(2);
    }
    EXPECT_FALSE(report["quick"].get<bool>());
    EXPECT_EQ(run.exitCode, 0) << run.err;
}

}  // namespace
}  // namespace glint
