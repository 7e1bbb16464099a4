// Seconds that are measured: a stopwatch; median, 95th percentile and maximum.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace glint {

class Stopwatch {
  public:
    /// Since it was made.
    double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

  private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point start_ = Clock::now();
};

struct Percentiles {
    size_t count = 0;
    double median = 0.0;
    double p95 = 0.0;
    double max = 0.0;
};

/// Nearest-rank percentiles; all 0 without samples.
Percentiles percentilesOf(std::vector<double> samples);

/// {count, median_ms, p95_ms, max_ms}.
nlohmann::ordered_json percentilesJson(const Percentiles& seconds);
/// "median 3.1 ms, 95 % 9.0 ms, max 12.4 ms (100 samples)".
std::string percentilesText(const Percentiles& seconds);

}  // namespace glint
