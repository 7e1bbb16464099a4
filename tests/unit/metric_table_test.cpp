// The table of metrics: unique names, every figure in it, and each value the right member.
#include "engine/report/metric_table.h"

#include <set>
#include <string>

#include <gtest/gtest.h>

namespace glint {
namespace {

TEST(MetricTable, NamesAreUniqueAndFound) {
    std::set<std::string> keys, options, names;
    for (const MetricInfo& metric : metricTable()) {
        EXPECT_TRUE(keys.insert(metric.key).second) << metric.key;
        EXPECT_TRUE(options.insert(metric.option).second) << metric.option;
        EXPECT_TRUE(names.insert(metric.name).second) << metric.name;
        EXPECT_EQ(findMetric(metric.key), &metric);
    }
    EXPECT_EQ(findMetric("psnr"), nullptr);
}

TEST(MetricTable, ValuesAreTheMembers) {
    const ImageMetrics m{.mse = 1.0,
                         .rmse = 2.0,
                         .relMse = 9.0,
                         .relMseTrimmed = 4.0,
                         .mape = 5.0,
                         .bias = -6.0,
                         .relativeBias = -7.0,
                         .pictureError = 0.125,
                         .maxError = 8.0,
                         .ssim = 0.5,
                         .flip = 0.25,
                         .hdrFlip = 0.75};
    const std::pair<const char*, double> expected[] = {
        {"picture_error", 0.125}, {"mse", 1.0},           {"rmse", 2.0}, {"rel_mse", 9.0},
        {"rel_mse_trimmed", 4.0}, {"relative_rmse", 3.0}, {"mape", 5.0}, {"bias", -6.0},
        {"relative_bias", -7.0},  {"max_error", 8.0},     {"ssim", 0.5}, {"flip", 0.25},
        {"hdr_flip", 0.75}};
    EXPECT_EQ(metricTable().size(), std::size(expected));
    for (const auto& [key, value] : expected) {
        ASSERT_NE(findMetric(key), nullptr) << key;
        EXPECT_EQ(findMetric(key)->value(m), value) << key;
    }
}

TEST(MetricTable, PerfectValues) {
    const ImageMetrics equal{};
    for (const MetricInfo& metric : metricTable()) {
        EXPECT_EQ(metric.value(equal), metric.largerIsBetter ? 1.0 : 0.0) << metric.key;
    }
}

}  // namespace
}  // namespace glint
