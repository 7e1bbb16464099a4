// `glint render --error E` from end to end: it stops, the picture is as good as was asked for, and the time
// that was foretold on the way is about what it took. Counted in passes, so that nothing depends on the
// machine's speed.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "engine/io/image_io.h"
#include "engine/render/convergence_curve.h"
#include "tests/support/program_test.h"
#include "tests/support/true_error.h"

namespace glint::test {
namespace {

using nlohmann::json;

constexpr double kTarget = 0.1;
constexpr int kRuns = 12;

class ErrorLimit : public ProgramTest {
  protected:
    /// The report; the picture is `file`.
    json render(const std::string& file, std::vector<std::string> more) {
        std::vector<std::string> words = {"render", GLINT_SOURCE_DIR "/scenes/cornell.json",
                                          "--size", "24x24",
                                          "-o",     folder.path(file),
                                          "--json", "-"};
        words.insert(words.end(), more.begin(), more.end());
        const ProgramRun run = runProgram(words);
        EXPECT_EQ(run.exitCode, 0) << run.err;
        return json::parse(run.out, nullptr, false);
    }

    std::vector<double> luminances(const std::string& file) {
        const auto image = loadImageF(folder.path(file));
        EXPECT_TRUE(image);
        std::vector<double> out;
        for (size_t i = 0; image && i < (*image)->rgb.size(); i += 3) {
            const float* rgb = &(*image)->rgb[i];
            out.push_back(0.2126 * static_cast<double>(rgb[0]) + 0.7152 * static_cast<double>(rgb[1]) +
                          0.0722 * static_cast<double>(rgb[2]));
        }
        return out;
    }
};

/// What forecasts of the whole number of passes were, over what it was: of each point from 16 passes to half
/// of the end.
std::vector<double> forecastsOverTruth(const json& report) {
    const double end = report["passes"].get<double>();
    std::vector<double> ratios;
    ConvergenceCurve curve;
    for (const json& point : report["convergence"]) {
        const auto passes = point["passes"].get<uint32_t>();
        curve.add({.passes = passes,
                   .renderSeconds = static_cast<double>(passes),
                   .relativeError = point["relative_error"].get<double>(),
                   .relativeErrorLow = point["relative_error_low"].get<double>(),
                   .relativeErrorHigh = point["relative_error_high"].get<double>(),
                   .relativeBias = 0.0});
        const auto ahead = forecastError(curve, kTarget);
        if (ahead && passes >= 16 && 2 * passes <= end) {
            ratios.push_back((passes + ahead->secondsLeft) / end);
        }
    }
    return ratios;
}

/// Each run ends at most E from the truth with 95 %: four or more of twelve that do not have a probability
/// of 0.002.
TEST_F(ErrorLimit, IsKeptAndForetold) {
    render("reference.exr", {"--passes", "3000", "--seed", "999"});
    const std::vector<double> reference = luminances("reference.exr");
    int beyond = 0;
    std::vector<double> ratios;
    for (int seed = 1; seed <= kRuns; ++seed) {
        const json report =
            render("a.exr", {"--error", "0.1", "--passes", "100000", "--seed", std::to_string(seed)});
        ASSERT_TRUE(report.is_object());
        EXPECT_LE(report["relative_error_high"].get<double>(), kTarget);
        EXPECT_LT(report["passes"].get<int>(), 100000) << "it never stopped";
        EXPECT_EQ(report["time_to_error"]["seconds_left"], 0.0);
        const double error = trueError(luminances("a.exr"), reference);
        beyond += error > kTarget ? 1 : 0;
        EXPECT_GT(error, 0.1 * kTarget) << "far too careful";
        for (const double ratio : forecastsOverTruth(report)) {
            ratios.push_back(ratio);
        }
    }
    EXPECT_LE(beyond, 3);
    ASSERT_GT(ratios.size(), 50u);
    std::ranges::sort(ratios);
    const auto quantile = [&](double share) {
        return ratios[static_cast<size_t>(share * static_cast<double>(ratios.size()))];
    };
    std::printf("%d of %d beyond; forecast over truth: 10 %% %.2f, median %.2f, 90 %% %.2f\n", beyond, kRuns,
                quantile(0.1), quantile(0.5), quantile(0.9));
    EXPECT_GT(quantile(0.5), 0.67);
    EXPECT_LT(quantile(0.5), 1.5);
    EXPECT_GT(quantile(0.1), 0.4);
    EXPECT_LT(quantile(0.9), 2.5);
}

TEST_F(ErrorLimit, WhatItWouldTakeIsPrintedWhereAnotherLimitComesFirst) {
    const std::vector<std::string> words = {"render",  GLINT_SOURCE_DIR "/scenes/cornell.json",
                                            "--size",  "24x24",
                                            "-o",      folder.path("a.png"),
                                            "--error", "0.001"};
    std::vector<std::string> later = words, early = words;
    later.insert(later.end(), {"--passes", "64"});
    early.insert(early.end(), {"--passes", "3"});
    EXPECT_NE(runProgram(later).out.find("an error below 0.1 % would take about"), std::string::npos);
    EXPECT_NE(runProgram(early).out.find("is not known yet"), std::string::npos);
    const json report = render("b.exr", {"--error", "0.001", "--passes", "64"});
    EXPECT_GT(report["time_to_error"]["seconds_left"].get<double>(), 0.0);
}

}  // namespace
}  // namespace glint::test
