// The Convergence panel by script: both curves grow, the error against a reference is that of the saved
// pictures, checkpoints keep the curve, and what the mouse, the target and the files do.
#include <cstdio>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/atomic_file.h"
#include "tests/viewer/play_script.h"

namespace glint {
namespace {

using namespace test;
using testing::AnyOf;
using testing::HasSubstr;
using testing::StartsWith;

struct PointCounts {
    int path = -1;
    int sppm = -1;
};
PointCounts countsOf(const std::string& text) {
    PointCounts counts;
    std::sscanf(text.c_str(), "Path tracing %d points, SPPM %d points", &counts.path, &counts.sppm);
    return counts;
}

TEST(ConvergenceViewer, BothCurvesGrow) {
    const Ran ran = play(R"(
set "Integrator" SPPM
wait frames 2
set "Photons" 2000
key c
wait passes 3
wait frames 2
print "Convergence/Curve"
wait passes 30
wait frames 2
print "Convergence/Curve"
expect widget "Convergence/PT to target"
move "Convergence/Curve" 0.5 0.6
wait frames 3
print "Convergence/Curve"
screenshot "curves.png"
)");
    expectPlayed(ran);
    const auto said = printed(ran, "Convergence/Curve");
    ASSERT_EQ(said.size(), 3u) << ran.output;
    const PointCounts before = countsOf(said[0]);
    const PointCounts after = countsOf(said[1]);
    EXPECT_GE(before.sppm, 2) << said[0];
    EXPECT_GT(after.path, before.path) << said[1];
    EXPECT_GT(after.sppm, before.sppm) << said[1];
    EXPECT_THAT(said[2], AnyOf(StartsWith("Path tracing: "), StartsWith("SPPM: ")))
        << "what the mouse is over";
    EXPECT_THAT(said[2], HasSubstr("passes"));
    EXPECT_THAT(ran.output, HasSubstr("90 %: "));
}

/// Statements that move the mouse over the curve's plot, for how long passes take decides where its
/// curves are.
std::string lookAround() {
    std::string script;
    for (int i = 0; i < 63; ++i) {
        script +=
            fmt::format("move \"Convergence/Curve\" {} {}\nwait frames 2\nprint \"Convergence/Curve\"\n",
                        0.1 * (1 + i % 9), 0.1 * (2 + i / 9));
    }
    return script;
}

TEST(ConvergenceViewer, TheCurveBeforeARestartStaysForComparison) {
    const Ran ran =
        play("wait passes 24\nkey r\nwait picture\nwait passes 24\nwait frames 3\n" + lookAround() +
                 R"(
set "CSV file" "/proc/no/curves.csv"
click "Export CSV"
wait jobs
wait frames 3
print "Convergence/CSV message"
)",
             "--passes 24");  // so that both curves end at one place
    expectPlayed(ran);
    EXPECT_THAT(ran.output, HasSubstr("Path tracing before the last restart: "));
    EXPECT_THAT(printed(ran, "Convergence/CSV message"),
                testing::ElementsAre(HasSubstr("/proc/no/curves.csv")));
}

TEST(ConvergenceViewer, ACheckpointKeepsTheCurve) {
    expectPlayed(play(R"(
wait finished
open "Checkpoint"
wait frames 2
set "Checkpoint file" curve.glintfilm
click "Checkpoint/Save"
wait jobs
set "CSV file" before.csv
click "Export CSV"
wait jobs
expect message "/before.csv"
)",
                      "--passes 14"));
    expectPlayed(play(R"(
wait finished
drop "curve.glintfilm"
wait jobs
expect message "Resumed curve.glintfilm"
wait finished
wait frames 2
set "CSV file" after.csv
click "Export CSV"
wait jobs
)",
                      "--passes 14"));
    const auto before = readFile("before.csv");
    const auto after = readFile("after.csv");
    ASSERT_TRUE(before && after);
    EXPECT_THAT(*before, StartsWith("integrator,source,passes,render_seconds,relative_error,"));
    EXPECT_THAT(*before, HasSubstr("\npath,estimate,14,"));
    EXPECT_EQ(*before, *after);
}

TEST(ConvergenceViewer, ADroppedSceneIsOpened) {
    std::string other = kScene;
    other.replace(other.find("[64, 48]"), 8, "[32, 16]");
    write("other.json", other);
    expectPlayed(play(R"(
wait picture
drop "other.json"
wait jobs
wait picture
expect "Scene/File" other.json
open "Picture"
wait frames 2
expect "Width" 32
)"));
}

TEST(ConvergenceViewer, TheTargetStopsTheRenderWhenAsked) {
    expectPlayed(play(R"(
wait picture
mark
set "Target error" 20
wait frames 2
expect "Error limit" 0
set "Stop there" on
wait finished
wait frames 2
expect "Error limit" 20
print "Convergence/PT to target"
set "Stop there" off
wait frames 2
expect "Error limit" 0
expect "Target error" 20
expect state rendering
expect restarts 0
)"));
}

}  // namespace
}  // namespace glint
