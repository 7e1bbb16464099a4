// Every hit of the ray benchmark beside Embree's: what differs must be rounding.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "viewer/bench/bench_rays.h"

namespace glint {
namespace {

TEST(EmbreeOracle, DifferencesAreRoundingOnly) {
    for (const char* name : {"blob", "sphere", "cube"}) {
        BenchRaysOptions options;
        options.generator = name;
        options.triangles = 50'000;
        options.width = 256;
        options.turns = 1;
        const auto report = measureRays(options);
        ASSERT_TRUE(report.ok());
        ASSERT_EQ(report->rows.size(), 3u);
        if (!report->hasEmbree) { GTEST_SKIP() << "compiled without Embree"; }
        EXPECT_GE(report->raysCompared, uint64_t{3 * 256 * 256}) << "every ray of a closed mesh hits";
        EXPECT_EQ(report->disagreements[static_cast<size_t>(RayDisagreement::Unexplained)], 0u) << name;
        EXPECT_EQ(report->disagreements[static_cast<size_t>(RayDisagreement::DistanceDrift)], 0u) << name;
        EXPECT_LT(report->disagreementCount(), report->raysCompared / 1000) << name;
    }
}

TEST(BenchRays, TheJsonHasItsDocumentedKeys) {
    BenchRaysOptions options;
    options.triangles = 2000;
    options.width = 16;
    options.turns = 1;
    const auto report = measureRays(options);
    ASSERT_TRUE(report.ok());
    const auto json = benchRaysJson(*report);
    for (const auto& row : json.at("rows")) {
        EXPECT_TRUE(row.contains("name") && row.contains("embree_mrays_per_s") && row.contains("ratio"));
        EXPECT_GT(row.at("glint_mrays_per_s").get<double>(), 0.0);
    }
    EXPECT_GT(json.at("build").at("glint_mtris_per_s").get<double>(), 0.0);
    EXPECT_TRUE(json.contains("disagreements"));
    EXPECT_NE(benchRaysText(*report).find("primary"), std::string::npos);
}

TEST(BenchRays, AnUnknownMeshIsRefused) {
    BenchRaysOptions options;
    options.generator = "blobb";
    EXPECT_FALSE(measureRays(options).ok());
}

}  // namespace
}  // namespace glint
