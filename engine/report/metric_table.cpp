// In the order in which reports list them.
#include "engine/report/metric_table.h"

namespace glint {
namespace {

using M = ImageMetrics;

constexpr MetricInfo kTable[] = {
    {"picture_error", "picture-error", "picture error", [](const M& m) { return m.pictureError; }},
    {"mse", "mse", "MSE", [](const M& m) { return m.mse; }},
    {"rmse", "rmse", "RMSE", [](const M& m) { return m.rmse; }},
    {"rel_mse", "relmse", "relMSE", [](const M& m) { return m.relMse; }},
    {"rel_mse_trimmed", "relmse-trimmed", "relMSE trimmed", [](const M& m) { return m.relMseTrimmed; }},
    {"relative_rmse", "relative-rmse", "relative RMSE", [](const M& m) { return m.relativeRmse(); }},
    {"mape", "mape", "MAPE", [](const M& m) { return m.mape; }},
    {"bias", "bias", "bias", [](const M& m) { return m.bias; }, true},
    {"relative_bias", "relative-bias", "relative bias", [](const M& m) { return m.relativeBias; }, true},
    {"max_error", "error", "largest error", [](const M& m) { return m.maxError; }},
    {"ssim", "ssim", "SSIM", [](const M& m) { return m.ssim; }, false, true},
    {"flip", "flip", "FLIP", [](const M& m) { return m.flip; }},
    {"hdr_flip", "hdr-flip", "HDR-FLIP", [](const M& m) { return m.hdrFlip; }},
};

}  // namespace

std::span<const MetricInfo> metricTable() { return kTable; }

const MetricInfo* findMetric(std::string_view key) {
    for (const MetricInfo& metric : kTable) {
        if (key == metric.key) { return &metric; }
    }
    return nullptr;
}

}  // namespace glint
