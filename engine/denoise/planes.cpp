#include "engine/denoise/planes.h"

#include <cmath>
#include <utility>

#include "engine/denoise/sparks.h"

namespace glint {
namespace {

std::vector<float> nearnessOf(const std::vector<float>& depth) {
    constexpr float kMost = 100.0f;  // of the mean: what touches the lens says nothing about the rest
    std::vector<float> nearness(depth.size());
    double sum = 0.0;
    size_t hits = 0;
    for (size_t i = 0; i < depth.size(); ++i) {
        const bool isHit = depth[i] > 0.0f && std::isfinite(depth[i]);
        nearness[i] = isHit ? 1.0f / depth[i] : 0.0f;
        sum += static_cast<double>(nearness[i]);
        hits += isHit ? 1 : 0;
    }
    const auto scale = static_cast<float>(sum > 0.0 ? static_cast<double>(hits) / sum : 0.0);
    for (float& each : nearness) {
        each = minf(each * scale, kMost);
    }
    return nearness;
}

/// The smaller one of the two steps from a value; 0 where there is neither.
float flatterStep(const float* value, bool hasBefore, bool hasAfter, size_t step) {
    const float before = hasBefore ? *value - *(value - step) : kInfinity;
    const float after = hasAfter ? *(value + step) - *value : kInfinity;
    const float least = std::fabs(before) < std::fabs(after) ? before : after;
    return std::isfinite(least) ? least : 0.0f;
}

std::vector<float> varianceOf(const DenoiseInput& input, int threads) {
    constexpr int kHalf = 2;
    if (std::ranges::all_of(input.variance, [](float v) { return std::isfinite(v); })) {
        return input.variance;
    }
    std::vector<float> light(input.radiance.size()), squares(light.size());
    for (size_t i = 0; i < light.size(); ++i) {
        light[i] = luminance(input.radiance[i]);
        squares[i] = square(light[i]);
    }
    std::vector<float> variance = boxMeans(squares, input.width, input.height, kHalf, threads);
    const std::vector<float> means = boxMeans(light, input.width, input.height, kHalf, threads);
    for (size_t i = 0; i < variance.size(); ++i) {
        const float own = input.variance[i];
        variance[i] = std::isfinite(own) ? own : maxf(0.0f, variance[i] - square(means[i]));
    }
    return variance;
}

}  // namespace

Planes makePlanes(const DenoiseInput& input, int threads) {
    constexpr float kDarkestAlbedo = 0.02f;  // below, noise hides the texture
    Planes planes{.input = input,
                  .nearness = nearnessOf(input.depth),
                  .slope = {},
                  .albedo = {},
                  .radiance = {},
                  .isSpark = {},
                  .variance = varianceOf(input, threads)};
    CalmImage calm = withoutSparks(input, planes.variance, threads);
    planes.radiance = std::move(calm.radiance);
    planes.isSpark = std::move(calm.isSpark);
    const size_t pixels = input.radiance.size();
    planes.slope.resize(pixels);
    planes.albedo.resize(pixels);
    const auto width = static_cast<size_t>(input.width);
    forRows(0, input.height, threads, [&](int y) {
        for (int x = 0; x < input.width; ++x) {
            const size_t i = static_cast<size_t>(y) * width + static_cast<size_t>(x);
            const float* own = &planes.nearness[i];
            planes.slope[i] = {flatterStep(own, x > 0, x + 1 < input.width, 1),
                               flatterStep(own, y > 0, y + 1 < input.height, width)};
            planes.albedo[i] = *own > 0.0f ? glm::max(input.albedo[i], Vec3(kDarkestAlbedo)) : Vec3(1.0f);
        }
    });
    return planes;
}

std::vector<float> surroundingMeans(const std::vector<float>& values, int width, int height, int half,
                                    int threads) {
    std::vector<float> rows(values.size()), beside(values.size()), means(values.size());
    const auto stride = static_cast<size_t>(width);
    forRows(0, height, threads, [&](int y) {
        const size_t begin = static_cast<size_t>(y) * stride;
        for (int x = 0; x < width; ++x) {
            const size_t own = begin + static_cast<size_t>(x);
            for (int u = std::max(0, x - half); u <= std::min(width - 1, x + half); ++u) {
                beside[own] += u == x ? 0.0f : values[begin + static_cast<size_t>(u)];
            }
            rows[own] = beside[own] + values[own];
        }
    });
    forRows(0, height, threads, [&](int y) {
        for (int x = 0; x < width; ++x) {
            const size_t own = static_cast<size_t>(y) * stride + static_cast<size_t>(x);
            float sum = 0.0f;
            for (int v = std::max(0, y - half); v <= std::min(height - 1, y + half); ++v) {
                sum += (v == y ? beside : rows)[static_cast<size_t>(v) * stride + static_cast<size_t>(x)];
            }
            const int others = boxSize(x, y, width, height, half) - 1;
            means[own] = others > 0 ? sum / static_cast<float>(others) : values[own];
        }
    });
    return means;
}

std::vector<float> boxMinima(const std::vector<float>& values, int width, int height, int half, int threads) {
    std::vector<float> rows(values.size()), least(values.size());
    const auto at = [width](int x, int y) {
        return static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x);
    };
    forRows(0, height, threads, [&](int y) {
        for (int x = 0; x < width; ++x) {
            const auto first = values.begin() + static_cast<std::ptrdiff_t>(at(std::max(0, x - half), y));
            const auto last =
                values.begin() + static_cast<std::ptrdiff_t>(at(std::min(width - 1, x + half), y));
            rows[at(x, y)] = *std::min_element(first, last + 1);
        }
    });
    forRows(0, height, threads, [&](int y) {
        for (int x = 0; x < width; ++x) {
            float smallest = rows[at(x, y)];
            for (int v = std::max(0, y - half); v <= std::min(height - 1, y + half); ++v) {
                smallest = minf(smallest, rows[at(x, v)]);
            }
            least[at(x, y)] = smallest;
        }
    });
    return least;
}

std::vector<float> boxMeans(const std::vector<float>& values, int width, int height, int half, int threads) {
    std::vector<float> rows(values.size()), means(values.size());
    const auto stride = static_cast<size_t>(width);
    forRows(0, height, threads, [&](int y) {
        const size_t begin = static_cast<size_t>(y) * stride;
        for (int x = 0; x < width; ++x) {
            const int first = std::max(0, x - half), last = std::min(width - 1, x + half);
            float sum = 0.0f;
            for (int u = first; u <= last; ++u) {
                sum += values[begin + static_cast<size_t>(u)];
            }
            rows[begin + static_cast<size_t>(x)] = sum / static_cast<float>(last - first + 1);
        }
    });
    forRows(0, height, threads, [&](int y) {
        const int first = std::max(0, y - half), last = std::min(height - 1, y + half);
        const float share = 1.0f / static_cast<float>(last - first + 1);
        float* out = &means[static_cast<size_t>(y) * stride];
        for (int v = first; v <= last; ++v) {
            const float* row = &rows[static_cast<size_t>(v) * stride];
            for (size_t x = 0; x < stride; ++x) {
                out[x] += row[x] * share;
            }
        }
    });
    return means;
}

}  // namespace glint
