#include "engine/render/pixel_errors.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "engine/base/parallel.h"
#include "engine/render/film.h"

namespace glint {

PixelErrors::PixelErrors(const Film& film, const ImageStatistics* statistics, int threads,
                         const FilmRegion& part)
    : width_(film.width()), part_(part), values_(film.pixels().size()), sparks_(film.pixels().size()) {
    constexpr int64_t kRows = 16;
    const auto eachPixel = [&](const auto& visit) {
        parallelChunks(part.y1 - part.y0, kRows, threads, [&](int64_t begin, int64_t end) {
            for (int y = part_.y0 + static_cast<int>(begin); y < part_.y0 + static_cast<int>(end); ++y) {
                for (int x = part_.x0; x < part_.x1; ++x) {
                    visit(x, y);
                }
            }
        });
    };
    eachPixel([&](int x, int y) {
        const size_t i = indexOf(x, y);
        const PixelError error = pixelError(film, statistics, i);
        values_[i] = {static_cast<float>(error.variance), static_cast<float>(error.photonVariance),
                      static_cast<float>(error.bias * error.bias),
                      static_cast<float>(pixelLuminance(film, statistics, i))};
    });
    eachPixel([&](int x, int y) { sparks_[indexOf(x, y)] = isSpark(x, y) ? 1 : 0; });
}

bool PixelErrors::isSpark(int x, int y) const {
    constexpr int kHalf = 2;
    const double own = static_cast<double>(values_[indexOf(x, y)].variance);
    double others = -own;
    if (!std::isfinite(own)) { return false; }
    for (int v = std::max(y - kHalf, part_.y0); v <= std::min(y + kHalf, part_.y1 - 1); ++v) {
        for (int u = std::max(x - kHalf, part_.x0); u <= std::min(x + kHalf, part_.x1 - 1); ++u) {
            const double variance = static_cast<double>(values_[indexOf(u, v)].variance);
            others += std::isfinite(variance) ? variance : 0.0;
            if (own <= kSparkTimes * others) { return false; }
        }
    }
    return own > 0.0;
}

PixelError PixelErrors::error(size_t index) const {
    const Value& own = values_[index];
    return {static_cast<double>(own.variance), static_cast<double>(own.photonVariance),
            std::sqrt(static_cast<double>(own.biasSquared))};
}

PixelErrors::Around PixelErrors::around(size_t index) const {
    const int x = static_cast<int>(index) % width_;
    const int y = static_cast<int>(index) / width_;
    const Value& own = values_[index];
    if (!std::isfinite(own.variance)) { return {error(index), static_cast<double>(own.luminance)}; }
    Around out;
    double biasSquared = 0.0;
    int count = 0;
    for (int v = std::max(y - 1, part_.y0); v <= std::min(y + 1, part_.y1 - 1); ++v) {
        for (int u = std::max(x - 1, part_.x0); u <= std::min(x + 1, part_.x1 - 1); ++u) {
            const Value& value = values_[indexOf(u, v)];
            if (!std::isfinite(value.variance) || sparks_[indexOf(u, v)] != 0) { continue; }
            out.error.variance += static_cast<double>(value.variance);
            out.error.photonVariance += static_cast<double>(value.photonVariance);
            biasSquared += static_cast<double>(value.biasSquared);
            out.luminance += static_cast<double>(value.luminance);
            ++count;
        }
    }
    if (count == 0) { return {error(index), static_cast<double>(own.luminance)}; }
    const double share = 1.0 / count;
    out.error.variance *= share;
    out.error.photonVariance *= share;
    out.error.bias = std::sqrt(share * biasSquared);
    out.luminance *= share;
    // Its brightness there is the error itself.
    if (sparks_[index] != 0) { out.error = error(index); }
    return out;
}

}  // namespace glint
