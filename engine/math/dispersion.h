// How a glass's index of refraction depends on the wavelength. Host and device.
#pragma once

#include <cmath>
#include <cstdint>

#include "engine/base/host_device.h"

namespace glint {

/// Fraunhofer's lines that glasses are measured at, nm: hydrogen's blue, helium's yellow, hydrogen's red.
constexpr float kLineFNm = 486.133f;
constexpr float kLineDNm = 587.562f;
constexpr float kLineCNm = 656.273f;

/// Cauchy: n = a + b[0] / w^2 + b[1] / w^4. Sellmeier: n^2 = 1 + the sum of b[i] w^2 / (w^2 - c[i]). The
/// wavelength w in micrometres.
enum class DispersionFormula : uint8_t { None, Cauchy, Sellmeier };

struct Dispersion {
    static constexpr int kTerms = 4;

    DispersionFormula formula = DispersionFormula::None;
    float b[kTerms] = {};
    float c[kTerms] = {};

    bool operator==(const Dispersion&) const = default;
};

namespace detail {

GLINT_HD inline float sellmeierIndex(const Dispersion& glass, float micrometres) {
    const float squared = micrometres * micrometres;
    float sum = 1.0f;
    for (int i = 0; i < Dispersion::kTerms; ++i) {
        sum += glass.b[i] * squared / (squared - glass.c[i]);
    }
    return std::sqrt(sum);
}

}  // namespace detail

/// The index at a wavelength less the one at helium's d line, which is the one that glasses are named by.
/// `nm`: in a vacuum or in air, 300 to 1000.
GLINT_HD inline float indexShift(const Dispersion& glass, float nm) {
    constexpr float kD = 1e-3f * kLineDNm;
    const float micrometres = 1e-3f * nm;
    switch (glass.formula) {
        case DispersionFormula::Cauchy: {
            const float x = 1.0f / (micrometres * micrometres), d = 1.0f / (kD * kD);
            return glass.b[0] * (x - d) + glass.b[1] * (x * x - d * d);
        }
        case DispersionFormula::Sellmeier:
            return detail::sellmeierIndex(glass, micrometres) - detail::sellmeierIndex(glass, kD);
        case DispersionFormula::None:
            break;
    }
    return 0.0f;
}

/// Cauchy's formula with the Abbe number V = (nd - 1) / (nF - nC) of a glass of index `nd`; V > 0.
inline Dispersion dispersionOfAbbeNumber(float nd, float abbeNumber) {
    const auto perSquare = [](float nm) { return 1e6f / (nm * nm); };
    Dispersion glass;
    glass.formula = DispersionFormula::Cauchy;
    glass.b[0] = (nd - 1.0f) / (abbeNumber * (perSquare(kLineFNm) - perSquare(kLineCNm)));
    return glass;
}

/// (nd - 1) / (nF - nC); infinite without dispersion.
inline float abbeNumber(const Dispersion& glass, float nd) {
    return (nd - 1.0f) / (indexShift(glass, kLineFNm) - indexShift(glass, kLineCNm));
}

}  // namespace glint
