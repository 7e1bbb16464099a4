#include "engine/builders/spectrum_table.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

namespace glint {
namespace {

using Color = glm::dvec3;

constexpr int kStrata = 256;
constexpr double kShortestNm = 380.0, kLongestNm = 780.0;
constexpr int kStepsPerNm = 20;
constexpr int kSteps = static_cast<int>(kLongestNm - kShortestNm) * kStepsPerNm;

/// A bell with a width of its own on each side of its peak.
double bell(double nm, double peak, double below, double above) {
    const double x = (nm - peak) / (nm < peak ? below : above);
    return std::exp(-0.5 * x * x);
}

Color rec709Of(double nm) {
    const double x = 1.056 * bell(nm, 599.8, 37.9, 31.0) + 0.362 * bell(nm, 442.0, 16.0, 26.7) -
                     0.065 * bell(nm, 501.1, 20.4, 26.2);
    const double y = 0.821 * bell(nm, 568.8, 46.9, 40.5) + 0.286 * bell(nm, 530.9, 16.3, 31.1);
    const double z = 1.217 * bell(nm, 437.0, 11.8, 36.0) + 0.681 * bell(nm, 459.0, 26.0, 13.8);
    return {3.2404542 * x - 1.5371385 * y - 0.4985314 * z, -0.9692660 * x + 1.8760108 * y + 0.0415560 * z,
            0.0556434 * x - 0.2040259 * y + 1.0572252 * z};
}

double middleNm(int step) { return kShortestNm + (step + 0.5) / kStepsPerNm; }

/// What the steps add to each channel; all of them together 1.
std::vector<Color> tabulateSteps() {
    std::vector<Color> steps(kSteps);
    Color sum(0.0);
    for (int i = 0; i < kSteps; ++i) {
        steps[static_cast<size_t>(i)] = glm::max(rec709Of(middleNm(i)), Color(0.0));
        sum += steps[static_cast<size_t>(i)];
    }
    for (Color& step : steps) {
        step /= sum;
    }
    return steps;
}

/// Sums of steps before a place, by linear interpolation.
class Sums {
  public:
    Sums() {
        Color sum(0.0);
        sums_.push_back(sum);
        for (const Color& step : tabulateSteps()) {
            sums_.push_back(sum += step);
        }
    }

    Color before(double place) const {
        const size_t index = std::min(static_cast<size_t>(place), sums_.size() - 2);
        return glm::mix(sums_[index], sums_[index + 1], place - static_cast<double>(index));
    }

    /// The place before which lies this share of all three channels.
    double placeOf(double share) const {
        const auto mean = [](const Color& c) { return (c.x + c.y + c.z) / 3.0; };
        const auto after = std::ranges::upper_bound(sums_, share, {}, mean);
        const size_t index =
            std::clamp<size_t>(static_cast<size_t>(after - sums_.begin()), 1, sums_.size() - 1) - 1;
        const double lo = mean(sums_[index]), hi = mean(sums_[index + 1]);
        return static_cast<double>(index) + (hi > lo ? std::clamp((share - lo) / (hi - lo), 0.0, 1.0) : 0.0);
    }

  private:
    std::vector<Color> sums_;
};

float nmAt(double place) { return static_cast<float>(kShortestNm + place / kStepsPerNm); }

}  // namespace

std::vector<SpectrumStratum> tabulateSpectrum() {
    const Sums sums;
    std::vector<SpectrumStratum> strata;
    double begin = sums.placeOf(0.0);
    for (int i = 0; i < kStrata; ++i) {
        const double end = sums.placeOf((i + 1.0) / kStrata);
        const Color weight = static_cast<double>(kStrata) * (sums.before(end) - sums.before(begin));
        strata.push_back({nmAt(begin), nmAt(end), Vec3(glm::max(weight, Color(0.0)))});
        begin = end;
    }
    return strata;
}

std::vector<SpectrumStratum> tabulateThreeChannels() {
    std::vector<SpectrumStratum> strata;
    for (int channel = 0; channel < 3; ++channel) {
        const float nm = kChannelWavelengthsNm[channel];
        Vec3 weight(0.0f);
        weight[channel] = 3.0f;
        strata.push_back({nm, nm, weight});
    }
    return strata;
}

}  // namespace glint
