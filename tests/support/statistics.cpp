#include "tests/support/statistics.h"

#include <limits>

namespace glint::test {

ChiSquare chiSquare(const std::vector<double>& counts, const std::vector<double>& expected, double strays) {
    ChiSquare result;
    double pooledCount = 0.0, pooledExpected = 0.0, strayCount = 0.0;
    int cells = 0;
    const auto addCell = [&](double count, double expectation) {
        result.statistic += (count - expectation) * (count - expectation) / expectation;
        ++cells;
    };
    for (size_t i = 0; i < counts.size(); ++i) {
        if (expected[i] <= 0.0) {
            strayCount += counts[i];
        } else if (expected[i] < 5.0) {
            pooledCount += counts[i];
            pooledExpected += expected[i];
        } else {
            addCell(counts[i], expected[i]);
        }
    }
    if (pooledExpected >= 5.0) {
        addCell(pooledCount, pooledExpected);
    } else if (pooledCount > 5.0 * (pooledExpected + 5.0)) {
        strayCount += pooledCount;
    }
    if (strayCount > strays) { result.statistic = std::numeric_limits<double>::infinity(); }
    result.degrees = cells - 1;
    return result;
}

double binomialAtMost(int k, int n, double p) {
    // Its terms are summed by their logarithms: the factorials would overflow.
    double sum = 0.0;
    for (int i = 0; i <= k; ++i) {
        sum += std::exp(std::lgamma(n + 1.0) - std::lgamma(i + 1.0) - std::lgamma(n - i + 1.0) +
                        i * std::log(p) + (n - i) * std::log1p(-p));
    }
    return sum;
}

}  // namespace glint::test
