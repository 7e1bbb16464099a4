// CIE 15: 2004, tables T.1 (illuminant D65, every 10 nm) and T.4 (the standard observer of 2 degrees, every
// 5 nm).
#include "engine/io/spectrum_colors.h"

#include <algorithm>
#include <cmath>

namespace glint {
namespace {

constexpr double kFirstNm = 360.0, kLastNm = 780.0, kObserverStepNm = 5.0, kIlluminantStepNm = 10.0;

constexpr double kObserver[][3] = {{.0001299, .000003917, .0006061},
                                   {.000232, .000006965, .001086},
                                   {.0004149, .00001239, .001946},
                                   {.0007416, .00002202, .003486},
                                   {.001368, .000039, .00645},
                                   {.002236, .000064, .01055},
                                   {.004243, .00012, .02005},
                                   {.00765, .000217, .03621},
                                   {.01431, .000396, .06785},
                                   {.02319, .00064, .1102},
                                   {.04351, .00121, .2074},
                                   {.07763, .00218, .3713},
                                   {.13438, .004, .6456},
                                   {.21477, .0073, 1.03905},
                                   {.2839, .0116, 1.3856},
                                   {.3285, .01684, 1.62296},
                                   {.34828, .023, 1.74706},
                                   {.34806, .0298, 1.7826},
                                   {.3362, .038, 1.77211},
                                   {.3187, .048, 1.7441},
                                   {.2908, .06, 1.6692},
                                   {.2511, .0739, 1.5281},
                                   {.19536, .09098, 1.28764},
                                   {.1421, .1126, 1.0419},
                                   {.09564, .13902, .81295},
                                   {.05795, .1693, .6162},
                                   {.03201, .20802, .46518},
                                   {.0147, .2586, .3533},
                                   {.0049, .323, .272},
                                   {.0024, .4073, .2123},
                                   {.0093, .503, .1582},
                                   {.0291, .6082, .1117},
                                   {.06327, .71, .07825},
                                   {.1096, .7932, .05725},
                                   {.1655, .862, .04216},
                                   {.22575, .91485, .02984},
                                   {.2904, .954, .0203},
                                   {.3597, .9803, .0134},
                                   {.43345, .99495, .00875},
                                   {.51205, 1, .00575},
                                   {.5945, .995, .0039},
                                   {.6784, .9786, .00275},
                                   {.7621, .952, .0021},
                                   {.8425, .9154, .0018},
                                   {.9163, .87, .00165},
                                   {.9786, .8163, .0014},
                                   {1.0263, .757, .0011},
                                   {1.0567, .6949, .001},
                                   {1.0622, .631, .0008},
                                   {1.0456, .5668, .0006},
                                   {1.0026, .503, .00034},
                                   {.9384, .4412, .00024},
                                   {.85445, .381, .00019},
                                   {.7514, .321, .0001},
                                   {.6424, .265, .00005},
                                   {.5419, .217, .00003},
                                   {.4479, .175, .00002},
                                   {.3608, .1382, .00001},
                                   {.2835, .107, 0},
                                   {.2187, .0816, 0},
                                   {.1649, .061, 0},
                                   {.1212, .04458, 0},
                                   {.0874, .032, 0},
                                   {.0636, .0232, 0},
                                   {.04677, .017, 0},
                                   {.0329, .01192, 0},
                                   {.0227, .00821, 0},
                                   {.01584, .005723, 0},
                                   {.011359, .004102, 0},
                                   {.008111, .002929, 0},
                                   {.00579, .002091, 0},
                                   {.004109, .001484, 0},
                                   {.002899, .001047, 0},
                                   {.002049, .00074, 0},
                                   {.00144, .00052, 0},
                                   {.001, .000361, 0},
                                   {.00069, .000249, 0},
                                   {.000476, .000172, 0},
                                   {.000332, .00012, 0},
                                   {.000235, .000085, 0},
                                   {.000166, .00006, 0},
                                   {.000117, .000042, 0},
                                   {.000083, .00003, 0},
                                   {.000059, .000021, 0},
                                   {.000042, .000015, 0}};

constexpr double kD65[] = {46.6383, 52.0891, 49.9755, 54.6482, 82.7549, 91.486,  93.4318, 86.6823, 104.865,
                           117.008, 117.812, 114.861, 115.923, 108.811, 109.354, 107.802, 104.79,  107.689,
                           104.405, 104.046, 100,     96.3342, 95.788,  88.6856, 90.0062, 89.5991, 87.6987,
                           83.2886, 83.6992, 80.0268, 80.2146, 82.2778, 78.2842, 69.7213, 71.6091, 74.349,
                           61.604,  69.8856, 75.087,  63.5927, 46.4182, 66.8054, 63.3828};

struct TablePlace {
    size_t first;
    double weight;
};

TablePlace placeIn(double nm, double step, size_t size) {
    const double position = (nm - kFirstNm) / step;
    const size_t first = std::min(static_cast<size_t>(position), size - 2);
    return {first, position - static_cast<double>(first)};
}

glm::dvec3 observerAt(double nm) {
    const auto [i, weight] = placeIn(nm, kObserverStepNm, std::size(kObserver));
    const auto row = [](size_t index) {
        return glm::dvec3(kObserver[index][0], kObserver[index][1], kObserver[index][2]);
    };
    return glm::mix(row(i), row(i + 1), weight);
}

double d65At(double nm) {
    const auto [i, weight] = placeIn(nm, kIlluminantStepNm, std::size(kD65));
    return (1.0 - weight) * kD65[i] + weight * kD65[i + 1];
}

template <class Spectrum>
Vec3 integrated(const Spectrum& spectrum, SpectrumRole role) {
    glm::dvec3 xyz(0.0);
    double white = 0.0;
    constexpr double kStepNm = 0.25;
    constexpr int kSteps = static_cast<int>((kLastNm - kFirstNm) / kStepNm);
    for (int i = 0; i <= kSteps; ++i) {
        const double nm = kFirstNm + i * kStepNm;
        const double illuminant = role == SpectrumRole::Reflectance ? d65At(nm) : 1.0;
        const glm::dvec3 observer = illuminant * observerAt(nm);
        xyz += spectrum(nm) * observer;
        white += observer.y;
    }
    return rgbOfXyz(xyz / white);
}

}  // namespace

std::optional<std::vector<SpectrumSample>> spectrumOfPairs(std::span<const double> numbers) {
    std::vector<SpectrumSample> samples;
    for (size_t i = 0; i + 1 < numbers.size(); i += 2) {
        samples.push_back({numbers[i], numbers[i + 1]});
    }
    const auto isNotRising = [](const auto& a, const auto& b) { return !(a.nm < b.nm); };
    const bool areRising = std::ranges::adjacent_find(samples, isNotRising) == samples.end();
    if (numbers.size() % 2 != 0 || samples.empty() || !areRising) { return std::nullopt; }
    return samples;
}

Vec3 rgbOfSpectrum(std::span<const SpectrumSample> samples, SpectrumRole role) {
    size_t next = 0;
    return integrated(
        [&](double nm) {
            if (nm < samples.front().nm || nm > samples.back().nm) { return 0.0; }
            while (next + 1 < samples.size() && samples[next].nm < nm) {
                ++next;
            }
            if (next == 0) { return samples[0].value; }
            const SpectrumSample &a = samples[next - 1], &b = samples[next];
            return a.value + (b.value - a.value) * (nm - a.nm) / (b.nm - a.nm);
        },
        role);
}

double blackbodyRadiance(double nm, double kelvin) {
    constexpr double kPlanck = 6.62607015e-34, kLight = 299792458.0, kBoltzmann = 1.380649e-23;
    const double metres = 1e-9 * nm;
    return 1e-9 * 2.0 * kPlanck * kLight * kLight /
           (std::pow(metres, 5.0) * std::expm1(kPlanck * kLight / (metres * kBoltzmann * kelvin)));
}

Vec3 rgbOfBlackbody(double kelvin) {
    const Vec3 rgb =
        integrated([&](double nm) { return blackbodyRadiance(nm, kelvin); }, SpectrumRole::Emission);
    return glm::max(rgb, Vec3(0.0f));
}

Vec3 rgbOfXyz(const glm::dvec3& xyz) {
    return {static_cast<float>(3.2404542 * xyz.x - 1.5371385 * xyz.y - 0.4985314 * xyz.z),
            static_cast<float>(-0.9692660 * xyz.x + 1.8760108 * xyz.y + 0.0415560 * xyz.z),
            static_cast<float>(0.0556434 * xyz.x - 0.2040259 * xyz.y + 1.0572252 * xyz.z)};
}

}  // namespace glint
