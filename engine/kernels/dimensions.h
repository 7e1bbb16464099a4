// The name of every random number that a path draws. Host and device.
//
// A draw is keyed by its dimension, so two draws of one path must never share one. A new use gets a new name
// here; it may not borrow another's.
#pragma once

#include <cstdint>

#include "engine/base/host_device.h"

namespace glint {

/// Drawn once a path.
enum class CameraDimension : uint32_t {
    PixelFilter,  ///< 2-D
    Lens,         ///< 2-D
    Count,
};

/// Drawn at every scattering event.
enum class BounceDimension : uint32_t {
    Lobe,         ///< 1-D: which lobe of the BSDF; not drawn where bsdf.h's usesLobeChoice() is false
    Direction,    ///< 2-D
    LightChoice,  ///< 1-D
    LightPoint,   ///< 2-D
    Roulette,     ///< 1-D
    Count,
};

/// Drawn once a photon, which has a key of its own and scatters with BounceDimension like a path.
enum class EmissionDimension : uint32_t {
    Light,      ///< 1-D
    Point,      ///< 2-D
    Direction,  ///< 2-D
    Count,
};

/// Drawn once a pixel when its photons are gathered (disc_coverage.h).
enum class GatherDimension : uint32_t {
    DiscPoint,  ///< 2-D
    WallAngle,  ///< 1-D
    Count,
};

/// Drawn at most once a path or photon (spectrum.h).
enum class SpectrumDimension : uint32_t {
    Wavelength = static_cast<uint32_t>(GatherDimension::Count),  ///< 1-D
};

/// A dimension of a path's sample vector. Draws of one dimension in one and in two dimensions are
/// not independent.
struct Dimension {
    uint32_t index = 0;
};

GLINT_HD constexpr Dimension dimension(CameraDimension name) { return {static_cast<uint32_t>(name)}; }

GLINT_HD constexpr Dimension dimension(EmissionDimension name) { return {static_cast<uint32_t>(name)}; }

/// Counted from the other end, which no bounce reaches.
GLINT_HD constexpr Dimension dimension(GatherDimension name) { return {~static_cast<uint32_t>(name)}; }
GLINT_HD constexpr Dimension dimension(SpectrumDimension name) { return {~static_cast<uint32_t>(name)}; }

/// `bounce` counts scattering events from 0 at the first hit.
GLINT_HD constexpr Dimension dimension(BounceDimension name, int bounce) {
    constexpr auto kCamera = static_cast<uint32_t>(CameraDimension::Count);
    constexpr auto kEmission = static_cast<uint32_t>(EmissionDimension::Count);
    constexpr auto kFirst = kCamera > kEmission ? kCamera : kEmission;
    constexpr auto kPerBounce = static_cast<uint32_t>(BounceDimension::Count);
    return {kFirst + kPerBounce * static_cast<uint32_t>(bounce) + static_cast<uint32_t>(name)};
}

}  // namespace glint
