#include "tests/support/chi_square.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "engine/math/rng.h"

namespace glint::test {
namespace {

/// P(a, x) by its power series; for x < a + 1.
double lowerGammaSeries(double a, double x) {
    double term = 1.0 / a;
    double sum = term;
    for (int n = 1; n < 10000 && term > sum * 1e-16; ++n) {
        term *= x / (a + n);
        sum += term;
    }
    return sum * std::exp(-x + a * std::log(x) - std::lgamma(a));
}

/// Q(a, x) by Lentz's continued fraction; for x >= a + 1.
double upperGammaFraction(double a, double x) {
    constexpr double kTiny = 1e-300;
    double b = x + 1.0 - a;
    double c = 1.0 / kTiny;
    double d = 1.0 / b;
    double h = d;
    for (int n = 1; n < 10000; ++n) {
        const double an = -n * (n - a);
        b += 2.0;
        d = 1.0 / (std::fabs(an * d + b) < kTiny ? kTiny : an * d + b);
        c = std::fabs(b + an / c) < kTiny ? kTiny : b + an / c;
        h *= d * c;
        if (std::fabs(d * c - 1.0) < 1e-15) { break; }
    }
    return h * std::exp(-x + a * std::log(x) - std::lgamma(a));
}

}  // namespace

double sidakLevel(double familyLevel, int tests) { return -std::expm1(std::log1p(-familyLevel) / tests); }

double chiSquareTail(double statistic, int degrees) {
    if (degrees <= 0 || statistic <= 0.0) { return 1.0; }
    const double a = 0.5 * degrees;
    const double x = 0.5 * statistic;
    return x < a + 1.0 ? 1.0 - lowerGammaSeries(a, x) : upperGammaFraction(a, x);
}

double normalTail(double deviate) { return std::erfc(std::fabs(deviate) / std::sqrt(2.0)); }

ChiSquare chiSquare(const std::vector<double>& observed, const std::vector<double>& expected) {
    std::vector<size_t> order(expected.size());
    std::iota(order.begin(), order.end(), size_t{0});
    std::sort(order.begin(), order.end(), [&](size_t a, size_t b) { return expected[a] < expected[b]; });

    ChiSquare result;
    int bins = 0;
    double pooledObserved = 0.0;
    double pooledExpected = 0.0;
    for (size_t i = 0; i < order.size(); ++i) {
        pooledObserved += observed[order[i]];
        pooledExpected += std::max(expected[order[i]], 0.0);
        if (pooledExpected < 5.0 && i + 1 < order.size()) { continue; }
        if (pooledExpected > 1e-3) {
            const double difference = pooledObserved - pooledExpected;
            result.statistic += difference * difference / pooledExpected;
            ++bins;
        } else if (pooledObserved > 0.0) {
            result.statistic = std::numeric_limits<double>::infinity();
        }
        pooledObserved = pooledExpected = 0.0;
    }
    result.degrees = std::max(bins - 1, 0);
    result.pValue = std::isinf(result.statistic) ? 0.0 : chiSquareTail(result.statistic, result.degrees);
    return result;
}

uint64_t Random::bits() { return mixBits(state_ += 0x9e3779b97f4a7c15ull); }
float Random::uniform() { return uniformFloat(static_cast<uint32_t>(bits() >> 32)); }
Vec2 Random::uniform2() {
    const float x = uniform();
    return {x, uniform()};
}

void Mean::add(double value) {
    ++count_;
    const double delta = value - mean_;
    mean_ += delta / static_cast<double>(count_);
    squares_ += delta * (value - mean_);
}

double Mean::standardError() const {
    return count_ < 2 ? std::numeric_limits<double>::infinity()
                      : std::sqrt(squares_ / static_cast<double>(count_ - 1) / static_cast<double>(count_));
}

}  // namespace glint::test
