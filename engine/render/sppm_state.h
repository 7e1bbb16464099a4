// What SPPM carries from pass to pass: the statistics of every pixel and how many photons were emitted
// for them.
//
// Checkpoint payload: u32 width, u32 height, u32 passes, u64 emitted photons, then per pixel f64 squared
// radius, f64 N, 3 f64 tau, f32 bias and f32 M2 of the passes' own estimates, f32 points of the discs that
// were looked at and f32 covered ones. The last two are missing in older ones, which go on without.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "engine/kernels/sppm_view.h"
#include "engine/render/image_statistics.h"
#include "engine/scene/scene.h"

namespace glint {

/// Its maps in snapshots: the present radius, 0 for no visible point yet, and the photons kept so far (N).
inline constexpr std::string_view kRadiusMap = "radius";
inline constexpr std::string_view kPhotonCountMap = "photon count";

struct SppmState final : ImageStatistics {
    int width = 0;
    int height = 0;
    uint32_t passes = 0;
    uint64_t emittedPhotons = 0;
    std::vector<SppmPixel> pixels;

    SppmState() = default;
    SppmState(int width, int height);

    std::unique_ptr<ImageStatistics> clone() const override { return std::make_unique<SppmState>(*this); }
    void reset(int columns, int rows) override;
    uint32_t passCount() const override { return passes; }
    Vec3 radianceOf(size_t pixel) const override;
    double standardErrorOf(size_t pixel) const override;
    double biasOf(size_t pixel) const override;
    std::vector<IntegratorMap> maps() const override;
    size_t bytes() const override { return pixels.capacity() * sizeof(SppmPixel); }
    MemoryPart memoryPart() const override { return MemoryPart::SppmStatistics; }
    Section section() const override { return {"SPPM", "photon statistics"}; }
    size_t sectionBytes(size_t pixelCount) const override;
    void write(ByteWriter* out) const override;
    bool read(ByteReader in, const Film& film) override;

    /// What the statistics of a picture of this size allocate.
    static size_t bytesFor(int width, int height) {
        return static_cast<size_t>(width) * static_cast<size_t>(height) * sizeof(SppmPixel);
    }
};

/// Null when they are another integrator's, or null.
inline const SppmState* asSppm(const ImageStatistics* statistics) {
    return dynamic_cast<const SppmState*>(statistics);
}

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
