// What stochastic progressive photon mapping keeps: per pixel, per visible point and per photon. Plain data.
//
// Hachisuka and Jensen 2009, "Stochastic Progressive Photon Mapping". Written by the SPPM kernels (sppm_*.h),
// owned by render/sppm_state.h. Sizes are part of the memory budget and asserted below.
#pragma once

#include <bit>
#include <cmath>

#include "engine/kernels/pass.h"
#include "engine/math/bounds.h"
#include "engine/math/vec.h"

namespace glint {

/// Longer paths are cut off: visible points and photons count their scattering events in 8 bits.
constexpr int kMostPhotonScatterings = 256;

struct SppmParams {
    PassParams pass;
    uint32_t photonsPerPass = 262144;
    double alpha = 2.0 / 3.0;  ///< share of each pass's photons that is kept, in (0, 1)
    float radiusWorld = 0.0f;  ///< initial radius; 0: automatic
    /// automatic: initial radius in footprints of a pixel at its first visible point
    float radiusFootprints = 4.0f;
    /// metal and glass of at least this GGX alpha store visible points; sharper ones reflect
    float storeAlpha = 0.1f;
    PhotonLookupKind lookup = PhotonLookupKind::Grid;
    bool sampleDirectLight = true;  ///< photons then carry only light that was scattered at least once
    /// set for each pass by the back end (photon_surface.h)
    bool photonsKnowSurface = false;
    bool photonsKnowBand = false;  ///< likewise: of the spectrum
};

/// The statistics of one pixel over all passes since they were last cleared (the paper's R, N and tau).
struct SppmPixel {
    double radiusSquared = 0.0;  ///< world units squared; 0: no visible point seen yet
    double photonCount = 0.0;    ///< N
    double flux[3] = {};         ///< tau: reflected, unnormalised
    float bias = 0.0f;           ///< running mean of the passes' estimates of the luminance's bias, signed
    float passM2 = 0.0f;         ///< squared deviations of the passes' luminances from their mean (Welford)
    float probes = 0.0f;         ///< points of the passes' discs that were looked at (disc_coverage.h)
    float covered = 0.0f;        ///< those of them where photons could lie
};

/// Where a pixel's camera path of this pass came to rest. `throughput` zero: nowhere, and no photon
/// can count.
struct VisiblePoint {
    Vec3 p{0.0f};
    Vec3 throughput{0.0f};   ///< of the camera path up to here, filter and lens included
    Vec3 woWorld{0.0f};      ///< towards the previous vertex
    Vec3 vertexColor{1.0f};  ///< withHalfTurn(), where facets have a direction
    Vec2 uv{0.0f};
    uint32_t nsPacked = 0;  ///< shading normal (octahedral.h)
    uint32_t ngPacked = 0;  ///< geometric normal of the front side
    uint32_t instance : 23 = 0;
    uint32_t hasWavelength : 1 = 0;  ///< the path's, which its sampler tells (spectrum.h)
    uint32_t depth : 8 = 0;          ///< scattering events before this one
    /// about the width of a pixel here, world units: length of the path times the pixel's angle. Where a
    /// texture has a mip map, withUvWidth().
    float footprint = 0.0f;
};

/// Tenths of an octave in place of the footprint's last eight bits: a visible point has no room for more.
GLINT_HD inline float withUvWidth(float footprint, float uvWidth) {
    const float tenths = 10.0f * (std::log2(uvWidth) + 20.0f);
    const auto code = static_cast<uint32_t>(tenths > 1.0f ? (tenths < 255.0f ? tenths : 255.0f) : 1.0f);
    return std::bit_cast<float>((std::bit_cast<uint32_t>(footprint) & ~0xffu) | code);
}
GLINT_HD inline float uvWidthIn(float footprint) {
    const uint32_t code = std::bit_cast<uint32_t>(footprint) & 0xffu;
    return code > 0 ? std::exp2(0.1f * static_cast<float>(code) - 20.0f) : 0.0f;
}

/// A direction in the surface, as a part in [0, 1) of half a turn, in place of the last eight bits of two
/// channels of a colour: a visible point has no room for more.
GLINT_HD inline Vec3 withHalfTurn(Vec3 color, float part) {
    const auto code = static_cast<uint32_t>(clampf(part * 65536.0f, 0.0f, 65535.0f));
    const auto low = [](float x, uint32_t bits) {
        return std::bit_cast<float>((std::bit_cast<uint32_t>(x) & ~0xffu) | bits);
    };
    return {low(color.x, code & 0xffu), low(color.y, code >> 8), color.z};
}
GLINT_HD inline float halfTurnIn(const Vec3& color) {
    const uint32_t code =
        (std::bit_cast<uint32_t>(color.x) & 0xffu) | (std::bit_cast<uint32_t>(color.y) & 0xffu) << 8;
    return (static_cast<float>(code) + 0.5f) / 65536.0f;
}

/// Whether one point of a disc is covered by its surface (disc_coverage.h).
struct DiscProbe {
    bool isMade = false;
    bool isCovered = false;
    float t = 0.0f;  ///< squared distance from the centre, in squared radii
};

/// What one pass found around one visible point.
struct Gathered {
    Vec3 flux{0.0f};  ///< sum of BSDF times photon flux times the camera path's throughput
    uint32_t count = 0;
    float bias = 0.0f;  ///< what the disc's width adds to the flux's luminance, by a noisy estimate
    /// for a pixel whose first visible point this was; 0: it has none yet
    float initialRadiusSquared = 0.0f;
    DiscProbe probe;
};

/// One pixel's place in a pass: its visible point until the photons were gathered, then what they brought.
union PassPixel {
    VisiblePoint visiblePoint;
    Gathered gathered;

    GLINT_HD PassPixel() : visiblePoint() {}
};

/// A photon about to be scattered at a surface.
struct Photon {
    Vec3 p;
    Vec3 flux;  ///< power that arrives, before this surface's reflectance; not divided by the emitted count
    /// where it came from, away from the surface; the surface's front normal and number; how many scattering
    /// events came before this one (photon_surface.h)
    uint32_t packed[2] = {};
};

/// Everything SPPM keeps for a pixel beyond the film, and for a stored photon.
constexpr size_t kSppmBytesPerPixel = sizeof(SppmPixel) + sizeof(PassPixel);
static_assert(kSppmBytesPerPixel <= 128);
static_assert(sizeof(Photon) == 32);

}  // namespace glint
