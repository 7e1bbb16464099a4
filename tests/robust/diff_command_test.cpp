// `glint diff` as its users meet it: exit codes, limits, maps, pictures of different kinds, and what cannot
// be compared.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "engine/io/exr_io.h"
#include "engine/io/image_io.h"
#include "tests/support/formula_images.h"
#include "tests/support/program_test.h"

namespace glint {
namespace {

using test::ProgramRun;
using test::runProgram;
using test::says;
using test::TempFolder;

class DiffCommand : public test::ProgramTest {
  protected:
    std::string exr(const std::string& name, const ImageF& image) {
        EXPECT_TRUE(saveExr(folder.path(name), test::exrOf(image)));
        return folder.path(name);
    }
};

TEST_F(DiffCommand, PrintsEveryMetric) {
    const ProgramRun run = runProgram(
        {"diff", exr("a.exr", test::formulaTest(64, 48)), exr("b.exr", test::formulaReference(64, 48))});
    EXPECT_EQ(run.exitCode, 0) << run.err;
    for (const char* line :
         {"  MSE             0.162663", "  RMSE            0.403315", "  relMSE          3.39472",
          "  relMSE trimmed  2.35979", "  MAPE            0.468741", "  bias            0.0478032",
          "  relative bias   0.107204", "  largest error   4.05078", "  SSIM            0.904551",
          "  FLIP            0.101916", "  picture error   0.107073"}) {
        EXPECT_TRUE(says(run.out, line));
    }
}

TEST_F(DiffCommand, LimitsSetTheExitCode) {
    const std::string a = exr("a.exr", test::formulaTest(64, 48));
    const std::string b = exr("b.exr", test::formulaReference(64, 48));
    const auto code = [&](const std::string& option, const std::string& limit) {
        return runProgram({"diff", a, b, option, limit}).exitCode;
    };
    EXPECT_EQ(code("--max-relmse", "3.5"), 0);
    EXPECT_EQ(code("--max-relmse", "3.3"), 3);
    EXPECT_EQ(code("--max-flip", "0.11"), 0);
    EXPECT_EQ(code("--max-flip", "0.1"), 3);
    EXPECT_EQ(code("--min-ssim", "0.9"), 0);
    EXPECT_EQ(code("--min-ssim", "0.91"), 3);
    EXPECT_EQ(code("--max-bias", "0.05"), 0);
    EXPECT_EQ(code("--max-bias", "0.04"), 3);
    // A bias has two directions: with the pictures exchanged it is negative.
    EXPECT_EQ(runProgram({"diff", b, a, "--max-bias", "0.04"}).exitCode, 3);
    EXPECT_EQ(runProgram({"diff", b, a, "--max-bias", "0.05"}).exitCode, 0);
    EXPECT_EQ(code("--max-hdr-flip", "0.12"), 0);
    EXPECT_EQ(code("--max-hdr-flip", "0.11"), 3);
    // One limit of several is enough.
    const ProgramRun run = runProgram({"diff", a, b, "--max-mse", "1", "--max-mape", "0.1"});
    EXPECT_EQ(run.exitCode, 3);
    EXPECT_TRUE(says(run.out, "--max-mse 1: within"));
    EXPECT_TRUE(says(run.out, "--max-mape 0.1: BEYOND"));
    // Equal pictures pass the sharpest limits.
    EXPECT_EQ(runProgram({"diff", a, a, "--max-error", "0", "--max-flip", "0", "--min-ssim", "1"}).exitCode,
              0);
}

TEST_F(DiffCommand, JsonHoldsTheSame) {
    const ProgramRun run =
        runProgram({"diff", exr("a.exr", test::formulaTest(64, 48)),
                    exr("b.exr", test::formulaReference(64, 48)), "--json", "-", "--max-rmse", "0.1"});
    EXPECT_EQ(run.exitCode, 3);
    const auto report = nlohmann::json::parse(run.out);
    EXPECT_NEAR(report["metrics"]["rel_mse"].get<double>(), 3.39471687312, 1e-5);
    EXPECT_NEAR(report["metrics"]["relative_rmse"].get<double>(), std::sqrt(3.39471687312), 1e-5);
    EXPECT_EQ(report["metrics"].size(), 13u);
    EXPECT_TRUE(report["metrics"]["hdr_flip"].is_null()) << "not asked for";
    EXPECT_EQ(report["limits"][0]["metric"], "rmse");
    EXPECT_FALSE(report["within_limits"].get<bool>());
}

TEST_F(DiffCommand, WritesMapsWithALegend) {
    const std::string maps = folder.path("new/maps");
    const ProgramRun run = runProgram({"diff", exr("a.exr", test::formulaTest(400, 30)),
                                       exr("b.exr", test::formulaReference(400, 30)), "--maps", maps});
    EXPECT_EQ(run.exitCode, 0) << run.err;
    for (const char* name : {"relative-squared", "absolute", "signed", "flip"}) {
        const auto map = loadImage8(maps + "/" + name + ".png");
        ASSERT_TRUE(map) << map.error().format();
        EXPECT_EQ((*map)->width, 400);
        EXPECT_GT((*map)->height, 30 + 40);
    }
}

TEST_F(DiffCommand, MapsOfOneRangeCanBeCompared) {
    const ImageF half = test::flatImage(8, 8, 0.5f);
    const std::string reference = exr("reference.exr", half);
    const auto colorOf = [&](float value, std::vector<std::string> ranges, const std::string& map) {
        const std::string folder_ = folder.path("maps" + std::to_string(value));
        std::vector<std::string> words = {"diff", exr("test.exr", test::flatImage(8, 8, value)), reference,
                                          "--maps", folder_};
        words.insert(words.end(), ranges.begin(), ranges.end());
        const ProgramRun run = runProgram(words);
        EXPECT_EQ(run.exitCode, 0) << run.err;
        const auto image = loadImage8(folder_ + "/" + map + ".png");
        EXPECT_TRUE(image);
        return std::pair(image ? std::vector<uint8_t>((*image)->rgb.begin(), (*image)->rgb.begin() + 3)
                               : std::vector<uint8_t>(),
                         run.out);
    };
    const std::vector<std::string> ranges = {"--map-range", "absolute=0.001:1", "--map-range", "signed=0.5"};
    // Chosen for each picture, the range hides that one error is a hundred times the other.
    EXPECT_EQ(colorOf(0.51f, {}, "absolute").first, colorOf(0.501f, {}, "absolute").first);
    const auto small = colorOf(0.501f, ranges, "absolute"), large = colorOf(0.6f, ranges, "absolute");
    EXPECT_NE(small.first, large.first);
    EXPECT_TRUE(says(small.second, "absolute.png: colours from 0.001 to 1, logarithmic"));
    EXPECT_TRUE(says(small.second, "signed.png: colours from -0.5 to 0.5"));
    EXPECT_TRUE(says(small.second, "flip.png: colours from 0 to 1"));
    // The same error has the same colour, whatever else is in the picture.
    EXPECT_EQ(colorOf(0.6f, ranges, "absolute").first, colorOf(0.4f, ranges, "absolute").first);
}

TEST_F(DiffCommand, EightBitsBesideFloatsAreWarnedOf) {
    const Image8 bytes{.width = 8, .height = 8, .rgb = std::vector<uint8_t>(3 * 64, 188)};
    ASSERT_TRUE(savePng(folder.path("a.png"), bytes));
    ImageF bright = test::flatImage(8, 8, 0.5f);
    bright.rgb[0] = bright.rgb[1] = 7.0f;
    const std::string floats = exr("b.exr", bright);
    for (const auto& [a, b] :
         {std::pair(folder.path("a.png"), floats), std::pair(floats, folder.path("a.png"))}) {
        const ProgramRun run = runProgram({"diff", a, b, "--json", "-"});
        EXPECT_EQ(run.exitCode, 0);
        EXPECT_TRUE(says(run.err, "a.png has 8 bits a channel"));
        EXPECT_TRUE(says(run.err, "2 of 192"));
        EXPECT_EQ(nlohmann::json::parse(run.out)["warnings"].size(), 1u);
    }
    for (const std::string& same : {folder.path("a.png"), floats}) {
        EXPECT_EQ(runProgram({"diff", same, same}).err, "");
    }
}

TEST_F(DiffCommand, NothingIsRelativeToABlackReference) {
    const std::string grey = exr("a.exr", test::flatImage(8, 8, 0.5f));
    const std::string black = exr("b.exr", test::flatImage(8, 8, 0.0f));
    const ProgramRun run = runProgram({"diff", grey, black});
    EXPECT_EQ(run.exitCode, 0) << run.err;
    size_t count = 0;
    for (size_t at = 0;
         (at = run.out.find("none          the reference is black\n", at)) != std::string::npos; ++at) {
        ++count;
    }
    EXPECT_EQ(count, 5u) << run.out;
}

TEST_F(DiffCommand, ComparesKindsAsLinearColours) {
    // 188 / 255 in sRGB is 0.5029 linear.
    Image8 bytes{.width = 16, .height = 16, .rgb = std::vector<uint8_t>(3 * 256, 188)};
    ASSERT_TRUE(savePng(folder.path("a.png"), bytes));
    ASSERT_TRUE(saveHdr(folder.path("c.hdr"), test::flatImage(16, 16, 0.5f)));
    const std::string half = exr("b.exr", test::flatImage(16, 16, 0.5f));
    EXPECT_EQ(runProgram({"diff", folder.path("a.png"), half, "--max-error", "0.004"}).exitCode, 0);
    EXPECT_EQ(runProgram({"diff", folder.path("c.hdr"), half, "--max-error", "0.002"}).exitCode, 0);
}

TEST_F(DiffCommand, WhatCannotBeComparedIsRefusedWithOneMessage) {
    const std::string good = exr("good.exr", test::flatImage(8, 8, 0.5f));
    const std::string small = exr("small.exr", test::flatImage(8, 7, 0.5f));
    ImageF infinite = test::flatImage(8, 8, 0.5f);
    infinite.rgb[3 * 10 + 1] = std::numeric_limits<float>::infinity();
    const std::string bytes = TempFolder::read(good);
    const std::vector<std::pair<std::string, std::string>> cases = {
        {small, "8x7 pixels against the reference's 8x8"},
        {folder.path("none.exr"), "none.exr"},
        {folder.path(), "folder"},
        {folder.write("empty.png", ""), "empty.png"},
        {folder.write("text.exr", "not a picture"), "text.exr"},
        {folder.write("cut.exr", bytes.substr(0, bytes.size() / 2)), "cut.exr"},
        {exr("infinite.exr", infinite), "column 2, row 1 is inf"},
    };
    for (const auto& [bad, message] : cases) {
        const ProgramRun run = runProgram({"diff", bad, good, "--max-relmse", "1"});
        EXPECT_EQ(run.exitCode, 1) << bad;
        EXPECT_TRUE(says(run.err, message)) << bad;
        EXPECT_EQ(run.out, "") << bad;
    }
    EXPECT_EQ(runProgram({"diff", good, small}).exitCode, 1);
    EXPECT_EQ(runProgram({"diff", good}).exitCode, 1);
}

TEST_F(DiffCommand, BadOptionsAreRefused) {
    const std::string good = exr("good.exr", test::flatImage(8, 8, 0.5f));
    const std::string file = folder.write("file", "x");
    const std::vector<std::vector<std::string>> bad = {
        {"--max-relmse", "-1"},
        {"--max-relmse", "nan"},
        {"--max-relmse", "little"},
        {"--min-ssim", "2"},
        {"--epsilon", "0"},
        {"--trim", "1"},
        {"--exposure", "nan"},
        {"--pixels-per-degree", "0"},
        {"--maps", file},
        {"--json", "/none/a.json"},
        {"--maps", "/proc/maps-of-glint"},
        {"--maps", ""},
        {"--map-range", "absolute=0.1:1"},
        {"--maps", folder.path("m"), "--map-range", "absolute=1:0.1"},
        {"--maps", folder.path("m"), "--map-range", "absolute=0:1"},
        {"--maps", folder.path("m"), "--map-range", "absolute=nan:1"},
        {"--maps", folder.path("m"), "--map-range", "absolute=0.1"},
        {"--maps", folder.path("m"), "--map-range", "absolute"},
        {"--maps", folder.path("m"), "--map-range", "signed=-1"},
        {"--maps", folder.path("m"), "--map-range", "flip=0:0.5"},
    };
    for (const auto& options : bad) {
        std::vector<std::string> arguments = {"diff", good, good};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const ProgramRun run = runProgram(arguments);
        EXPECT_EQ(run.exitCode, 1) << options[0] << " " << options[1];
        EXPECT_NE(run.err, "") << options[0];
    }
    EXPECT_TRUE(says(runProgram({"diff", good, good, "--max-relms", "1"}).err, "--max-relmse"));
    EXPECT_TRUE(
        says(runProgram({"diff", good, good, "--maps", folder.path("m"), "--map-range", "absolut=1:2"}).err,
             "did you mean 'absolute'"));
}

}  // namespace
}  // namespace glint
