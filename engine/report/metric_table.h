// The picture metrics as a table: one order and one set of names for reports, files and options.
//
// What they mean is metrics.h's.
#pragma once

#include <span>
#include <string_view>

#include "engine/report/metrics.h"

namespace glint {

struct MetricInfo {
    const char* key;     ///< of files: "rel_mse"
    const char* option;  ///< of command lines: "relmse", as in --max-relmse
    const char* name;    ///< for people: "relMSE"
    double (*value)(const ImageMetrics& metrics);
    bool isSigned = false;        ///< its magnitude is what should be small
    bool largerIsBetter = false;  ///< 1 is perfect; for all others 0 is
};

/// A metric that was not asked for (MetricOptions) is NaN.
std::span<const MetricInfo> metricTable();

/// The metric with that key, or null.
const MetricInfo* findMetric(std::string_view key);

}  // namespace glint
