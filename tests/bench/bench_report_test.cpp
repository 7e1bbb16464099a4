// The keys of each benchmark's JSON report, which viewer/commands/README.md promises. Tiny runs: no figure is
// judged here.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/program_test.h"

namespace glint {
namespace {

using nlohmann::json;

json reportOf(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "bench");
    arguments.insert(arguments.end(), {"--json", "-"});
    const test::ProgramRun run = test::runProgram(arguments);
    EXPECT_EQ(run.exitCode, 0) << run.err;
    json report = json::parse(run.out, nullptr, false);
    EXPECT_FALSE(report.is_discarded()) << run.out;
    return report;
}

void expectKeys(const json& object, const std::vector<std::string>& keys) {
    for (const std::string& key : keys) {
        EXPECT_TRUE(object.contains(key)) << key << " is missing in " << object.dump();
    }
}

using BenchReport = test::ProgramTest;

TEST_F(BenchReport, Rays) {
    const json report = reportOf({"rays", "--triangles", "2000", "--size", "16", "--turns", "1"});
    expectKeys(report, {"mesh", "triangles", "threads", "turns", "embree", "embree_robust", "rows", "build",
                        "rays", "disagreements", "disagreements_by_kind"});
    ASSERT_EQ(report["rows"].size(), 3u);
    const char* const names[] = {"primary", "diffuse", "shadow"};
    for (size_t i = 0; i < 3; ++i) {
        expectKeys(report["rows"][i], {"name", "glint_mrays_per_s", "embree_mrays_per_s", "ratio"});
        EXPECT_EQ(report["rows"][i]["name"], names[i]);
        EXPECT_GT(report["rows"][i]["glint_mrays_per_s"].get<double>(), 0.0);
    }
    expectKeys(report["build"], {"glint_mtris_per_s", "embree_mtris_per_s", "ratio", "bytes_per_triangle"});
    EXPECT_TRUE(report["disagreements"].is_number_unsigned());
}

TEST_F(BenchReport, Paths) {
    const json report = reportOf({"paths", "--size", "16", "--passes", "1"});
    expectKeys(report, {"scene", "kernel", "threads", "passes", "paths_per_pass", "mpaths_per_s",
                        "mpaths_per_s_fastest", "mrays_per_s", "rays_per_path", "ns_per_ray_and_thread",
                        "relative_error"});
    EXPECT_EQ(report["paths_per_pass"], 256.0);
}

TEST_F(BenchReport, Passes) {
    for (const char* lookup : {"grid", "tree"}) {
        const json report =
            reportOf({"passes", "--size", "16", "--passes", "1", "--photons", "500", "--lookup", lookup});
        expectKeys(report, {"scene", "kernel", "lookup", "width", "height", "threads", "passes",
                            "photons_per_pass", "passes_per_s", "pass", "stages_ms", "gather_share",
                            "stored_photons", "photon_bytes", "pixel_bytes"});
        expectKeys(report["pass"], {"count", "median_ms", "p95_ms", "max_ms"});
        expectKeys(report["stages_ms"], {"camera", "photons", "sort", "gather", "commit"});
        EXPECT_EQ(report["lookup"], lookup);
        EXPECT_EQ(report["photons_per_pass"], 500);
        EXPECT_GT(report["stored_photons"].get<int>(), 0);
    }
}

TEST_F(BenchReport, Latency) {
    const json report = reportOf({"latency", "--edits", "1", "--size", "32", "--triangles", "500"});
    expectKeys(report, {"size", "rows"});
    ASSERT_FALSE(report["rows"].empty());
    for (const json& row : report["rows"]) {
        expectKeys(row, {"name", "cancel", "edit_to_picture"});
        expectKeys(row["cancel"], {"count", "median_ms", "p95_ms", "max_ms"});
        expectKeys(row["edit_to_picture"], {"count", "median_ms", "p95_ms", "max_ms"});
    }
    EXPECT_EQ(report["window"]["objects"], 10000);
    EXPECT_GT(report["window"]["ui"]["count"].get<int>(), 200) << report["window"];
}

TEST_F(BenchReport, Load) {
    const json report = reportOf({"load", "--triangles", "500"});
    expectKeys(report, {"triangles", "file_bytes", "read_seconds", "first_frame_seconds", "build_seconds",
                        "first_picture_seconds", "total_seconds"});
    EXPECT_GE(report["triangles"].get<int>(), 400);
}

TEST_F(BenchReport, Threads) {
    const json report = reportOf({"threads", "--size", "16", "--turns", "1"});
    expectKeys(report, {"size", "threads", "turns", "one_passes_per_s", "many_passes_per_s", "ratio",
                        "ratio_low", "ratio_high", "films_identical"});
    EXPECT_EQ(report["films_identical"], true);
}

TEST_F(BenchReport, Variants) {
    const json report = reportOf({"variants", "--size", "16", "--turns", "2"});
    expectKeys(report, {"scene", "width", "height", "threads", "turns", "rows"});
    ASSERT_EQ(report["rows"].size(), 2u);
    for (const json& row : report["rows"]) {
        expectKeys(row, {"integrator", "kernel", "passes_per_s", "full_passes_per_s", "ratio", "wall_ratio",
                         "pixels", "pixels_different", "largest_difference", "identical"});
        expectKeys(row["ratio"], {"median", "low", "high", "confidence"});
        EXPECT_LE(row["ratio"]["low"].get<double>(), row["ratio"]["high"].get<double>());
        EXPECT_EQ(row["pixels"], 256);
    }
    EXPECT_EQ(report["rows"][0]["integrator"], "path");
    EXPECT_EQ(report["rows"][1]["integrator"], "sppm");
    EXPECT_NE(report["rows"][0]["kernel"], "full");
}

TEST_F(BenchReport, Accel) {
    const json report = reportOf({"accel", "--triangles", "1000", "--size", "16", "--turns", "1"});
    expectKeys(report, {"threads", "turns", "scenes"});
    ASSERT_EQ(report["scenes"].size(), 2u);
    const char* const names[] = {"none", "aabb", "kdtree", "bvh"};
    for (const json& scene : report["scenes"]) {
        ASSERT_EQ(scene["rows"].size(), 4u) << scene["scene"];
        for (size_t i = 0; i < 4; ++i) {
            const json& row = scene["rows"][i];
            expectKeys(row, {"accelerator", "build_seconds", "paths_per_s", "ratio_to_none",
                             "boxes_per_camera_ray", "triangles_per_camera_ray", "pixels_different"});
            EXPECT_EQ(row["accelerator"], names[i]);
            EXPECT_EQ(row["pixels_different"], 0);
            if (i == 0) { continue; }
            EXPECT_LT(row["triangles_per_camera_ray"], scene["rows"][0]["triangles_per_camera_ray"]);
        }
    }
}

TEST_F(BenchReport, AccelOfFiles) {
    const std::string scenes = GLINT_SOURCE_DIR "/scenes/";
    const json report =
        reportOf({"accel", scenes + "furnace.json", scenes + "cornell.json", "--size", "16", "--turns", "1"});
    ASSERT_EQ(report["scenes"].size(), 2u);
    EXPECT_EQ(report["scenes"][1]["scene"], scenes + "cornell.json");
}

TEST_F(BenchReport, VariantsOfAFile) {
    const json report = reportOf({"variants", GLINT_SOURCE_DIR "/scenes/furnace.json", "--size", "48",
                                  "--turns", "1", "--integrator", "path"});
    ASSERT_EQ(report["rows"].size(), 1u);
    EXPECT_EQ(report["width"], 48);
    EXPECT_EQ(report["height"], 32);
}

}  // namespace
}  // namespace glint
