// The choice between candidates and the input, by their estimated errors, and what is known of the result's.
#include "engine/denoise/denoise.h"

#include <array>
#include <cmath>

#include "engine/denoise/regression.h"
#include "engine/denoise/wavelets.h"

namespace glint {
namespace {

/// Half the side of the squares that a choice looks at: one pixel's error says little.
constexpr int kChoiceHalf = 3;
constexpr int kNoiseHalf = 2;
/// Of the mean of a square, in what is stated as its error.
constexpr float kErrorsAbove = 1.0f;
constexpr std::array<RegressionSettings, 3> kRegressions{{{true, 1.5f}, {true, 5.0f}, {false, 3.0f}}};
/// A pixel that is so many times as far from the candidate as its surroundings are: within so many of its own
/// standard errors it is a spark, of which nothing is kept; beyond, the candidate is wrong there.
constexpr float kFarRatio = 3.0f;
constexpr float kSparkErrors = 3.0f;

class Denoiser {
  public:
    Denoiser(const DenoiseInput& input, int threads)
        : input_(input),
          threads_(threads),
          planes_(makePlanes(input, threads)),
          guide_(waveletFilter(planes_, threads)),
          result_(input.radiance) {
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
        variance_ = means(relative_, kChoiceHalf);
        leastError_ = variance_;
        gain_.resize(pixels);
        change_.resize(pixels);
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
        limitChange();
        std::vector<float> error = statedErrors();
        return {std::move(result_), std::move(error)};
    }

  private:
    std::vector<float> means(const std::vector<float>& values, int half) const {
        return boxMeans(values, input_.width, input_.height, half, threads_);
    }
    /// With the input's variance v, the candidate's leverage h and its squared difference d from the input,
    /// whose mean is e + v - 2 h v for a candidate with the mean squared error e (Stein 1981): the share s of
    /// the candidate has the error v - 2 s (1 - h) v + s^2 d, which is least for s = (1 - h) v / d. A pixel's
    /// own difference has no say in that, but where it is far off, so that it tells the error afterwards.
    void take(const Candidate& candidate) {
        std::vector<float> difference(scale_.size()), independent(scale_.size());
        for (size_t i = 0; i < scale_.size(); ++i) {
            difference[i] = square(luminance(candidate.radiance[i] - input_.radiance[i])) * scale_[i];
            // A spark's own value was not looked at.
            const float leverage = planes_.isSpark[i] != 0 ? 0.0f : candidate.leverage[i];
            independent[i] = (1.0f - leverage) * relative_[i];
        }
        const std::vector<float> gains = means(independent, kChoiceHalf),
                                 differences = surroundingMeans(difference, input_.width, input_.height,
                                                                kChoiceHalf, threads_);
        for (size_t i = 0; i < scale_.size(); ++i) {
            const float d = differences[i], g = gains[i];
            const float best = d > g ? g / d : 1.0f;
            const float error = maxf(0.0f, variance_[i] - 2.0f * best * g + best * best * d);
            const bool isFar = difference[i] > square(kFarRatio) * d;
            const bool isSpark = isFar && difference[i] < square(kSparkErrors) * relative_[i];
            if (error >= leastError_[i] || (isFar && !isSpark)) { continue; }
            leastError_[i] = error;
            const float share = isSpark ? 1.0f : best;
            result_[i] = glm::mix(input_.radiance[i], candidate.radiance[i], share);
            gain_[i] = share * independent[i];
            change_[i] = share * share * difference[i];
        }
    }

    /// To kDenoiseMostChange in every square.
    void limitChange() {
        const std::vector<float> changes = means(change_, kDenoiseErrorHalf),
                                 variances = means(relative_, kDenoiseErrorHalf);
        std::vector<float> factor(scale_.size());
        for (size_t i = 0; i < factor.size(); ++i) {
            const float most = square(kDenoiseMostChange) * variances[i];
            factor[i] = changes[i] > most ? std::sqrt(most / changes[i]) : 1.0f;
        }
        factor = boxMinima(factor, input_.width, input_.height, kDenoiseErrorHalf, threads_);
        for (size_t i = 0; i < factor.size(); ++i) {
            if (factor[i] == 1.0f) { continue; }
            result_[i] = glm::mix(input_.radiance[i], result_[i], factor[i]);
            gain_[i] *= factor[i];
            change_[i] *= square(factor[i]);
        }
    }

    /// The mean of unbiased estimates over a square, and kErrorsAbove standard errors of that mean.
    std::vector<float> statedErrors() const {
        std::vector<float> each(scale_.size()), squares(scale_.size());
        for (size_t i = 0; i < each.size(); ++i) {
            // That a spark is none of the picture is a guess: for all that is known, its error stays.
            each[i] = relative_[i];
            if (planes_.isSpark[i] == 0) { each[i] += change_[i] - 2.0f * gain_[i]; }
            squares[i] = square(each[i]);
        }
        each = means(each, kDenoiseErrorHalf);
        squares = means(squares, kDenoiseErrorHalf);
        std::vector<float> error(each.size());
        for (size_t i = 0; i < error.size(); ++i) {
            const int x = static_cast<int>(i) % input_.width, y = static_cast<int>(i) / input_.width;
            const int count = boxSize(x, y, input_.width, input_.height, kDenoiseErrorHalf);
            const float spread = maxf(0.0f, squares[i] - square(each[i])) / static_cast<float>(count);
            error[i] = std::sqrt((maxf(0.0f, each[i]) + kErrorsAbove * std::sqrt(spread)) / scale_[i]);
        }
        return error;
    }

    const DenoiseInput& input_;
    int threads_;
    Planes planes_;
    Candidate guide_;
    std::vector<Vec3> result_;
    std::vector<float> scale_;       ///< makes squares of luminances relative
    std::vector<float> relative_;    ///< variance of the input
    std::vector<float> variance_;    ///< the same, as a mean over a square
    std::vector<float> leastError_;  ///< of what was chosen, squared, by the square
    /// Of what was chosen, by the pixel alone: s (1 - h) v and s^2 d.
    std::vector<float> gain_, change_;
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
