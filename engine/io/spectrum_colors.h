// Spectra as linear Rec.709. For the readers of Mitsuba and pbrt scenes.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "engine/math/vec.h"

namespace glint {

struct SpectrumSample {
    double nm = 0.0;
    double value = 0.0;
};

/// Samples of a list of pairs; nothing unless there are some, and their wavelengths rise.
std::optional<std::vector<SpectrumSample>> spectrumOfPairs(std::span<const double> numbers);
constexpr std::string_view kExpectedPairs = "expected pairs of a wavelength and a value, wavelengths rising";

enum class SpectrumRole : uint8_t {
    Reflectance,  ///< seen under D65: a constant spectrum keeps its value
    Emission,     ///< against the equal-energy white: of 1 W/(m^2 sr nm), Y is 1
    Index,        ///< of refraction: as an emission
};

/// Linear Rec.709 of samples in rising order, linear between them and 0 beyond, by the CIE 1931 observer of 2
/// degrees from 360 to 780 nm; may be negative.
Vec3 rgbOfSpectrum(std::span<const SpectrumSample> samples, SpectrumRole role);
/// A black body's radiance in W/(m^2 sr nm) (Planck 1901), at a wavelength and as a colour.
double blackbodyRadiance(double nm, double kelvin);
Vec3 rgbOfBlackbody(double kelvin);
Vec3 rgbOfXyz(const glm::dvec3& xyz);

}  // namespace glint
