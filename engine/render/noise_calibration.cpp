// The picture against itself at half of its passes.
//
// With n passes in two halves a and b, the difference d of the whole's mean from a's is (b - a) / 2. Where
// passes are independent, E d^2 is the variance V of the whole's mean. Where V falls like n^-s, E d^2 =
// V(n/2) - V(n) = (2^s - 1) V(n). Low-discrepancy passes start like independent ones, so that after k
// doublings the ratio r of E d^2 to the independent V has fallen to 2^(-(s - 1) k); which gives s, and V is r
// / (2^s - 1) of the independent one.
#include "engine/render/noise_calibration.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

#include "engine/base/parallel.h"
#include "engine/math/vec.h"
#include "engine/render/error_estimate.h"
#include "engine/render/error_sums.h"
#include "engine/render/film.h"
#include "engine/render/image_statistics.h"

namespace glint {
namespace {

constexpr int64_t kPixelsPerClassSum = 16384;
constexpr double kLeastRatio = 1e-3;
constexpr double kGreatestRatio = 1.5;
/// Neighbours that are further apart than this are taken to err independently.
constexpr int kMaxLag = 8;

struct ClassSums {
    double difference = 0.0;  ///< sum of d^2
    double expected = 0.0;    ///< the same if passes were independent
    double pixels = 0.0;

    void add(const ClassSums& other) {
        difference += other.difference;
        expected += other.expected;
        pixels += other.pixels;
    }
};

using AllClasses = std::array<ClassSums, NoiseCalibration::kClasses>;

double factorFromRatio(double ratio, double doublings) {
    return ratio / (2.0 * std::pow(ratio, -1.0 / doublings) - 1.0);
}

}  // namespace

int NoiseCalibration::classOf(double variancePerPass) const {
    const double relative = variancePerPass / square(meanLuminance);
    if (!(relative > 0.0)) { return 0; }
    // As std::ilogb, which is a call for every pixel; infinity has the largest exponent.
    const int exponent = static_cast<int>(std::bit_cast<uint64_t>(relative) >> 52) - 1023;
    return std::clamp(exponent - kLowestExponent, 0, kClasses - 1);
}

class NoiseCalibrator {
  public:
    NoiseCalibrator(const ImageStatistics* statistics, double decay, int threads, Film* film)
        : statistics_(statistics),
          film_(*film),
          threads_(threads),
          photonShare_(std::pow(2.0, decay) - 1.0) {}

    void run() {
        NoiseCalibration next;
        next.passes = film_.passes_;
        next.meanLuminance = meanLuminance();
        if (film_.calibration_.passes * 2 == film_.passes_) {
            setFactors(sumClasses(next), &next);
            next.correlatedPixels = statistics_ ? correlatedPixels() : 1.0;
        } else {
            next.factors.fill(1.0);
        }
        parallelChunks(pixels(), kPixelsPerClassSum, threads_, [&](int64_t begin, int64_t end) {
            for (auto i = static_cast<size_t>(begin); i < static_cast<size_t>(end); ++i) {
                film_.pixels_[i].halfSampleMean = static_cast<float>(pixelLuminance(film_, statistics_, i));
            }
        });
        film_.calibration_ = next;
    }

  private:
    int64_t pixels() const { return static_cast<int64_t>(film_.pixels_.size()); }
    size_t chunks() const {
        return static_cast<size_t>((pixels() + kPixelsPerClassSum - 1) / kPixelsPerClassSum);
    }

    double meanLuminance() const {
        std::vector<double> partial(chunks());
        parallelChunks(pixels(), kPixelsPerClassSum, threads_, [&](int64_t begin, int64_t end) {
            double sum = 0.0;
            for (auto i = static_cast<size_t>(begin); i < static_cast<size_t>(end); ++i) {
                sum += pixelLuminance(film_, statistics_, i);
            }
            partial[static_cast<size_t>(begin / kPixelsPerClassSum)] = sum;
        });
        double total = 0.0;
        for (const double sum : partial) {
            total += sum;
        }
        return total / static_cast<double>(pixels());
    }

    double difference(size_t i) const {
        return pixelLuminance(film_, statistics_, i) - static_cast<double>(film_.pixels_[i].halfSampleMean);
    }

    /// Variance of the pixel's mean as if passes were independent: the whole's, and the photons' share.
    std::pair<double, double> independentVariance(size_t i) const {
        const FilmPixel& pixel = film_.pixels_[i];
        const double direct = pixel.count > 1 ? square(film_.standardError(pixel)) : 0.0;
        const double photons = statistics_ ? square(statistics_->standardErrorOf(i)) : 0.0;
        return {direct + photons, photons};
    }

    AllClasses sumClasses(const NoiseCalibration& classes) const {
        std::vector<AllClasses> partial(chunks());
        parallelChunks(pixels(), kPixelsPerClassSum, threads_, [&](int64_t begin, int64_t end) {
            AllClasses& sums = partial[static_cast<size_t>(begin / kPixelsPerClassSum)];
            for (auto i = static_cast<size_t>(begin); i < static_cast<size_t>(end); ++i) {
                // What regions left out has not doubled its samples.
                if (film_.pixels_[i].count != film_.passes_) { continue; }
                const auto [variance, photons] = independentVariance(i);
                // As the radius shrinks, the photons' variance falls like passes^-alpha only.
                const double expected = variance - photons + photonShare_ * photons;
                const int own = classes.classOf(variance * film_.passes_);
                sums[static_cast<size_t>(own)].add({square(difference(i)), expected, 1.0});
            }
        });
        for (size_t chunk = 1; chunk < partial.size(); ++chunk) {
            for (size_t i = 0; i < partial[0].size(); ++i) {
                partial[0][i].add(partial[chunk][i]);
            }
        }
        return partial[0];
    }

    void setFactors(const AllClasses& classes, NoiseCalibration* out) const {
        ClassSums all;
        for (const ClassSums& own : classes) {
            all.add(own);
        }
        const double overall =
            all.expected > 0.0 ? std::min(kGreatestRatio, all.difference / all.expected) : 1.0;
        const double doublings = std::log2(static_cast<double>(film_.passes_));
        for (size_t i = 0; i < classes.size(); ++i) {
            const ClassSums& own = classes[i];
            double ratio = overall;
            if (own.expected > 0.0) {
                const double prior = kClassPriorPixels * own.expected / own.pixels;
                ratio = (own.difference + prior * overall) / (own.expected + prior);
            }
            out->factors[i] = factorFromRatio(std::clamp(ratio, kLeastRatio, kGreatestRatio), doublings);
        }
    }

    /// One plus the squared correlations of a pixel's difference with its neighbours', summed over the plane
    /// as if they were the same in every direction.
    double correlatedPixels() const {
        std::vector<double> scaled(film_.pixels_.size());
        double squares = 0.0;
        for (size_t i = 0; i < scaled.size(); ++i) {
            const double variance = independentVariance(i).first;
            scaled[i] = variance > 0.0 ? difference(i) / std::sqrt(variance) : 0.0;
            squares += square(scaled[i]);
        }
        if (!(squares > 0.0)) { return 1.0; }
        const auto width = static_cast<size_t>(film_.width_);
        double sum = 1.0;
        for (size_t lag = 1; lag <= kMaxLag; ++lag) {
            double products = 0.0;
            for (size_t i = 0; i < scaled.size(); ++i) {
                const bool hasRight = i % width + lag < width;
                const bool hasBelow = i + lag * width < scaled.size();
                products += 0.5 * scaled[i] *
                            ((hasRight ? scaled[i + lag] : 0.0) + (hasBelow ? scaled[i + lag * width] : 0.0));
            }
            // What chance alone gives is taken off.
            const double chance = 1.0 / static_cast<double>(scaled.size());
            const double correlation = square(products / squares) - chance;
            sum += 2.0 * 3.14159265358979323846 * static_cast<double>(lag) * std::max(0.0, correlation);
        }
        return sum;
    }

    const ImageStatistics* statistics_;
    Film& film_;
    int threads_;
    double photonShare_;
};

void calibrateNoise(const ImageStatistics* statistics, double decay, int threads, Film* film) {
    if (film->passes() >= 2 && std::has_single_bit(film->passes()) && !film->pixels().empty()) {
        NoiseCalibrator(statistics && statistics->passCount() > 0 ? statistics : nullptr, decay, threads,
                        film)
            .run();
    }
}

}  // namespace glint
