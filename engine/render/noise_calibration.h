// How much a pixel's mean really scatters, compared with what independent samples of its variance would give.
//
// Low-discrepancy passes fill a pixel more evenly than chance: at the edge of a lamp the error after 256
// passes is a fifth of what their variance says, on a rough wall it is about the same. So at every power of
// two of passes the picture is compared with itself at half of them: their difference is a sample of the
// error, and how its square compares with the samples' variance is learnt for classes of pixels.
//
// Costs a float a pixel, which lies in FilmPixel's padding.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace glint {

class Film;
class ImageStatistics;

struct NoiseCalibration {
    /// A class for each power of two of the variance of one pass' luminance, relative to the squared mean
    /// luminance of the picture.
    static constexpr int kClasses = 40;
    static constexpr int kLowestExponent = -24;

    uint32_t passes = 0;                     ///< at which it was made; 0: not yet, every factor is 1
    double meanLuminance = 0.0;              ///< of the picture then
    std::array<double, kClasses> factors{};  ///< of the variance of a pixel's mean
    /// so many neighbours err alike: 1, but for SPPM, whose pixels share photons
    double correlatedPixels = 1.0;

    /// The class of a pixel whose passes have this variance. 0 for no variance.
    int classOf(double variancePerPass) const;
    /// 1 before the first calibration.
    double factorOf(double variancePerPass) const {
        return passes == 0 ? 1.0 : factors[static_cast<size_t>(classOf(variancePerPass))];
    }
};

/// To be called after every committed pass. Does something at powers of two of passes: from the second on it
/// remembers the picture, from the fourth on it compares. `statistics` are null, or empty, where the
/// integrator has none; their variance falls like passes^-decay. The same bits for any number of threads.
void calibrateNoise(const ImageStatistics* statistics, double decay, int threads, Film* film);

}  // namespace glint
