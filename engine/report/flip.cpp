// Two pipelines and how they join (Andersson et al. 2020, sections 4.1 to 4.3): colours after filtering
// by the eye's contrast sensitivity, and edges and points of the achromatic channel, which amplify the
// colour difference.
#include "engine/report/flip.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/base/parallel.h"
#include "engine/report/plane_filter.h"

namespace glint {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// The paper's parameters: exponent of the colour difference (q_c), the split of its range (p_c, p_t),
/// exponent of the feature difference (q_f) and the width of the feature detectors in degrees (w).
constexpr double kColorExponent = 0.7;
constexpr double kSplitInput = 0.4;
constexpr double kSplitOutput = 0.95;
constexpr double kFeatureExponent = 0.5;
constexpr double kFeatureWidthDegrees = 0.082;

using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

/// Linear Rec.709 to CIE XYZ with the authors' D65 white, X = 0.95043, Z = 1.08890, so that figures can be
/// compared with published ones.
constexpr Matrix kXyzFromRgb{{{10135552.0 / 24577794.0, 8788810.0 / 24577794.0, 4435075.0 / 24577794.0},
                              {2613072.0 / 12288897.0, 8788810.0 / 12288897.0, 887015.0 / 12288897.0},
                              {1425312.0 / 73733382.0, 8788810.0 / 73733382.0, 70074185.0 / 73733382.0}}};

constexpr Triple times(const Matrix& m, const Triple& v) {
    Triple out{};
    for (size_t row = 0; row < 3; ++row) {
        out[row] = m[row][0] * v[0] + m[row][1] * v[1] + m[row][2] * v[2];
    }
    return out;
}

/// By cofactors.
constexpr Matrix inverse(const Matrix& m) {
    Matrix out{};
    const double determinant = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                               m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                               m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    for (size_t row = 0; row < 3; ++row) {
        for (size_t column = 0; column < 3; ++column) {
            const size_t r1 = (column + 1) % 3, r2 = (column + 2) % 3;
            const size_t c1 = (row + 1) % 3, c2 = (row + 2) % 3;
            out[row][column] = (m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1]) / determinant;
        }
    }
    return out;
}

constexpr Matrix kRgbFromXyz = inverse(kXyzFromRgb);
constexpr Triple kWhite = times(kXyzFromRgb, {1.0, 1.0, 1.0});

/// XYZ over the white's.
Triple relativeXyz(const Triple& rgb) {
    const Triple xyz = times(kXyzFromRgb, rgb);
    return {xyz[0] / kWhite[0], xyz[1] / kWhite[1], xyz[2] / kWhite[2]};
}

/// The linear opponent space of the filters: L*a*b* without its cube roots.
Triple opponentFromRgb(const Triple& rgb) {
    const Triple t = relativeXyz(rgb);
    return {116.0 * t[1] - 16.0, 500.0 * (t[0] - t[1]), 200.0 * (t[1] - t[2])};
}

Triple rgbFromOpponent(const Triple& opponent) {
    const double y = (opponent[0] + 16.0) / 116.0;
    return times(kRgbFromXyz, {(y + opponent[1] / 500.0) * kWhite[0], y * kWhite[1],
                               (y - opponent[2] / 200.0) * kWhite[2]});
}

/// CIE L*a*b* with its chroma scaled by 0.01 L*: dark colours look less saturated (Hunt 1952).
Triple huntLab(const Triple& rgb) {
    constexpr double kDelta = 6.0 / 29.0;
    Triple t = relativeXyz(rgb);
    for (double& value : t) {
        value = value > kDelta * kDelta * kDelta ? std::cbrt(value)
                                                 : value / (3.0 * kDelta * kDelta) + 4.0 / 29.0;
    }
    const double lightness = 116.0 * t[1] - 16.0;
    return {lightness, 0.01 * lightness * 500.0 * (t[0] - t[1]), 0.01 * lightness * 200.0 * (t[1] - t[2])};
}

/// Abasi, Tehran, Fairchild 2020, "Distance metrics for very large color differences".
double hyabDistance(const Triple& a, const Triple& b) {
    return std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]);
}

template <class Body>
void forPixels(size_t count, int threads, const Body& body) {
    parallelChunks(static_cast<int64_t>(count), kPixelsPerChunk, threads, [&](int64_t begin, int64_t end) {
        for (int64_t i = begin; i < end; ++i) {
            body(static_cast<size_t>(i));
        }
    });
}

using Planes = std::array<Plane, 3>;

Triple at(const Planes& planes, size_t i) {
    return {static_cast<double>(planes[0].values[i]), static_cast<double>(planes[1].values[i]),
            static_cast<double>(planes[2].values[i])};
}

void put(const Triple& value, Planes* planes, size_t i) {
    for (size_t c = 0; c < 3; ++c) {
        (*planes)[c].values[i] = static_cast<float>(value[c]);
    }
}

Planes opponentPlanes(const ImageF& image, double exposureStops, int threads) {
    const size_t count = static_cast<size_t>(image.width) * static_cast<size_t>(image.height);
    Planes planes;
    planes.fill({.width = image.width, .height = image.height, .values = std::vector<float>(count)});
    const double exposure = std::exp2(exposureStops);
    forPixels(count, threads, [&](size_t i) {
        Triple rgb{};
        for (size_t c = 0; c < 3; ++c) {
            rgb[c] = std::clamp(exposure * static_cast<double>(image.rgb[3 * i + c]), 0.0, 1.0);
        }
        put(opponentFromRgb(rgb), &planes, i);
    });
    return planes;
}

/// One term of a contrast sensitivity function in the spatial domain (equation 4): a sqrt(pi / b) exp(-pi^2
/// x^2 / b) for x in degrees.
struct CsfTerm {
    double a, b;
};

/// Of the achromatic, red-green and blue-yellow channel (table 1).
constexpr std::array<CsfTerm, 1> kAchromatic{{{1.0, 0.0047}}};
constexpr std::array<CsfTerm, 1> kRedGreen{{{1.0, 0.0053}}};
constexpr std::array<CsfTerm, 2> kBlueYellow{{{34.1, 0.04}, {13.5, 0.025}}};
constexpr double kWidestB = 0.04;

/// The channel as the eye resolves it: the terms are Gaussians, so each is separable, and together they sum
/// to 1.
Plane filteredBySensitivity(const Plane& channel, std::span<const CsfTerm> terms, double pixelsPerDegree,
                            int threads) {
    const int radius =
        static_cast<int>(std::ceil(3.0 * std::sqrt(kWidestB / (2.0 * kPi * kPi)) * pixelsPerDegree));
    std::vector<double> shares;
    std::vector<std::vector<double>> kernels;
    double total = 0.0;
    for (const CsfTerm& term : terms) {
        const double deviation = std::sqrt(term.b / (2.0 * kPi * kPi)) * pixelsPerDegree;
        kernels.push_back(gaussianWeights(deviation, radius));
        const double sum = 1.0 / kernels.back()[static_cast<size_t>(radius)];
        shares.push_back(term.a * std::sqrt(kPi / term.b) * sum * sum);
        total += shares.back();
    }
    Plane out = filterSeparable(channel, kernels[0], kernels[0], threads);
    for (size_t i = 1; i < terms.size(); ++i) {
        const Plane other = filterSeparable(channel, kernels[i], kernels[i], threads);
        forPixels(out.values.size(), threads, [&](size_t pixel) {
            out.values[pixel] = static_cast<float>((shares[0] * static_cast<double>(out.values[pixel]) +
                                                    shares[i] * static_cast<double>(other.values[pixel])) /
                                                   total);
        });
    }
    return out;
}

/// What the eye sees of the colours: filtered, cut to what the screen shows, as L*a*b*.
Planes seenColors(const Planes& opponent, double pixelsPerDegree, int threads) {
    Planes seen{filteredBySensitivity(opponent[0], kAchromatic, pixelsPerDegree, threads),
                filteredBySensitivity(opponent[1], kRedGreen, pixelsPerDegree, threads),
                filteredBySensitivity(opponent[2], kBlueYellow, pixelsPerDegree, threads)};
    forPixels(seen[0].values.size(), threads, [&](size_t i) {
        Triple rgb = rgbFromOpponent(at(seen, i));
        for (double& channel : rgb) {
            channel = std::clamp(channel, 0.0, 1.0);
        }
        put(huntLab(rgb), &seen, i);
    });
    return seen;
}

/// Positive weights sum to 1 and negative ones to -1, each side scaled on its own.
void balance(std::vector<double>* weights) {
    double positive = 0.0;
    double negative = 0.0;
    for (const double weight : *weights) {
        (weight > 0.0 ? positive : negative) += weight;
    }
    for (double& weight : *weights) {
        weight /= weight > 0.0 ? positive : -negative;
    }
}

/// Strength of edges (first derivatives) and points (second derivatives) in every pixel.
struct Features {
    std::vector<float> edges, points;
};

std::vector<float> lengths(const Plane& across, const Plane& down, int threads) {
    std::vector<float> out(across.values.size());
    forPixels(out.size(), threads, [&](size_t i) { out[i] = std::hypot(across.values[i], down.values[i]); });
    return out;
}

Features featuresOf(const Plane& achromatic, double pixelsPerDegree, int threads) {
    const double deviation = 0.5 * kFeatureWidthDegrees * pixelsPerDegree;
    const int radius = static_cast<int>(std::ceil(3.0 * deviation));
    const std::vector<double> smooth = gaussianWeights(deviation, radius);
    std::vector<double> edge;
    std::vector<double> point;
    for (size_t i = 0; i < smooth.size(); ++i) {
        const double x = static_cast<double>(i) - radius;
        const double weight = smooth[i];
        edge.push_back(-x * weight);
        point.push_back((x * x / (deviation * deviation) - 1.0) * weight);
    }
    balance(&edge);
    balance(&point);
    Plane normalized = achromatic;
    forPixels(normalized.values.size(), threads,
              [&](size_t i) { normalized.values[i] = (normalized.values[i] + 16.0f) / 116.0f; });
    return {.edges = lengths(filterSeparable(normalized, edge, smooth, threads),
                             filterSeparable(normalized, smooth, edge, threads), threads),
            .points = lengths(filterSeparable(normalized, point, smooth, threads),
                              filterSeparable(normalized, smooth, point, threads), threads)};
}

/// To [0, 1]: most of the range for the differences that are common, the rest for the largest
/// (section 4.1.3).
double redistributed(double hyab) {
    static const double kLargest =
        std::pow(hyabDistance(huntLab({0.0, 1.0, 0.0}), huntLab({0.0, 0.0, 1.0})), kColorExponent);
    const double difference = std::pow(hyab, kColorExponent);
    const double split = kSplitInput * kLargest;
    if (difference < split) { return kSplitOutput / split * difference; }
    return kSplitOutput + (difference - split) / (kLargest - split) * (1.0 - kSplitOutput);
}

struct Appearance {
    Planes colors;
    Features features;
};

Appearance appearanceOf(const ImageF& image, double exposureStops, double pixelsPerDegree, int threads) {
    const Planes opponent = opponentPlanes(image, exposureStops, threads);
    return {seenColors(opponent, pixelsPerDegree, threads),
            featuresOf(opponent[0], pixelsPerDegree, threads)};
}

}  // namespace

std::vector<float> flipMap(const ImageF& a, const ImageF& b, double exposureStops, double pixelsPerDegree,
                           int threads) {
    const Appearance seenA = appearanceOf(a, exposureStops, pixelsPerDegree, threads);
    const Appearance seenB = appearanceOf(b, exposureStops, pixelsPerDegree, threads);
    std::vector<float> map(seenA.features.edges.size());
    forPixels(map.size(), threads, [&](size_t i) {
        const double color = redistributed(hyabDistance(at(seenA.colors, i), at(seenB.colors, i)));
        const float edge = std::abs(seenA.features.edges[i] - seenB.features.edges[i]);
        const float point = std::abs(seenA.features.points[i] - seenB.features.points[i]);
        const double feature =
            std::pow(static_cast<double>(std::max(edge, point)) / std::sqrt(2.0), kFeatureExponent);
        map[i] = static_cast<float>(std::pow(color, 1.0 - feature));
    });
    return map;
}

}  // namespace glint
