#include "engine/render/auto_exposure.h"

#include <algorithm>
#include <cmath>

#include "engine/math/color.h"

namespace glint {
namespace {

constexpr int kBlocksAcross = 96;
constexpr float kTooBrightMedian = 1.25f;
constexpr float kTooDarkHighlights = 0.18f;  ///< what but 2 % of the blocks stay below
constexpr float kTooDarkSurfaces = 0.02f;    ///< what but 10 % stay below: lamps alone are seen
constexpr float kBrightest = 0.8f;           ///< what the largest of these become

/// Means of the luminance that are not black, sorted.
std::vector<float> litBlocks(const std::vector<float>& rgb, int width, int height) {
    const int side = std::max(1, (std::max(width, height) + kBlocksAcross - 1) / kBlocksAcross);
    std::vector<float> lit;
    for (int top = 0; top < height; top += side) {
        for (int left = 0; left < width; left += side) {
            const int bottom = std::min(top + side, height), right = std::min(left + side, width);
            double sum = 0.0;
            for (int y = top; y < bottom; ++y) {
                for (int x = left; x < right; ++x) {
                    const size_t i =
                        3 * (static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x));
                    const float value = luminance({rgb[i], rgb[i + 1], rgb[i + 2]});
                    sum += std::isfinite(value) ? static_cast<double>(value) : 0.0;
                }
            }
            const double mean = sum / ((bottom - top) * (right - left));
            if (mean > 0.0) { lit.push_back(static_cast<float>(mean)); }
        }
    }
    std::ranges::sort(lit);
    return lit;
}

}  // namespace

float autoExposure(const std::vector<float>& rgb, int width, int height) {
    const std::vector<float> lit = litBlocks(rgb, width, height);
    if (lit.empty()) { return 0.0f; }
    const auto quantile = [&lit](double share) {
        return lit[std::min(lit.size() - 1, static_cast<size_t>(share * static_cast<double>(lit.size())))];
    };
    const bool isBright = quantile(0.5) > kTooBrightMedian, lacksSurfaces = quantile(0.9) < kTooDarkSurfaces;
    if (!isBright && !lacksSurfaces && quantile(0.98) >= kTooDarkHighlights) { return 0.0f; }
    const float brightest = isBright || lacksSurfaces ? quantile(0.9) : quantile(0.98);
    const float stops = std::log2(kBrightest) - std::log2(brightest);
    return std::round(3.0f * std::clamp(stops, -100.0f, 100.0f)) / 3.0f;
}

}  // namespace glint
