// Colours of pbrt's parameters as linear Rec.709. Internal to the pbrt importer.
#pragma once

#include <optional>

#include "engine/io/pbrt_params.h"
#include "engine/io/spectrum_colors.h"

namespace glint {

/// "srgb", "rec2020", "aces2065-1", "dci-p3"; nothing for other names.
std::optional<PbrtColorSpace> pbrtColorSpace(std::string_view name);

/// A linear value of that space. As a reflectance, white is white; as light, it is the space's own white.
Vec3 rgbOfSpace(PbrtColorSpace space, const Vec3& rgb, SpectrumRole role);

/// A colour: rgb, xyz, a spectrum of samples, by name or of a file, a black body, or one number. Not
/// negative; reflectances up to 1. Light that is no `rgb` has luminance 1, as pbrt-v4 scales it. An index
/// keeps constant spectra, and is above 0.
Vec3 pbrtColor(const PbrtParams& params, const PbrtParam& param, SpectrumRole role);

/// Linear Rec.709 to the same, such that light of a temperature becomes white, as pbrt's sensors see it:
/// daylight of the CIE, and black bodies below 4000 K; cone responses of Bradford's matrix are scaled.
Mat3 pbrtWhiteBalance(double kelvin);

/// The metal of metals.h whose eta or k a named spectrum is; empty: none.
std::string_view pbrtMetal(std::string_view spectrum);
/// The glass of glasses.h that a named spectrum is; empty: none.
std::string_view pbrtGlass(std::string_view spectrum);
/// The other way.
std::string_view pbrtSpectrumOfGlass(std::string_view glass);

}  // namespace glint
