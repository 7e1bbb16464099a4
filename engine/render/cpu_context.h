// What the CPU's integrators share: the scene, and the loop over the tiles of a picture. Belongs to the CPU
// back end.
#pragma once

#include <algorithm>
#include <atomic>
#include <memory>
#include <new>
#include <optional>
#include <vector>

#include <fmt/core.h>

#include "engine/base/result.h"
#include "engine/base/thread_limit.h"
#include "engine/builders/built_scene.h"
#include "engine/render/backend.h"
#include "engine/render/cpu_variants.h"

namespace glint {

struct CpuContext {
    int threads = 1;
    KernelChoice choice = KernelChoice::Specialised;
    std::shared_ptr<const BuiltScene> scene{};  ///< null before the first
    std::optional<FilmRegion> region{};         ///< outside, no samples are needed

    /// What the scene asks of the kernels.
    FeatureMask features() const { return choice == KernelChoice::Full ? kAllFeatures : scene->features; }
    /// The path tracer and the first-hit pictures that run.
    const KernelVariant& variant(SamplerKind sampler) const {
        return chooseVariant(kernelVariants(), features(), sampler);
    }
};

/// Calls tile(PixelRect) for every tile of the pass and of cpu.region, on all threads, until `stop` is
/// raised. Returns false when it was. `image` gets an entry a pixel. Error: there is no memory for it.
template <class Sample, class Tile>
Result<bool> renderTiles(const CpuContext& cpu, const PassParams& params, const std::atomic<bool>& stop,
                         std::vector<Sample>* image, const Tile& tile) {
    try {
        image->resize(static_cast<size_t>(params.width) * static_cast<size_t>(params.height));
    } catch (const std::bad_alloc&) {
        return Error{
            fmt::format("not enough memory for a picture of {}x{} pixels", params.width, params.height), {}};
    }
    // Small enough that even paths of 100 microseconds let a stop through within a few milliseconds.
    constexpr int kTileSize = 8;
    const FilmRegion part = cpu.region.value_or(FilmRegion{0, 0, params.width, params.height});
    const int firstColumn = part.x0 / kTileSize;
    const int firstRow = part.y0 / kTileSize;
    const int columns = (part.x1 + kTileSize - 1) / kTileSize - firstColumn;
    const int rows = (part.y1 + kTileSize - 1) / kTileSize - firstRow;
    const int threads = startableThreads(cpu.threads);
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads)
    for (int index = 0; index < columns * rows; ++index) {
        if (stop.load(std::memory_order_relaxed)) { continue; }
        const int x = (firstColumn + index % columns) * kTileSize;
        const int y = (firstRow + index / columns) * kTileSize;
        tile(PixelRect{x, y, std::min(x + kTileSize, params.width), std::min(y + kTileSize, params.height)});
    }
    return !stop.load();
}

/// The same with pixel(x, y), a Sample, for each pixel.
template <class Sample, class Pixel>
Result<bool> renderPixels(const CpuContext& cpu, const PassParams& params, const std::atomic<bool>& stop,
                          std::vector<Sample>* image, const Pixel& pixel) {
    return renderTiles(cpu, params, stop, image, [&](const PixelRect& tile) {
        for (int y = tile.y0; y < tile.y1; ++y) {
            Sample* row = image->data() + static_cast<size_t>(y) * static_cast<size_t>(params.width);
            for (int x = tile.x0; x < tile.x1; ++x) {
                row[x] = pixel(x, y);
            }
        }
    });
}

inline Error noScene() { return {"there is no scene to render", {}}; }

}  // namespace glint
