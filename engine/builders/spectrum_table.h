// The spectrum, cut into equally likely parts, for scenes that disperse light.
#pragma once

#include <vector>

#include "engine/kernels/shading_view.h"

namespace glint {

/// One wavelength for each channel: those at which red, green and blue of Rec.709 are brightest, about.
constexpr Vec3 kChannelWavelengthsNm{611.0f, 549.0f, 465.0f};

/// Over 380 to 780 nm. What a wavelength adds to red, green and blue of linear Rec.709 follows from the CIE
/// 1931 observer (Wyman, Sloan and Shirley 2013, "Simple Analytic Approximations to the CIE XYZ Color
/// Matching Functions", equation 4). Spectral colours lie outside Rec.709: what would be negative is left
/// out, and each channel is scaled so that an even spectrum is white. A wavelength is as likely as it is
/// bright in all three channels together, so that no weight exceeds 3.
std::vector<SpectrumStratum> tabulateSpectrum();

/// Three wavelengths, each of which is all of a channel.
std::vector<SpectrumStratum> tabulateThreeChannels();

}  // namespace glint
