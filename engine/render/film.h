// The accumulation buffer: a running mean and variance for each pixel over whole passes, in double.
//
// The render thread alone writes it, one committed pass at a time, in pixel order, so that its bits do not
// depend on the number of threads. Displays and files read FilmSnapshots.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/kernels/pass.h"
#include "engine/math/vec.h"
#include "engine/render/film_region.h"
#include "engine/render/noise_calibration.h"

namespace glint {

/// Welford's running mean and sum of squared deviations (Welford 1962) of one pixel.
struct FilmPixel {
    std::array<double, 3> mean{};  ///< linear Rec.709 radiance
    double luminanceM2 = 0.0;      ///< sum of squared deviations of the luminance from its mean
    uint32_t count = 0;  ///< samples that entered; passes less dropped ones and those of other regions
    float halfSampleMean = 0.0f;  ///< the picture's luminance here at calibration().passes
};

/// A sample that was dropped, for the log and for replay.
struct FaultRecord {
    SampleFault fault;
    int x, y;
    uint32_t pass;
};

class Film {
  public:
    Film() = default;
    Film(int width, int height);

    /// Forgets every pass and keeps the storage.
    void clear();

    /// Adds a whole pass. Samples with a fault are counted, and the first kMaxFaultRecords of them kept, but
    /// not added. `samples` has one entry a pixel, row 0 at the top; those outside `region` (null: there are
    /// none) are not looked at.
    void commit(const std::vector<PixelSample>& samples, uint32_t passIndex, int threads,
                const FilmRegion* region = nullptr);

    int width() const { return width_; }
    int height() const { return height_; }
    uint32_t passes() const { return passes_; }
    uint64_t rays() const { return rays_; }
    const std::vector<FilmPixel>& pixels() const { return pixels_; }
    const std::array<uint64_t, kSampleFaultCount>& faultCounts() const { return faultCounts_; }
    const std::vector<FaultRecord>& faults() const { return faults_; }
    const NoiseCalibration& calibration() const { return calibration_; }

    /// Standard error of a pixel's mean luminance; infinite with fewer than two samples.
    double standardError(const FilmPixel& pixel) const;
    /// Root of the mean squared standard error over all pixels, relative to the picture's mean luminance, as
    /// if samples were independent: what compares the variance of samplers. error_estimate.h knows better how
    /// far the picture is from the truth. Infinite with fewer than two passes; 0 for a black picture without
    /// variance. The same bits for any number of threads (0: all).
    double relativeErrorEstimate(int threads = 0) const;

    size_t bytes() const;
    /// What a film of this size allocates, fault records aside.
    static size_t bytesFor(int width, int height);

    static constexpr size_t kMaxFaultRecords = 1000;

  private:
    bool isOutside(const FilmRegion* region, size_t index) const;
    void recordFaults(const std::vector<PixelSample>& samples, size_t begin, uint32_t passIndex,
                      const FilmRegion* region);

    friend struct FilmCheckpoint;  // reads and writes all members exactly
    friend class NoiseCalibrator;  // noise_calibration.cpp compares the picture with half of its passes

    int width_ = 0;
    int height_ = 0;
    uint32_t passes_ = 0;
    uint64_t rays_ = 0;
    std::vector<FilmPixel> pixels_;
    std::array<uint64_t, kSampleFaultCount> faultCounts_{};
    std::vector<FaultRecord> faults_;
    NoiseCalibration calibration_;
};

/// First-hit pictures (kernels/pass.h, AovSample), accumulated beside a film and independent of it.
class AovFilm {
  public:
    AovFilm() = default;
    AovFilm(int width, int height);

    /// Forgets every pass and keeps the storage.
    void clear();

    /// Running means; ids are those of the first pass.
    void commit(const std::vector<AovSample>& samples, int threads);

    int width() const { return width_; }
    int height() const { return height_; }
    uint32_t passes() const { return passes_; }
    const std::vector<AovSample>& pixels() const { return pixels_; }
    size_t bytes() const { return pixels_.size() * sizeof(AovSample); }
    /// What one of this size allocates.
    static size_t bytesFor(int width, int height);

  private:
    int width_ = 0;
    int height_ = 0;
    uint32_t passes_ = 0;
    std::vector<AovSample> pixels_;
};

}  // namespace glint
