// Horizontal pass into a plane of floats, then the vertical one, row by row with double accumulators.
#include "engine/report/plane_filter.h"

#include <algorithm>
#include <cmath>

#include "engine/base/parallel.h"

namespace glint {
namespace {

/// Enough work for a thread to be worth waking.

/// Calls body(y) for every row.
template <class Body>
void forRows(int width, int height, int threads, const Body& body) {
    parallelChunks(height, std::max<int64_t>(1, kPixelsPerChunk / width), threads,
                   [&](int64_t begin, int64_t end) {
                       for (int64_t y = begin; y < end; ++y) {
                           body(static_cast<int>(y));
                       }
                   });
}

void filterRow(const float* in, int width, std::span<const double> weights, float* out) {
    const int radius = static_cast<int>(weights.size() / 2);
    std::vector<float> padded(static_cast<size_t>(width) + 2 * static_cast<size_t>(radius));
    std::fill_n(padded.begin(), radius, in[0]);
    std::copy_n(in, width, padded.begin() + radius);
    std::fill_n(padded.end() - radius, radius, in[width - 1]);
    std::vector<double> sums(static_cast<size_t>(width), 0.0);
    for (size_t tap = 0; tap < weights.size(); ++tap) {
        for (size_t x = 0; x < sums.size(); ++x) {
            sums[x] += weights[tap] * static_cast<double>(padded[x + tap]);
        }
    }
    std::transform(sums.begin(), sums.end(), out, [](double sum) { return static_cast<float>(sum); });
}

void filterColumns(const Plane& in, int y, std::span<const double> weights, float* out) {
    const int radius = static_cast<int>(weights.size() / 2);
    const auto width = static_cast<size_t>(in.width);
    std::vector<double> sums(width, 0.0);
    for (int tap = 0; tap < static_cast<int>(weights.size()); ++tap) {
        const int row = std::clamp(y + tap - radius, 0, in.height - 1);
        const float* values = in.values.data() + static_cast<size_t>(row) * width;
        const double weight = weights[static_cast<size_t>(tap)];
        for (size_t x = 0; x < width; ++x) {
            sums[x] += weight * static_cast<double>(values[x]);
        }
    }
    std::transform(sums.begin(), sums.end(), out, [](double sum) { return static_cast<float>(sum); });
}

}  // namespace

Plane filterSeparable(const Plane& in, std::span<const double> row, std::span<const double> column,
                      int threads) {
    Plane across{.width = in.width, .height = in.height, .values = std::vector<float>(in.values.size())};
    Plane out = across;
    const auto width = static_cast<size_t>(in.width);
    forRows(in.width, in.height, threads, [&](int y) {
        const size_t first = static_cast<size_t>(y) * width;
        filterRow(in.values.data() + first, in.width, row, across.values.data() + first);
    });
    forRows(in.width, in.height, threads, [&](int y) {
        filterColumns(across, y, column, out.values.data() + static_cast<size_t>(y) * width);
    });
    return out;
}

std::vector<double> gaussianWeights(double deviation, int radius) {
    std::vector<double> weights;
    double sum = 0.0;
    for (int x = -radius; x <= radius; ++x) {
        weights.push_back(std::exp(-0.5 * x * x / (deviation * deviation)));
        sum += weights.back();
    }
    for (double& weight : weights) {
        weight /= sum;
    }
    return weights;
}

}  // namespace glint
