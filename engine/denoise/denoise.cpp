// The choice between candidates and the input, by their estimated errors.
#include "engine/denoise/denoise.h"

#include <array>
#include <cmath>

#include "engine/denoise/regression.h"
#include "engine/denoise/wavelets.h"

namespace glint {
namespace {

/// Half the side of the squares that estimated errors are averaged over: one pixel's says little.
constexpr int kErrorHalf = 3;
constexpr int kNoiseHalf = 2;
constexpr std::array<RegressionSettings, 3> kRegressions{{{true, 1.5f}, {true, 5.0f}, {false, 3.0f}}};
/// A pixel that is so many times as far from the candidate as its neighbourhood is, but not beyond so many of
/// its own standard errors, is a spark: of it nothing is kept.
constexpr float kSparkRatio = 3.0f;
constexpr float kSparkErrors = 3.0f;

class Denoiser {
  public:
    Denoiser(const DenoiseInput& input, int threads)
        : input_(input),
          threads_(threads),
          planes_(makePlanes(input, threads)),
          guide_(waveletFilter(planes_, threads)) {
        const size_t pixels = input.radiance.size();
        std::vector<float> light(pixels);
        double sum = 0.0;
        for (size_t i = 0; i < pixels; ++i) {
            light[i] = luminance(input.radiance[i]);
            sum += static_cast<double>(light[i]);
        }
        light = means(light, kNoiseHalf);
        // As relMSE does, so that what is bright does not decide over the dark beside it.
        const float darkest =
            0.1f * static_cast<float>(sum / static_cast<double>(std::max<size_t>(1, pixels)));
        scale_.resize(pixels);
        relative_.resize(pixels);
        for (size_t i = 0; i < pixels; ++i) {
            scale_[i] = 1.0f / (square(light[i]) + square(darkest) + 1e-30f);
            relative_[i] = planes_.variance[i] * scale_[i];
        }
        out_.radiance = input.radiance;
        out_.error = means(relative_, kErrorHalf);
        variance_ = out_.error;
    }

    void addWavelets() { take(guide_); }

    void addRegressions(const std::atomic<bool>* stop) {
        const std::vector<float> noise = means(planes_.variance, kNoiseHalf);
        for (const RegressionSettings& settings : kRegressions) {
            const Candidate candidate =
                regressionFilter(planes_, guide_.radiance, noise, settings, threads_, stop);
            if (stop != nullptr && *stop) { return; }
            take(candidate);
        }
    }

    DenoisedImage result() {
        for (size_t i = 0; i < scale_.size(); ++i) {
            out_.error[i] = std::sqrt(out_.error[i] / scale_[i]);
        }
        return std::move(out_);
    }

  private:
    std::vector<float> means(const std::vector<float>& values, int half) const {
        return boxMeans(values, input_.width, input_.height, half, threads_);
    }

    /// With the input's variance v, the candidate's leverage h and its squared difference d from the input,
    /// whose mean is e + v - 2 h v for a candidate with the mean squared error e (Stein 1981): the share s of
    /// the candidate has the error v - 2 s (1 - h) v + s^2 d, which is least for s = (1 - h) v / d.
    void take(const Candidate& candidate) {
        std::vector<float> difference(scale_.size()), independent(scale_.size());
        for (size_t i = 0; i < scale_.size(); ++i) {
            difference[i] = square(luminance(candidate.radiance[i] - input_.radiance[i])) * scale_[i];
            independent[i] = (1.0f - candidate.leverage[i]) * relative_[i];
        }
        const std::vector<float> differences = means(difference, kErrorHalf),
                                 gains = means(independent, kErrorHalf);
        for (size_t i = 0; i < scale_.size(); ++i) {
            const float d = differences[i], g = gains[i];
            const float share = d > g ? g / d : 1.0f;
            const float error = maxf(0.0f, variance_[i] - 2.0f * share * g + share * share * d);
            if (error < out_.error[i]) {
                const bool isSpark = difference[i] > square(kSparkRatio) * d &&
                                     difference[i] < square(kSparkErrors) * relative_[i];
                out_.error[i] = error;
                out_.radiance[i] =
                    glm::mix(input_.radiance[i], candidate.radiance[i], isSpark ? 1.0f : share);
            }
        }
    }

    const DenoiseInput& input_;
    int threads_;
    Planes planes_;
    Candidate guide_;
    std::vector<float> scale_;     ///< makes squares of luminances relative
    std::vector<float> relative_;  ///< variance of the input
    std::vector<float> variance_;  ///< the same, as a mean over the neighbourhood
    DenoisedImage out_;            ///< errors: squared and relative, until the end
};

}  // namespace

DenoisedImage denoiseQuickly(const DenoiseInput& input, int threads) {
    Denoiser denoiser(input, threads);
    denoiser.addWavelets();
    return denoiser.result();
}

DenoisedImage denoise(const DenoiseInput& input, int threads, const std::atomic<bool>* stop) {
    Denoiser denoiser(input, threads);
    denoiser.addWavelets();
    denoiser.addRegressions(stop);
    return stop != nullptr && *stop ? DenoisedImage{} : denoiser.result();
}

}  // namespace glint
