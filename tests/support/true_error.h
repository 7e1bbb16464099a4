// The picture error of engine/render/picture_error.h once more, from luminances and by sorting.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace glint::test {

inline double meanAround(const std::vector<double>& square, size_t pixel) {
    const auto side = static_cast<int>(std::lround(std::sqrt(static_cast<double>(square.size()))));
    const int x = static_cast<int>(pixel) % side, y = static_cast<int>(pixel) / side;
    double sum = 0.0, count = 0.0;
    for (int i = 0; i < side * side; ++i) {
        if (std::abs(i % side - x) > 1 || std::abs(i / side - y) > 1) { continue; }
        sum += square[static_cast<size_t>(i)];
        count += 1.0;
    }
    return sum / count;
}

/// Of a square picture against the truth. Without 0.1 % of the pixels, of which one may count in part.
inline double trueError(const std::vector<double>& image, const std::vector<double>& truth) {
    const auto pixels = static_cast<double>(truth.size());
    double root = 0.0;
    for (const double luminance : truth) {
        root += std::sqrt(luminance) / pixels;
    }
    const double dark = 0.1 * root * root;
    std::vector<double> shares;
    for (size_t i = 0; i < truth.size(); ++i) {
        const double error = std::abs(image[i] - truth[i]) / std::hypot(meanAround(truth, i), dark);
        shares.push_back(std::min(1.0, error * error));
    }
    std::ranges::sort(shares);
    const double kept = 0.999 * pixels;
    double sum = 0.0;
    for (size_t i = 0; i < shares.size(); ++i) {
        sum += std::clamp(kept - static_cast<double>(i), 0.0, 1.0) * shares[i];
    }
    return std::sqrt(sum / kept);
}

}  // namespace glint::test
