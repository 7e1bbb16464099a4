// `glint converge` as its users meet it: what it writes, marks, refuses and keeps. Tiny pictures and counted
// passes, so that nothing depends on the machine's speed.
#include <filesystem>
#include <limits>
#include <map>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "engine/io/exr_io.h"
#include "engine/io/image_io.h"
#include "tests/support/converge_test.h"

namespace glint {
namespace {

using nlohmann::json;
using test::ConvergeCommand;
using test::ProgramRun;
using test::says;
using test::TempFolder;

const std::string kScenes = GLINT_SOURCE_DIR "/scenes/";

std::vector<std::map<std::string, std::string>> readCsv(const std::string& file) {
    std::istringstream text(TempFolder::read(file));
    const auto cells = [](const std::string& line) {
        std::vector<std::string> out;
        std::istringstream in(line);
        for (std::string cell; std::getline(in, cell, ',');) {
            out.push_back(cell);
        }
        if (line.ends_with(",")) { out.emplace_back(); }
        return out;
    };
    std::string line;
    std::getline(text, line);
    const std::vector<std::string> names = cells(line);
    std::vector<std::map<std::string, std::string>> rows;
    while (std::getline(text, line)) {
        const std::vector<std::string> values = cells(line);
        EXPECT_EQ(values.size(), names.size()) << line;
        std::map<std::string, std::string> row;
        for (size_t i = 0; i < std::min(values.size(), names.size()); ++i) {
            row[names[i]] = values[i];
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

TEST_F(ConvergeCommand, WritesEverythingAndItAgrees) {
    const ProgramRun run =
        converge(with({"--integrators", "pt,pt:sampler=independent,sppm:photons=500:radius=auto:2"}));
    ASSERT_EQ(run.exitCode, 0) << run.err;
    EXPECT_TRUE(says(run.out, "slope"));
    const json all = summary();
    ASSERT_TRUE(all.is_object());
    ASSERT_EQ(all["variants"].size(), 3u);
    EXPECT_EQ(all["variants"][2]["name"], "sppm photons=500 radius=auto:2");
    EXPECT_EQ(all["plan"]["passes"], 6);
    EXPECT_TRUE(says(all["command"], "--integrators pt,pt:sampler=independent"));
    EXPECT_TRUE(says(all["seconds_meaning"], "not in them"));

    const auto rows = readCsv(file("curve.csv"));
    ASSERT_EQ(rows.size(), 3u * 2u * 4u) << "a row for each variant, seed and point";
    for (const json& variant : all["variants"]) {
        ASSERT_EQ(variant["curve"].size(), 4u);
        const json& last = variant["curve"][3];
        EXPECT_EQ(last["passes"], 6);
        EXPECT_EQ(last["seeds"], 2);
        double mse = 0.0, squares = 0.0;
        std::vector<double> values;
        for (const auto& row : rows) {
            if (row.at("variant") == variant["name"] && row.at("point") == "3") {
                values.push_back(std::stod(row.at("mse")));
                EXPECT_NEAR(std::stod(row.at("rmse")), std::sqrt(values.back()), 1e-9);
                EXPECT_NEAR(std::stod(row.at("relative_error")),
                            std::stod(row.at("rmse")) / all["reference"]["mean"].get<double>(), 1e-9);
            }
        }
        ASSERT_EQ(values.size(), 2u);
        mse = 0.5 * (values[0] + values[1]);
        squares = std::fabs(values[0] - values[1]) / std::sqrt(2.0);
        EXPECT_NEAR(last["mse"]["mean"].get<double>(), mse, 1e-12);
        EXPECT_NEAR(last["mse"]["sd"].get<double>(), squares, 1e-12);
        EXPECT_GT(variant["final"]["variance"].get<double>(), 0.0);
        EXPECT_EQ(variant["time_to"].size(), 4u);
        for (const json& image : variant["pictures"]) {
            EXPECT_TRUE(loadImage8(file(image["file"].get<std::string>())));
            EXPECT_TRUE(loadImage8(file(image["error_file"].get<std::string>())));
        }
    }
    EXPECT_EQ(readCsv(file("summary.csv")).size(), 3u * 4u);
    EXPECT_TRUE(loadImage8(file("plot.png")));
    EXPECT_TRUE(says(TempFolder::read(file("plot.svg")), "own error, %: "));
}

TEST_F(ConvergeCommand, ThePageNeedsNothingElse) {
    ASSERT_EQ(converge(with({"--integrators", "pt"})).exitCode, 0);
    const std::string page = TempFolder::read(file("index.html"));
    for (const char* part : {"<svg", "data:image/png;base64,", "To repeat it", "glint converge",
                             "not in them", "<title>path *: relative error", "prefers-color-scheme"}) {
        EXPECT_TRUE(page.find(part) != std::string::npos) << part;
    }
    for (const char* part : {"src=\"http", "href=", "@import", "<script src"}) {
        EXPECT_TRUE(page.find(part) == std::string::npos) << part;
    }
}

TEST_F(ConvergeCommand, EarlierResultsAreNotReplacedUnasked) {
    ASSERT_EQ(converge(with({"--integrators", "pt"})).exitCode, 0);
    const std::string before = TempFolder::read(file("summary.json"));
    std::ofstream(file("mine.txt")) << "mine";
    const ProgramRun refused = converge(with({"--integrators", "sppm:photons=500"}));
    EXPECT_EQ(refused.exitCode, 1);
    EXPECT_TRUE(says(refused.err, "--overwrite"));
    EXPECT_EQ(TempFolder::read(file("summary.json")), before);
    EXPECT_EQ(converge(with({"--integrators", "sppm:photons=500", "--overwrite"})).exitCode, 0);
    EXPECT_NE(TempFolder::read(file("summary.json")), before);
    EXPECT_EQ(TempFolder::read(file("mine.txt")), "mine");
    // A cached reference of other settings is not taken for this one's.
    removeResults();
    const ProgramRun other = converge(with({"--integrators", "pt", "--depth", "1"}));
    EXPECT_EQ(other.exitCode, 1);
    EXPECT_TRUE(says(other.err, "maxDepth"));
}

TEST_F(ConvergeCommand, BadInputHasOneMessageAndLeavesNothing) {
    const std::vector<std::vector<std::string>> bad = {
        {},
        {"--make-reference", "1", "--reference", "a.exr"},
        {"--make-reference", "0"},
        {"--make-reference", "nan"},
        with({"--time", "3"}),
        with({"--integrators", "ptt"}),
        with({"--integrators", "pt:sampler=halton"}),
        with({"--integrators", "pt,pt"}),
        with({"--reference-variant", "sppm:alpha=2"}),
        with({"--seeds", "0"}),
        with({"--points", "1"}),
        with({"--backend", "gpu"}),
        with({"--threads", "0"}),
        with({"--size", "0x4"}),
        with({"--json", folder.path("no/such/a.json")}),
        {"--reference-variant", "pt", "--reference", "a.exr"},
        {"--make-reference", "1", "--time", "-2"},
        with({"--picture-times", "7"}),
        with({"--picture-times", "0"}),
        with({"--picture-times", "nan"}),
        with({"--picture-times", "2", "--pictures", "1"}),
    };
    for (const auto& options : bad) {
        const ProgramRun run = converge(options);
        const std::string words =
            options.empty() ? "no options" : options[options.size() - 2] + " " + options.back();
        EXPECT_EQ(run.exitCode, 1) << words << ": " << run.err;
        EXPECT_FALSE(run.err.empty()) << words;
    }
    EXPECT_EQ(folder.size(), 0u) << "a refused run must leave nothing behind";
    const std::string blocked = folder.write("file", "a file");
    EXPECT_TRUE(says(converge(with({}), "file").err, "is a file"));
    EXPECT_TRUE(says(converge(with({}), "file/below").err, "is a file"));
    EXPECT_EQ(test::runProgram(
                  {"converge", folder.path("none.json"), "--make-reference", "1", "--out", folder.path("x")})
                  .exitCode,
              1);
}

TEST_F(ConvergeCommand, CtrlCKeepsWhatWasMeasured) {
    const ProgramRun run = converge({"--make-reference", "0.2", "--passes", "20", "--points", "3", "--seeds",
                                     "1000", "--integrators", "pt"},
                                    "run", "seed 2 of 1000");
    EXPECT_EQ(run.exitCode, 130) << run.err;
    const json all = summary();
    ASSERT_TRUE(all.is_object());
    EXPECT_TRUE(all["interrupted"].get<bool>());
    ASSERT_EQ(all["variants"][0]["curve"].size(), 3u);
    EXPECT_GE(all["variants"][0]["curve"][0]["seeds"].get<int>(), 1);
    EXPECT_TRUE(says(TempFolder::read(file("index.html")), "interrupted"));
}

TEST_F(ConvergeCommand, EveryOutputSaysWhatTheSecondsAre) {
    const ProgramRun run = converge(with({"--integrators", "pt"}));
    ASSERT_EQ(run.exitCode, 0) << run.err;
    for (const std::string& text :
         {run.out, TempFolder::read(file("summary.json")), TempFolder::read(file("index.html")),
          TempFolder::read(file("plot.svg"))}) {
        EXPECT_NE(text.find("saving are not in them"), std::string::npos);
    }
}

TEST_F(ConvergeCommand, ImagesAtChosenTimes) {
    const ProgramRun run = converge({"--make-reference", "0.05", "--passes", "9", "--points", "2", "--seeds",
                                     "1", "--integrators", "pt", "--picture-times", "7,3"});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    std::vector<int> passes;
    const json all = summary();
    for (const json& image : all["variants"][0]["pictures"]) {
        passes.push_back(image["passes"].get<int>());
        EXPECT_TRUE(loadImage8(file(image["file"].get<std::string>())));
        EXPECT_TRUE(loadImage8(file(image["error_file"].get<std::string>())));
    }
    EXPECT_EQ(passes, (std::vector<int>{3, 7, 9}));
}

TEST_F(ConvergeCommand, WhatWasMeasuredIsPrintedWhenItCannotBeWritten) {
    ASSERT_EQ(converge(with({"--integrators", "pt"})).exitCode, 0);
    removeResults();
    std::filesystem::create_symlink("/dev/full", file("curve.csv"));
    const ProgramRun run = converge(with({"--integrators", "pt", "--overwrite"}));
    EXPECT_EQ(run.exitCode, 2) << run.err;
    EXPECT_TRUE(says(run.err, "curve.csv"));
    EXPECT_TRUE(says(run.out, "slope"));
}

TEST_F(ConvergeCommand, EverySceneAndFormatWorks) {
    std::vector<std::string> scenes;
    for (const auto& entry : std::filesystem::directory_iterator(kScenes)) {
        if (entry.path().extension() == ".json" && entry.path().filename() != "glint.schema.json") {
            scenes.push_back(entry.path().string());
        }
    }
    ASSERT_GT(scenes.size(), 5u);
    scenes.push_back(folder.write("quad.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n"));
    scenes.push_back(folder.write("triangle.ply",
                                  "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float "
                                  "y\nproperty float z\nelement face 1\nproperty list uchar int "
                                  "vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"));
    int number = 0;
    for (const std::string& scene : scenes) {
        const std::string out = folder.path("run" + std::to_string(number++));
        const ProgramRun run = test::runProgram(
            {"converge", scene, "--size", "8x6", "--make-reference", "0.02", "--passes", "2", "--seeds", "2",
             "--integrators", "pt,sppm:photons=200", "--reference-variant", "pt", "--out", out});
        EXPECT_EQ(run.exitCode, 0) << scene << ": " << run.err;
        EXPECT_TRUE(std::filesystem::exists(out + "/index.html")) << scene;
        const ProgramRun diff = test::runProgram(
            {"diff", out + "/pictures/path-2.png", out + "/reference.exr", "--json", "-", "--hdr-flip"});
        EXPECT_EQ(diff.exitCode, 0) << scene << ": " << diff.err;
        EXPECT_TRUE(json::parse(diff.out, nullptr, false).contains("metrics")) << scene;
    }
}

TEST_F(ConvergeCommand, ABlackImageHasNoRelativeError) {
    const std::string scene = folder.write(
        "dark.json",
        R"({"glint": 1, "resolution": [8, 8], "camera": {"position": [0, 0, 3], "target": [0, 0, 0]},
        "materials": {"grey": {"type": "diffuse", "color": 0.5}},
        "objects": [{"type": "sphere", "material": "grey"}]})");
    const ProgramRun run =
        test::runProgram({"converge", scene, "--make-reference", "0.05", "--passes", "3", "--seeds", "2",
                          "--integrators", "pt,sppm:photons=100", "--out", folder.path("run")});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    EXPECT_TRUE(summary()["variants"][0]["curve"][0]["relative_error"]["mean"].is_null());
    EXPECT_EQ(summary()["variants"][0]["curve"][0]["mse"]["mean"], 0.0);
    EXPECT_EQ(run.out.find("nan"), std::string::npos) << run.out;
}

}  // namespace
}  // namespace glint
