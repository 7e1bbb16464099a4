// Spectra as linear Rec.709, and colours of Mitsuba's files.
#pragma once

#include <optional>
#include <span>

#include "engine/io/mitsuba_object.h"
#include "engine/math/vec.h"

namespace glint {

struct SpectrumSample {
    double nm = 0.0;
    double value = 0.0;
};

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

/// A colour: rgb, srgb, spectrum, blackbody or a single number. Not negative; reflectances up to 1.
Vec3 mitsubaColor(MitsubaContext* context, const MitsubaElement& at, SpectrumRole role);

/// A colour, or the texture that stands in its place.
struct MitsubaInput {
    Vec3 color{0.5f};
    const MitsubaElement* texture = nullptr;
};

/// The first of these properties that is there, which may be a texture; nothing: none is.
std::optional<MitsubaInput> mitsubaInput(MitsubaObject* object, std::initializer_list<std::string_view> names,
                                         SpectrumRole role);

/// The index of refraction of a named dielectric, as Mitsuba has them; nothing for an unknown name.
std::optional<float> mitsubaIndex(std::string_view name);

/// eta and k of a named conductor.
struct MitsubaMetal {
    Vec3 eta, k;
};
/// Mitsuba's short names, "Au"; nothing for one that Glint has no constants of.
std::optional<MitsubaMetal> mitsubaMetal(std::string_view name);

}  // namespace glint
