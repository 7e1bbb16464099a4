// Windows are centred on every kStride-th pixel of every kStride-th row; a pixel takes the mean of what all
// windows around it predict, weighted as it was in each of them. The picture is worked on in bands, so that
// windows take little memory.
#include "engine/denoise/regression.h"

#include <array>
#include <cmath>
#include <utility>

namespace glint {
namespace {

constexpr int kHalf = 8;
constexpr int kStride = 3;
constexpr int kBand = 96;              ///< rows of pixels
constexpr size_t kFeatures = 10;       ///< 1, x, y, normal, nearness, albedo
constexpr size_t kColors = kFeatures;  ///< where the three colours begin in a row
constexpr size_t kRow = 16;            ///< with room for whole vectors of the processor
/// As if each feature changed by this (squared) in every window: where it hardly does, its coefficient
/// is noise.
constexpr float kRidge = 1e-3f;
/// Weights fall by e for normals this far apart (chords), and for this share of nearness off the
/// centre's plane.
constexpr float kNormalWidth = 0.6f;
constexpr float kNearnessWidth = 0.05f;

using Row = std::array<float, kRow>;

/// Sums of products of the features, and of features and colours; solved: the inverse of the first, and right
/// of it the coefficients of the colours.
struct Window {
    size_t center = 0;
    bool isSolved = false;
    std::array<Row, kFeatures> rows{};
};

/// Gauss and Jordan in place, without a choice of pivots: the matrix is symmetric and positive definite.
/// False: not so.
bool solve(std::array<Row, kFeatures>* rows) {
    for (size_t k = 0; k < kFeatures; ++k) {
        Row& own = (*rows)[k];
        if (!(own[k] > 1e-12f)) { return false; }
        const float scale = 1.0f / std::exchange(own[k], 1.0f);
        for (float& value : own) {
            value *= scale;
        }
        for (size_t i = 0; i < kFeatures; ++i) {
            if (i == k) { continue; }
            Row& other = (*rows)[i];
            const float factor = std::exchange(other[k], 0.0f);
            for (size_t j = 0; j < kRow; ++j) {
                other[j] -= factor * own[j];
            }
        }
    }
    return true;
}

/// The place of an offset within [-kHalf, kHalf].
size_t tap(int offset) {
    const int place = offset + kHalf;
    return static_cast<size_t>(place);
}

class Regression {
  public:
    Regression(const Planes& planes, const std::vector<Vec3>& guide, const std::vector<float>& noise,
               const RegressionSettings& settings)
        : planes_(planes),
          input_(planes.input),
          guide_(guide),
          noise_(noise),
          settings_(settings),
          columns_((input_.width + kStride - 1) / kStride) {
        for (int d = -kHalf; d <= kHalf; ++d) {
            const float share = static_cast<float>(d) / static_cast<float>(kHalf + 1);
            taper_[tap(d)] = square(1.0f - share * share);
        }
    }

    Candidate run(int threads, const std::atomic<bool>* stop) {
        const size_t pixels = input_.radiance.size();
        Candidate out{.radiance = std::vector<Vec3>(pixels), .leverage = std::vector<float>(pixels)};
        const int rows = (input_.height + kStride - 1) / kStride;
        for (int top = 0; top < input_.height; top += kBand) {
            if (stop != nullptr && *stop) { break; }
            const int bottom = std::min(input_.height, top + kBand);
            firstRow_ = std::max(0, top - kHalf) / kStride;
            const int end = std::min(rows, (bottom + kHalf) / kStride + 1);
            windows_.assign(static_cast<size_t>(end - firstRow_) * static_cast<size_t>(columns_), {});
            forRows(firstRow_, end, threads, [&](int row) {
                for (int column = 0; column < columns_; ++column) {
                    fit(column * kStride, row * kStride);
                }
            });
            forRows(top, bottom, threads, [&](int y) {
                for (int x = 0; x < input_.width; ++x) {
                    predict(x, y, &out);
                }
            });
        }
        return out;
    }

  private:
    size_t pixelAt(int x, int y) const {
        return static_cast<size_t>(y) * static_cast<size_t>(input_.width) + static_cast<size_t>(x);
    }

    /// Of the one with this centre.
    Window& windowAt(int x, int y) {
        return windows_[static_cast<size_t>(y / kStride - firstRow_) * static_cast<size_t>(columns_) +
                        static_cast<size_t>(x / kStride)];
    }

    /// Of pixel q, which lies (dx, dy) from the window's centre c.
    Row featuresOf(size_t c, size_t q, int dx, int dy) const {
        constexpr float kPerPixel = 1.0f / static_cast<float>(kHalf);
        const Vec3 normal = input_.normal[q] - input_.normal[c];
        const Vec3 albedo = input_.albedo[q] - input_.albedo[c];
        return {1.0f,
                static_cast<float>(dx) * kPerPixel,
                static_cast<float>(dy) * kPerPixel,
                normal.x,
                normal.y,
                normal.z,
                planes_.nearness[q] - planes_.nearness[c],
                albedo.x,
                albedo.y,
                albedo.z};
    }

    float weightOf(size_t c, size_t q, int dx, int dy) const {
        const float scale = square(settings_.colorWidth) * (noise_[c] + noise_[q]) +
                            1e-4f * lengthSquared(guide_[c]) + 1e-20f;
        const float colors = lengthSquared(guide_[q] - guide_[c]) / scale;
        const float normals = lengthSquared(input_.normal[q] - input_.normal[c]) / square(kNormalWidth);
        const float plane = planes_.nearness[c] + planes_.slope[c].x * static_cast<float>(dx) +
                            planes_.slope[c].y * static_cast<float>(dy);
        const float offPlane =
            std::fabs(planes_.nearness[q] - plane) / (kNearnessWidth * planes_.nearness[c] + 1e-6f);
        return taper_[tap(dx)] * taper_[tap(dy)] * falloff(colors + normals + offPlane);
    }

    void fit(int x, int y) {
        Window& window = windowAt(x, y);
        const size_t c = window.center = pixelAt(x, y);
        for (int v = std::max(0, y - kHalf); v <= std::min(input_.height - 1, y + kHalf); ++v) {
            for (int u = std::max(0, x - kHalf); u <= std::min(input_.width - 1, x + kHalf); ++u) {
                const size_t q = pixelAt(u, v);
                const float weight = weightOf(c, q, u - x, v - y);
                if (!(weight > 0.0f)) { continue; }
                Row values = featuresOf(c, q, u - x, v - y);
                const Vec3 color =
                    settings_.isDemodulated ? planes_.radiance[q] / planes_.albedo[q] : planes_.radiance[q];
                values[kColors] = color.x;
                values[kColors + 1] = color.y;
                values[kColors + 2] = color.z;
                for (size_t i = 0; i < kFeatures; ++i) {
                    const float factor = weight * values[i];
                    for (size_t j = 0; j < kRow; ++j) {
                        window.rows[i][j] += factor * values[j];
                    }
                }
            }
        }
        for (size_t i = 1; i < kFeatures; ++i) {
            window.rows[i][i] += kRidge * window.rows[0][0];
        }
        window.isSolved = solve(&window.rows);
    }

    struct Prediction {
        Vec3 color{0.0f};
        float leverage = 0.0f;
        float weight = 0.0f;
    };

    /// Adds what a window says of pixel p.
    void add(const Window& window, size_t p, int dx, int dy, Prediction* sum) const {
        const float weight = window.isSolved ? weightOf(window.center, p, dx, dy) : 0.0f;
        if (!(weight > 0.0f)) { return; }
        const Row values = featuresOf(window.center, p, dx, dy);
        Row products{};
        for (size_t i = 0; i < kFeatures; ++i) {
            for (size_t j = 0; j < kRow; ++j) {
                products[j] += values[i] * window.rows[i][j];
            }
        }
        float leverage = 0.0f;
        for (size_t i = 0; i < kFeatures; ++i) {
            leverage += values[i] * products[i];
        }
        sum->color += weight * Vec3(products[kColors], products[kColors + 1], products[kColors + 2]);
        sum->leverage += weight * weight * leverage;
        sum->weight += weight;
    }

    void predict(int x, int y, Candidate* out) {
        const auto firstCenter = [](int at) {
            return std::max(0, (at - kHalf + kStride - 1) / kStride * kStride);
        };
        const size_t p = pixelAt(x, y);
        Prediction sum;
        for (int v = firstCenter(y); v <= std::min(input_.height - 1, y + kHalf); v += kStride) {
            for (int u = firstCenter(x); u <= std::min(input_.width - 1, x + kHalf); u += kStride) {
                add(windowAt(u, v), p, x - u, y - v, &sum);
            }
        }
        constexpr float kFewest = 1e-3f;
        const bool isKnown = sum.weight > kFewest;
        const Vec3 color =
            sum.color / sum.weight * (settings_.isDemodulated ? planes_.albedo[p] : Vec3(1.0f));
        out->radiance[p] = isKnown ? glm::max(color, Vec3(0.0f)) : input_.radiance[p];
        out->leverage[p] = isKnown ? clampf(sum.leverage / sum.weight, 0.0f, 1.0f) : 1.0f;
    }

    const Planes& planes_;
    const DenoiseInput& input_;
    const std::vector<Vec3>& guide_;
    const std::vector<float>& noise_;
    RegressionSettings settings_;
    int columns_;
    int firstRow_ = 0;  ///< of the band's windows
    std::array<float, 2 * kHalf + 1> taper_{};
    std::vector<Window> windows_;
};

}  // namespace

Candidate regressionFilter(const Planes& planes, const std::vector<Vec3>& guide,
                           const std::vector<float>& noise, const RegressionSettings& settings, int threads,
                           const std::atomic<bool>* stop) {
    return Regression(planes, guide, noise, settings).run(threads, stop);
}

}  // namespace glint
