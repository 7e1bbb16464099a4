#include "engine/denoise/sparks.h"

#include <algorithm>
#include <array>
#include <utility>

#include "engine/denoise/planes.h"
#include "engine/math/color.h"

namespace glint {
namespace {

constexpr int kSparkHalf = 2;
/// Two sparks close by do not hide each other.
constexpr size_t kSparkRank = 3;
constexpr float kSparkRatio = 3.0f;
/// A single bright sample among many lies one standard error off.
constexpr float kSparkOwnErrors = 1.2f;

size_t pixelAt(const DenoiseInput& input, int x, int y) {
    return static_cast<size_t>(y) * static_cast<size_t>(input.width) + static_cast<size_t>(x);
}

/// The third largest value of each channel around a pixel; 0 where there are fewer pixels.
Vec3 thirdAround(const DenoiseInput& input, int x, int y) {
    std::array<Vec3, kSparkRank> largest{};
    for (int v = std::max(0, y - kSparkHalf); v <= std::min(input.height - 1, y + kSparkHalf); ++v) {
        for (int u = std::max(0, x - kSparkHalf); u <= std::min(input.width - 1, x + kSparkHalf); ++u) {
            if (u == x && v == y) { continue; }
            Vec3 value = input.radiance[pixelAt(input, u, v)];
            for (Vec3& each : largest) {
                const Vec3 smaller = glm::min(each, value);
                each = glm::max(each, std::exchange(value, smaller));
            }
        }
    }
    return largest.back();
}

}  // namespace

CalmImage withoutSparks(const DenoiseInput& input, const std::vector<float>& variance, int threads) {
    CalmImage calm{input.radiance, std::vector<char>(input.radiance.size(), 0)};
    forRows(0, input.height, threads, [&](int y) {
        for (int x = 0; x < input.width; ++x) {
            const size_t i = pixelAt(input, x, y);
            const Vec3& own = input.radiance[i];
            const Vec3 third = thirdAround(input, x, y);
            if (!(maxComponent(own - kSparkRatio * third) > 0.0f)) { continue; }
            const Vec3 less = glm::min(own, third);
            if (!(square(luminance(own - less)) < square(kSparkOwnErrors) * variance[i])) { continue; }
            calm.radiance[i] = less;
            calm.isSpark[i] = 1;
        }
    });
    return calm;
}

}  // namespace glint
