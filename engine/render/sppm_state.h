// What SPPM carries from pass to pass: the statistics of every pixel and how many photons were emitted
// for them.
//
// Belongs to the render session, changes only when a whole pass is committed, and goes into checkpoints as
// it is.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "engine/kernels/sppm_view.h"
#include "engine/render/film.h"
#include "engine/scene/scene.h"

namespace glint {

/// Its maps in snapshots: the present radius, 0 for no visible point yet, and the photons kept so far (N).
inline constexpr std::string_view kRadiusMap = "radius";
inline constexpr std::string_view kPhotonCountMap = "photon count";

struct SppmState {
    int width = 0;
    int height = 0;
    uint32_t passes = 0;
    uint64_t emittedPhotons = 0;
    std::vector<SppmPixel> pixels;

    SppmState() = default;
    SppmState(int width, int height);

    void clear();

    /// Radiance that the photons brought to pixel `index`; added to the film's mean it makes the picture.
    Vec3 photonRadiance(size_t index) const;
    /// Standard error of the photons' part of the pixel's luminance, from the spread of the passes' own
    /// estimates. Infinite with fewer than two passes.
    double photonStandardError(size_t index) const;

    size_t bytes() const { return pixels.capacity() * sizeof(SppmPixel); }
    /// What the statistics of a picture of this size allocate.
    static size_t bytesFor(int width, int height) {
        return static_cast<size_t>(width) * static_cast<size_t>(height) * sizeof(SppmPixel);
    }
};

/// What a render with these settings needs beyond the film, computed before anything is allocated.
struct SppmMemory {
    size_t pixelBytes = 0;
    size_t photonBytes = 0;
    uint32_t photonsPerPass = 0;  ///< as asked for, or the most that fits the budget
    size_t total() const { return pixelBytes + photonBytes; }
};

/// With the scene's resolution, photons and budget, and kExpectedStores places a photon.
SppmMemory planSppmMemory(const SceneDescription& scene);

/// A generous guess before anything is traced: closed rooms of albedo 0.75 store three to four times.
constexpr double kExpectedStores = 4.0;

/// storedPerPhoton: how many places a photon is stored at on average, measured or expected. budgetBytes 0:
/// no limit.
SppmMemory planSppmMemory(int width, int height, uint32_t photonsPerPass, double storedPerPhoton,
                          size_t budgetBytes);

}  // namespace glint
