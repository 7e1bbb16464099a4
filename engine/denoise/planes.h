// What the filters look at, made of an input once.
#pragma once

#include <algorithm>
#include <vector>

#include "engine/base/parallel.h"
#include "engine/denoise/denoise.h"
#include "engine/math/color.h"

namespace glint {

struct Planes {
    const DenoiseInput& input;
    std::vector<float> nearness;  ///< 1 / depth over its mean: linear across a plane; 0: nothing hit
    std::vector<Vec2> slope;   ///< how nearness changes from pixel to pixel, on the flatter side of each axis
    std::vector<Vec3> albedo;  ///< what radiance is divided by: never near 0, 1 where nothing was hit
    std::vector<Vec3> radiance;  ///< the input's without sparks (sparks.h): what candidates are made of
    std::vector<char> isSpark;
    std::vector<float> variance;  ///< the input's where it is known, else of the luminances of 5 x 5 pixels
};

Planes makePlanes(const DenoiseInput& input, int threads);

/// A filter's output before it is compared with the input.
struct Candidate {
    std::vector<Vec3> radiance;
    /// How much of its own input is in a pixel: its derivative by that, in [0, 1], with the weights as
    /// they are.
    std::vector<float> leverage;
};

/// Means over squares of 2 half + 1 pixels, cut off at the picture's edge.
std::vector<float> boxMeans(const std::vector<float>& values, int width, int height, int half, int threads);

/// The same without the pixel in the middle; where there is no other, itself.
std::vector<float> surroundingMeans(const std::vector<float>& values, int width, int height, int half,
                                    int threads);
/// The least value in such a square.
std::vector<float> boxMinima(const std::vector<float>& values, int width, int height, int half, int threads);
/// How many pixels it has.
inline int boxSize(int x, int y, int width, int height, int half) {
    const auto along = [half](int at, int size) {
        return std::min(size - 1, at + half) - std::max(0, at - half) + 1;
    };
    return along(x, width) * along(y, height);
}

/// About exp(-x) for x >= 0, but 0 from 4 on.
inline float falloff(float x) {
    const float t = maxf(0.0f, 1.0f - 0.25f * x);
    return (t * t) * (t * t);
}

/// Calls body(y) for every row, in no particular order.
template <class Body>
void forRows(int begin, int end, int threads, const Body& body) {
    parallelChunks(end - begin, 4, threads, [&](int64_t first, int64_t last) {
        for (int64_t y = first; y < last; ++y) {
            body(begin + static_cast<int>(y));
        }
    });
}

}  // namespace glint
