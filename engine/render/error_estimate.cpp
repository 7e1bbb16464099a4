// Sums over the pixels in chunks of fixed size, joined in order.
#include "engine/render/error_estimate.h"

#include <cmath>
#include <cstdint>
#include <vector>

#include "engine/base/parallel.h"
#include "engine/math/color.h"
#include "engine/render/film.h"
#include "engine/render/sppm_state.h"

namespace glint {
namespace {

constexpr int64_t kChunkPixels = 16384;
/// 95 % quantile of the standard normal distribution: both ends of a 90 % band.
constexpr double kNormal95 = 1.6448536269514722;

struct Sums {
    double luminance = 0.0;
    double variance = 0.0;  ///< of the pixels' means
    double varianceSquared = 0.0;
};

double square(double x) { return x * x; }

Sums sumPixels(const Film& film, const SppmState* sppm, int64_t begin, int64_t end) {
    Sums sums;
    for (auto i = static_cast<size_t>(begin); i < static_cast<size_t>(end); ++i) {
        const FilmPixel& pixel = film.pixels()[i];
        double variance = pixel.count > 1 ? square(film.standardError(pixel)) : 0.0;
        sums.luminance += 0.2126 * pixel.mean[0] + 0.7152 * pixel.mean[1] + 0.0722 * pixel.mean[2];
        if (sppm) {
            variance += square(sppm->photonStandardError(i));
            sums.luminance += static_cast<double>(luminance(sppm->photonRadiance(i)));
        }
        sums.variance += variance;
        sums.varianceSquared += variance * variance;
    }
    return sums;
}

}  // namespace

ErrorEstimate estimateError(const Film& film, const SppmState* sppm, int threads) {
    if (sppm && sppm->passes == 0) {
        sppm = nullptr;
    }
    ErrorEstimate estimate;
    const auto pixels = static_cast<int64_t>(film.pixels().size());
    if (film.passes() < 2 || pixels == 0 || (sppm && sppm->passes < 2)) {
        return estimate;
    }
    std::vector<Sums> partial(static_cast<size_t>((pixels + kChunkPixels - 1) / kChunkPixels));
    parallelChunks(pixels, kChunkPixels, threads, [&](int64_t begin, int64_t end) {
        partial[static_cast<size_t>(begin / kChunkPixels)] = sumPixels(film, sppm, begin, end);
    });
    Sums total;
    for (const Sums& sums : partial) {
        total.luminance += sums.luminance;
        total.variance += sums.variance;
        total.varianceSquared += sums.varianceSquared;
    }
    if (total.variance == 0.0) {
        return {.relative = 0.0, .low = 0.0, .high = 0.0};
    }
    const double count = static_cast<double>(pixels);
    estimate.relative = std::sqrt(total.variance / count) / (total.luminance / count);
    // A sum of so many equal squares would scatter as this one does.
    const double effectivePixels = square(total.variance) / total.varianceSquared;
    const double spread = std::sqrt(2.0 / effectivePixels * (1.0 + 1.0 / (film.passes() - 1.0)));
    estimate.low = estimate.relative * std::exp(-0.5 * kNormal95 * spread);
    estimate.high = estimate.relative * std::exp(0.5 * kNormal95 * spread);
    return estimate;
}

}  // namespace glint
