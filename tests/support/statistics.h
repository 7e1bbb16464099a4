// Statistics that tests decide by: Pearson's chi-square with a given significance, and running means with
// their errors.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

namespace glint::test {

/// The value a standard normal variable exceeds with probability 1e-6: the significance of each single check
/// here. Seeds are fixed, so a check that passes once passes always; the level says how surprised to be by a
/// first failure.
constexpr double kNormalQuantile = 4.753;

struct ChiSquare {
    double statistic = 0.0;
    int degrees = 0;

    /// The statistic's quantile at significance 1e-6 (Wilson and Hilferty 1931).
    double critical() const {
        const double k = 2.0 / (9.0 * degrees);
        const double root = 1.0 - k + kNormalQuantile * std::sqrt(k);
        return degrees * root * root * root;
    }
    bool passes() const { return degrees > 0 && statistic <= critical(); }
};

/// Counts against expected counts of the same total. Cells that expect fewer than five are pooled; a count in
/// a cell that expects nothing fails unless `strays` of them in all are allowed (rounding at edges).
ChiSquare chiSquare(const std::vector<double>& counts, const std::vector<double>& expected,
                    double strays = 0.0);

/// P(X <= k) of a binomial variable of n trials.
double binomialAtMost(int k, int n, double p);

/// Mean and its standard error (Welford 1962).
class RunningMean {
  public:
    void add(double x) {
        ++count_;
        const double delta = x - mean_;
        mean_ += delta / static_cast<double>(count_);
        m2_ += delta * (x - mean_);
    }
    int64_t count() const { return count_; }
    double mean() const { return mean_; }
    double variance() const { return count_ > 1 ? m2_ / static_cast<double>(count_ - 1) : 0.0; }
    double standardError() const { return std::sqrt(variance() / static_cast<double>(count_)); }

  private:
    int64_t count_ = 0;
    double mean_ = 0.0;
    double m2_ = 0.0;
};

}  // namespace glint::test
