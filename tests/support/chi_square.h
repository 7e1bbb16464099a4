// Statistical tests with fixed seeds: chi-square of counts against expectations, family-wise significance,
// and uniform random numbers that are independent of the samplers under test.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/math/vec.h"

namespace glint::test {

/// Every statistical test file rejects wrongly with this probability at most, over all its cases together.
constexpr double kFamilyLevel = 1e-3;

/// The level of one of `tests` cases so that all together keep `familyLevel` (Sidak 1967).
double sidakLevel(double familyLevel, int tests);

struct ChiSquare {
    double statistic = 0.0;
    int degrees = 0;  ///< of freedom; 0: too few expected counts to test anything
    double pValue = 1.0;
};

/// Pearson's test. Both arrays cover all outcomes and have the same sum. Bins with less than 5 expected
/// counts are pooled; a pool that expects (nearly) nothing but observes something gives p = 0.
ChiSquare chiSquare(const std::vector<double>& observed, const std::vector<double>& expected);

/// The upper tail of the chi-square distribution.
double chiSquareTail(double statistic, int degrees);

/// Two-sided p-value of a standard normal deviate.
double normalTail(double deviate);

/// SplitMix64 numbers in [0, 1).
class Random {
  public:
    explicit Random(uint64_t seed) : state_(seed) {}
    uint64_t bits();
    float uniform();
    Vec2 uniform2();

  private:
    uint64_t state_;
};

/// Running mean and the standard error of the mean (Welford 1962).
class Mean {
  public:
    void add(double value);
    double mean() const { return mean_; }
    double standardError() const;
    int64_t count() const { return count_; }

  private:
    int64_t count_ = 0;
    double mean_ = 0.0;
    double squares_ = 0.0;
};

}  // namespace glint::test
