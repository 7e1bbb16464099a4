// Five levels of a 5 x 5 kernel whose taps lie 1, 2, 4 ... pixels apart. Tap by tap over whole rows of single
// numbers, which the compiler turns into vector instructions.
#include "engine/denoise/wavelets.h"

#include <array>
#include <cmath>
#include <utility>

namespace glint {
namespace {

constexpr int kLevels = 5;
/// Cubic B-spline.
constexpr std::array<float, 3> kTaps{3.0f / 8.0f, 1.0f / 4.0f, 1.0f / 16.0f};
/// Weights fall by e for normals this far apart (chords), for nearness that differs by this share a pixel
/// beyond the surface's own slope, and for luminances so many standard errors apart.
constexpr float kWaveletNormalWidth = 0.25f;
constexpr float kWaveletNearnessWidth = 0.01f;
constexpr float kNoiseWidth = 3.0f;

using Channel = std::vector<float>;

/// Radiance without the albedo, its luminance and that one's variance, and the centre taps' share so far.
struct Level {
    enum { kRed, kGreen, kBlue, kLight, kVariance, kLeverage, kCount };
    std::array<Channel, kCount> channels;
};

constexpr int kBlock = 64;
using Lanes = std::array<float, kBlock>;

struct Tap {
    float most;    ///< its weight where nothing is apart
    float pixels;  ///< from the centre
};

class Wavelets {
  public:
    Wavelets(const Planes& planes, int threads)
        : planes_(planes),
          width_(planes.input.width),
          height_(planes.input.height),
          threads_(threads),
          slope_(planes.nearness.size()) {
        for (Channel& axis : normal_) {
            axis.resize(slope_.size());
        }
        for (size_t i = 0; i < slope_.size(); ++i) {
            slope_[i] = std::fabs(planes.slope[i].x) + std::fabs(planes.slope[i].y) +
                        kWaveletNearnessWidth * planes.nearness[i];
            for (int axis = 0; axis < 3; ++axis) {
                normal_[static_cast<size_t>(axis)][i] = planes.input.normal[i][axis] / kWaveletNormalWidth;
            }
        }
    }

    Candidate run() const {
        Level level = first();
        for (int i = 0; i < kLevels; ++i) {
            level = next(level, 1 << i);
        }
        Candidate out{.radiance = std::vector<Vec3>(slope_.size()),
                      .leverage = std::move(level.channels[Level::kLeverage])};
        const auto& [red, green, blue, light, variance, leverage] = level.channels;
        for (size_t i = 0; i < slope_.size(); ++i) {
            out.radiance[i] = Vec3(red[i], green[i], blue[i]) * planes_.albedo[i];
        }
        return out;
    }

  private:
    Level first() const {
        Level level;
        for (Channel& channel : level.channels) {
            channel.resize(slope_.size(), 1.0f);
        }
        for (size_t i = 0; i < slope_.size(); ++i) {
            const Vec3 color = planes_.radiance[i] / planes_.albedo[i];
            for (int c = 0; c < 3; ++c) {
                level.channels[static_cast<size_t>(c)][i] = color[c];
            }
            level.channels[Level::kLight][i] = luminance(color);
            level.channels[Level::kVariance][i] = planes_.variance[i] / square(luminance(planes_.albedo[i]));
        }
        return level;
    }

    Level next(const Level& from, int step) const {
        Level to;
        for (Channel& channel : to.channels) {
            channel.resize(slope_.size());
        }
        const Channel noise = boxMeans(from.channels[Level::kVariance], width_, height_, 1, threads_);
        forRows(0, height_, threads_, [&](int y) { filterRow(from, noise, step, y, &to); });
        return to;
    }

    void filterRow(const Level& from, const Channel& noise, int step, int y, Level* to) const {
        for (int x = 0; x < width_; x += kBlock) {
            filterBlock(from, noise, step, {x, y}, to);
        }
    }

    /// Sums stay in small arrays of this function's own, so that the compiler need not fear that
    /// they overlap.
    void filterBlock(const Level& from, const Channel& noise, int step, Vec2i corner, Level* to) const {
        const int count = std::min(kBlock, width_ - corner.x);
        const int64_t begin = static_cast<int64_t>(corner.y) * width_ + corner.x;
        const float* light = from.channels[Level::kLight].data() + begin;
        Lanes narrowness{};
        for (int i = 0; i < count; ++i) {
            narrowness[i] =
                1.0f / (kNoiseWidth * std::sqrt(noise[begin + i]) + 1e-3f * std::fabs(light[i]) + 1e-12f);
        }
        std::array<Lanes, Level::kLeverage> sums{};
        Lanes weights{}, changes{}, changedLight{};
        for (int dy = -2; dy <= 2; ++dy) {
            if (corner.y + dy * step < 0 || corner.y + dy * step >= height_) { continue; }
            for (int dx = -2; dx <= 2; ++dx) {
                const int shift = dx * step;
                const int first = std::max(0, -shift - corner.x),
                          last = std::min(count, width_ - shift - corner.x);
                if (first >= last) { continue; }
                const int64_t there = begin + static_cast<int64_t>(dy) * step * width_ + shift;
                const Tap tap{
                    kTaps[static_cast<size_t>(std::abs(dx))] * kTaps[static_cast<size_t>(std::abs(dy))],
                    static_cast<float>(step * (std::abs(dx) + std::abs(dy)))};
                Lanes weight{};
                for (int i = first; i < last; ++i) {
                    const float apart = (from.channels[Level::kLight][there + i] - light[i]) * narrowness[i];
                    const float t = maxf(
                        0.0f, 1.0f - 0.25f * (distance(begin + i, there + i, tap.pixels) + std::fabs(apart)));
                    weight[i] = tap.most * (t * t) * (t * t);
                    const float change = std::copysign(tap.most * (t * t) * t, apart);
                    weights[i] += weight[i];
                    changes[i] += change;
                    changedLight[i] += change * from.channels[Level::kLight][there + i];
                }
                for (size_t c = 0; c < sums.size(); ++c) {
                    const float* source = from.channels[c].data() + there;
                    const bool isVariance = c == Level::kVariance;
                    for (int i = first; i < last; ++i) {
                        sums[c][i] += (isVariance ? weight[i] * weight[i] : weight[i]) * source[i];
                    }
                }
            }
        }
        for (int i = 0; i < count; ++i) {
            const float share = 1.0f / weights[i];
            for (size_t c = 0; c < sums.size(); ++c) {
                to->channels[c][begin + i] = sums[c][i] * (c == Level::kVariance ? share * share : share);
            }
            const float change =
                (changedLight[i] - changes[i] * sums[Level::kLight][i] * share) * narrowness[i];
            to->channels[Level::kLeverage][begin + i] =
                from.channels[Level::kLeverage][begin + i] *
                clampf((square(kTaps[0]) + change) * share, 0.0f, 1.0f);
        }
    }

    /// How far apart two pixels' surfaces are.
    float distance(int64_t p, int64_t q, float pixels) const {
        const float normals = square(normal_[0][q] - normal_[0][p]) + square(normal_[1][q] - normal_[1][p]) +
                              square(normal_[2][q] - normal_[2][p]);
        return normals + std::fabs(planes_.nearness[q] - planes_.nearness[p]) / (pixels * slope_[p] + 1e-6f);
    }

    const Planes& planes_;
    int width_, height_;
    int threads_;
    std::array<Channel, 3> normal_;  ///< over kWaveletNormalWidth
    Channel slope_;                  ///< what nearness may differ by a pixel
};

}  // namespace

Candidate waveletFilter(const Planes& planes, int threads) { return Wavelets(planes, threads).run(); }

}  // namespace glint
