// Values per pixel in the metrics' own terms, then a readable range for them, then colours.
#include "engine/report/error_maps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/base/parallel.h"
#include "engine/math/vec.h"
#include "engine/render/tonemap.h"
#include "engine/report/finite_pixels.h"
#include "engine/report/flip.h"
#include "engine/report/heat_map.h"
#include "engine/report/plane_filter.h"

namespace glint {
namespace {

constexpr double kShareBeyondRange = 0.001;
constexpr double kShareBeyondSignedRange = 0.01;  ///< its linear scale would show nothing but the outliers
constexpr double kDecades = 4.0;
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

float pixelError(ErrorMapKind kind, const float* test, const float* reference, double epsilon) {
    double sum = 0.0;
    for (int c = 0; c < 3; ++c) {
        const double r = static_cast<double>(reference[c]);
        const double error = static_cast<double>(test[c]) - r;
        if (kind == ErrorMapKind::RelativeSquared) {
            sum += error * error / (r * r + epsilon);
        } else {
            sum += kind == ErrorMapKind::Signed ? error : std::abs(error);
        }
    }
    constexpr double kMost = static_cast<double>(std::numeric_limits<float>::max());
    return std::isfinite(sum) ? static_cast<float>(std::clamp(sum / 3.0, -kMost, kMost)) : kNan;
}

/// 1, 2 or 5 times a power of ten, at least `value`.
double roundedUp(double value) {
    const double decade = std::pow(10.0, std::floor(std::log10(value)));
    for (const double step : {1.0, 2.0, 5.0}) {
        if (step * decade >= value) { return step * decade; }
    }
    return 10.0 * decade;
}

/// The largest magnitude but for that share of the pixels; 0 when there is no error.
double robustMaximum(const ErrorMap& map, double shareBeyond) {
    std::vector<float> magnitudes;
    for (const float value : map.values) {
        if (std::isfinite(value)) { magnitudes.push_back(std::abs(value)); }
    }
    if (magnitudes.empty()) { return 0.0; }
    const auto beyond = static_cast<std::ptrdiff_t>(shareBeyond * static_cast<double>(magnitudes.size()));
    const auto place = magnitudes.begin() + beyond;
    std::nth_element(magnitudes.begin(), place, magnitudes.end(), std::greater<>());
    return static_cast<double>(*place);
}

Vec3 colorOf(float value, ErrorMapKind kind, const MapRange& range) {
    if (!std::isfinite(value)) { return Vec3(1.0f, 0.0f, 1.0f); }
    if (value == 0.0f) { return Vec3(0.0f); }
    const double v = static_cast<double>(value);
    if (kind == ErrorMapKind::Signed) { return signedColor(static_cast<float>(v / range.high)); }
    const double share = range.logarithmic ? std::log(v / range.low) / std::log(range.high / range.low)
                                           : (v - range.low) / (range.high - range.low);
    return heatColor(static_cast<float>(share));
}

}  // namespace

std::string_view errorMapName(ErrorMapKind kind) {
    constexpr std::array<std::string_view, kErrorMapKindCount> kNames{"relative-squared", "absolute",
                                                                      "signed", "flip"};
    return kNames[static_cast<size_t>(kind)];
}

Result<ErrorMap> errorMap(ErrorMapKind kind, const ImageF& test, const ImageF& reference,
                          const MetricOptions& options) {
    MetricOptions cheap = options;
    cheap.ssim = cheap.flip = false;
    const auto comparable = compareImages(test, reference, cheap);
    if (!comparable) { return comparable.error(); }
    ErrorMap map{.kind = kind, .width = test.width, .height = test.height, .values = {}};
    const size_t count = static_cast<size_t>(test.width) * static_cast<size_t>(test.height);
    if (kind == ErrorMapKind::Flip) {
        const std::vector<uint8_t> finite = finiteInBoth(test, reference);
        map.values = flipMap(withBlackWhere(test, finite), withBlackWhere(reference, finite),
                             options.exposureStops, options.pixelsPerDegree, options.threads);
    } else {
        map.values.resize(count);
    }
    parallelChunks(
        static_cast<int64_t>(count), kPixelsPerChunk, options.threads, [&](int64_t begin, int64_t end) {
            for (auto i = static_cast<size_t>(begin); i < static_cast<size_t>(end); ++i) {
                const float error =
                    pixelError(kind, &test.rgb[3 * i], &reference.rgb[3 * i], options.relativeEpsilon);
                if (kind != ErrorMapKind::Flip || std::isnan(error)) { map.values[i] = error; }
            }
        });
    return map;
}

MapRange readableRange(const ErrorMap& map) {
    if (map.kind == ErrorMapKind::Flip) { return {}; }
    const bool isSigned = map.kind == ErrorMapKind::Signed;
    const double largest = robustMaximum(map, isSigned ? kShareBeyondSignedRange : kShareBeyondRange);
    if (isSigned) {
        const double limit = largest > 0.0 ? roundedUp(largest) : 1.0;
        return {.low = -limit, .high = limit, .logarithmic = false};
    }
    const double exponent = largest > 0.0 ? std::ceil(std::log10(largest)) : 0.0;
    return {
        .low = std::pow(10.0, exponent - kDecades), .high = std::pow(10.0, exponent), .logarithmic = true};
}

Image8 falseColors(const ErrorMap& map, const MapRange& range) {
    Image8 image{.width = map.width, .height = map.height, .rgb = {}};
    image.rgb.reserve(3 * map.values.size());
    for (const float value : map.values) {
        const Vec3 color = colorOf(value, map.kind, range);
        for (int c = 0; c < 3; ++c) {
            image.rgb.push_back(displayByte(color[c]));
        }
    }
    return image;
}

}  // namespace glint
