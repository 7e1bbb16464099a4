// Welford's update, pixel by pixel, and the error estimate. Work is cut into chunks of fixed size whose
// partial sums are joined in order, so that no bit depends on the number of threads.
#include "engine/render/film.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/base/check.h"
#include "engine/base/parallel.h"

namespace glint {
namespace {

constexpr int64_t kPixelsPerTally = 16384;

double luminanceOf(double r, double g, double b) { return 0.2126 * r + 0.7152 * g + 0.0722 * b; }

double luminanceOf(const std::array<double, 3>& rgb) { return luminanceOf(rgb[0], rgb[1], rgb[2]); }

size_t chunkCount(size_t pixels) { return (pixels + kPixelsPerTally - 1) / kPixelsPerTally; }

/// Welford 1962: mean_n = mean_(n-1) + (x - mean_(n-1)) / n, M_n = M_(n-1) + (x - mean_(n-1)) (x - mean_n).
void addSample(const Vec3& radiance, FilmPixel* pixel) {
    const double before = luminanceOf(pixel->mean);
    const glm::dvec3 value(radiance);
    ++pixel->count;
    for (int c = 0; c < 3; ++c) {
        pixel->mean[c] += (value[c] - pixel->mean[c]) / pixel->count;
    }
    const double sample = luminanceOf(value[0], value[1], value[2]);
    pixel->luminanceM2 += (sample - before) * (sample - luminanceOf(pixel->mean));
}

struct ChunkTally {
    uint64_t rays = 0;
    std::array<uint64_t, kSampleFaultCount> faults{};
};

}  // namespace

Film::Film(int width, int height)
    : width_(width), height_(height), pixels_(static_cast<size_t>(width) * static_cast<size_t>(height)) {}

void Film::clear() {
    passes_ = 0;
    rays_ = 0;
    faultCounts_ = {};
    faults_.clear();
    calibration_ = {};
    std::fill(pixels_.begin(), pixels_.end(), FilmPixel{});
}

bool Film::isOutside(const FilmRegion* region, size_t index) const {
    if (region == nullptr) { return false; }
    const auto width = static_cast<size_t>(width_);
    return !region->contains(static_cast<int>(index % width), static_cast<int>(index / width));
}

void Film::commit(const std::vector<PixelSample>& samples, uint32_t passIndex, int threads,
                  const FilmRegion* region) {
    GLINT_CHECK_OP(samples.size(), ==, pixels_.size());
    std::vector<ChunkTally> tallies(chunkCount(pixels_.size()));
    parallelChunks(static_cast<int64_t>(pixels_.size()), kPixelsPerTally, threads,
                   [&](int64_t begin, int64_t end) {
                       ChunkTally& tally = tallies[begin / kPixelsPerTally];
                       for (int64_t i = begin; i < end; ++i) {
                           if (isOutside(region, static_cast<size_t>(i))) { continue; }
                           const PixelSample& sample = samples[i];
                           tally.rays += sample.rays;
                           if (sample.fault == SampleFault::None) {
                               addSample(sample.radiance, &pixels_[i]);
                           } else {
                               ++tally.faults[static_cast<size_t>(sample.fault)];
                           }
                       }
                   });
    ++passes_;
    for (size_t chunk = 0; chunk < tallies.size(); ++chunk) {
        rays_ += tallies[chunk].rays;
        uint64_t faultsHere = 0;
        for (int fault = 0; fault < kSampleFaultCount; ++fault) {
            faultCounts_[fault] += tallies[chunk].faults[fault];
            faultsHere += tallies[chunk].faults[fault];
        }
        if (faultsHere > 0) { recordFaults(samples, chunk * kPixelsPerTally, passIndex, region); }
    }
}

void Film::recordFaults(const std::vector<PixelSample>& samples, size_t begin, uint32_t passIndex,
                        const FilmRegion* region) {
    const size_t end = std::min(samples.size(), begin + kPixelsPerTally);
    for (size_t i = begin; i < end && faults_.size() < kMaxFaultRecords; ++i) {
        if (samples[i].fault != SampleFault::None && !isOutside(region, i)) {
            const int index = static_cast<int>(i);
            faults_.push_back({samples[i].fault, index % width_, index / width_, passIndex});
        }
    }
}

double Film::standardError(const FilmPixel& pixel) const {
    if (pixel.count < 2) { return std::numeric_limits<double>::infinity(); }
    const double n = pixel.count;
    return std::sqrt(std::max(0.0, pixel.luminanceM2) / ((n - 1.0) * n));
}

double Film::relativeErrorEstimate(int threads) const {
    if (passes_ < 2 || pixels_.empty()) { return std::numeric_limits<double>::infinity(); }
    struct Sums {
        double squaredError = 0.0;
        double luminance = 0.0;
    };
    std::vector<Sums> partial(chunkCount(pixels_.size()));
    parallelChunks(static_cast<int64_t>(pixels_.size()), kPixelsPerTally, threads,
                   [&](int64_t begin, int64_t end) {
                       Sums sums;
                       for (int64_t i = begin; i < end; ++i) {
                           const double error = standardError(pixels_[i]);
                           sums.squaredError += error * error;
                           sums.luminance += luminanceOf(pixels_[i].mean);
                       }
                       partial[begin / kPixelsPerTally] = sums;
                   });
    Sums total;
    for (const Sums& sums : partial) {
        total.squaredError += sums.squaredError;
        total.luminance += sums.luminance;
    }
    if (total.squaredError == 0.0) { return 0.0; }
    const double count = static_cast<double>(pixels_.size());
    return std::sqrt(total.squaredError / count) / (total.luminance / count);
}

size_t Film::bytes() const { return bytesFor(width_, height_) + faults_.capacity() * sizeof(FaultRecord); }

size_t Film::bytesFor(int width, int height) {
    return static_cast<size_t>(width) * static_cast<size_t>(height) * sizeof(FilmPixel);
}

size_t AovFilm::bytesFor(int width, int height) {
    return static_cast<size_t>(width) * static_cast<size_t>(height) * sizeof(AovSample);
}

AovFilm::AovFilm(int width, int height)
    : width_(width), height_(height), pixels_(static_cast<size_t>(width) * static_cast<size_t>(height)) {}

void AovFilm::clear() {
    passes_ = 0;
    std::fill(pixels_.begin(), pixels_.end(), AovSample{});
}

void AovFilm::commit(const std::vector<AovSample>& samples, int threads) {
    GLINT_CHECK_OP(samples.size(), ==, pixels_.size());
    const bool first = passes_ == 0;
    ++passes_;
    const float weight = 1.0f / static_cast<float>(passes_);
    parallelChunks(
        static_cast<int64_t>(pixels_.size()), kPixelsPerTally, threads, [&](int64_t begin, int64_t end) {
            for (int64_t i = begin; i < end; ++i) {
                const AovSample& sample = samples[i];
                AovSample& mean = pixels_[i];
                if (first) {
                    mean = sample;
                    continue;
                }
                mean.albedo += (sample.albedo - mean.albedo) * weight;
                mean.shadingNormal += (sample.shadingNormal - mean.shadingNormal) * weight;
                mean.geometricNormal += (sample.geometricNormal - mean.geometricNormal) * weight;
                mean.depth += (sample.depth - mean.depth) * weight;
                mean.boxesTested += (sample.boxesTested - mean.boxesTested) * weight;
                mean.newtonSteps += (sample.newtonSteps - mean.newtonSteps) * weight;
                mean.primitivesTested += (sample.primitivesTested - mean.primitivesTested) * weight;
            }
        });
}

}  // namespace glint
