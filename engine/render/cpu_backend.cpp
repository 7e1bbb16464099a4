// Runs a pass tile by tile in one OpenMP loop, with the smallest kernel variant that does what the
// scene needs.
//
// Every pixel is a function of (scene, settings, pixel, pass) alone, so which thread takes a tile
// changes nothing.
#include <algorithm>
#include <new>
#include <optional>

#include <fmt/core.h>

#include "engine/base/parallel.h"
#include "engine/builders/power_distribution.h"
#include "engine/render/backend.h"
#include "engine/render/cpu_sppm.h"
#include "engine/render/cpu_variants.h"

namespace glint {
namespace {

/// Small enough that even paths of 100 microseconds let a stop through within a few milliseconds.
constexpr int kTileSize = 8;

class CpuBackend final : public Backend {
  public:
    CpuBackend(int threads, KernelChoice choice)
        : threads_(threads > 0 ? threads : defaultThreadCount()), choice_(choice) {}

    std::string name() const override {
        return fmt::format("CPU, {} thread{}", threads_, threads_ == 1 ? "" : "s");
    }

    Status setScene(std::shared_ptr<const BuiltScene> scene) override {
        scene_ = std::move(scene);
        power_.reset();
        return {};
    }

    std::string kernelName(SamplerKind sampler) const override {
        return scene_ ? chooseVariant(kernelVariants(), features(), sampler).name : "";
    }

    MemoryUse memory() const override {
        MemoryUse use;
        use[MemoryPart::Emission] = power_ ? power_->bytes() : 0;
        use[MemoryPart::SppmVisiblePoints] = sppm_ ? sppm_->visiblePointBytes() : 0;
        use[MemoryPart::Photons] = sppm_ ? sppm_->photonBytes() : 0;
        return use;
    }

    Result<bool> renderPass(const PassParams& params, const std::atomic<bool>& stop,
                            std::vector<PixelSample>* out) override {
        return run(params, stop, out, &KernelVariant::renderTile);
    }

    Result<bool> renderAovPass(const PassParams& params, const std::atomic<bool>& stop,
                               std::vector<AovSample>* out) override {
        return run(params, stop, out, &KernelVariant::renderAovTile);
    }

    Result<bool> renderSppmPass(const SppmParams& params, const std::atomic<bool>& stop, SppmState* state,
                                std::vector<PixelSample>* direct) override {
        if (!scene_) { return Error{"there is no scene to render", {}}; }
        const SceneView view = scene_->view();
        if (!power_) { power_ = buildPowerDistribution(view); }
        if (!sppm_) { sppm_.emplace(threads_); }
        return sppm_->renderPass(view, features(), power_->view(), params, stop, state, direct);
    }

  private:
    /// What the scene asks of the kernels.
    FeatureMask features() const { return choice_ == KernelChoice::Full ? kAllFeatures : scene_->features; }

    template <class Sample, class Tile>
    Result<bool> run(const PassParams& params, const std::atomic<bool>& stop, std::vector<Sample>* out,
                     Tile KernelVariant::*tileOf) const {
        if (!scene_) { return Error{"there is no scene to render", {}}; }
        try {
            out->resize(static_cast<size_t>(params.width) * static_cast<size_t>(params.height));
        } catch (const std::bad_alloc&) {
            return Error{
                fmt::format("not enough memory for a picture of {}x{} pixels", params.width, params.height),
                {}};
        }
        const KernelVariant& variant = chooseVariant(kernelVariants(), features(), params.sampler);
        runTiles(scene_->view(), params, stop, out->data(), variant.*tileOf);
        return !stop.load();
    }

    template <class Sample, class Tile>
    void runTiles(const SceneView& view, const PassParams& params, const std::atomic<bool>& stop,
                  Sample* image, Tile tile) const {
        const int columns = (params.width + kTileSize - 1) / kTileSize;
        const int rows = (params.height + kTileSize - 1) / kTileSize;
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads_)
        for (int index = 0; index < columns * rows; ++index) {
            if (stop.load(std::memory_order_relaxed)) { continue; }
            const int x = index % columns * kTileSize;
            const int y = index / columns * kTileSize;
            const PixelRect rect{x, y, std::min(x + kTileSize, params.width),
                                 std::min(y + kTileSize, params.height)};
            tile(view, params, rect, image);
        }
    }

    int threads_;
    KernelChoice choice_;
    std::shared_ptr<const BuiltScene> scene_;
    std::optional<PowerDistribution> power_;  ///< made by the first SPPM pass of a scene
    std::optional<CpuSppm> sppm_;             ///< made by the first SPPM pass
};

}  // namespace

Result<bool> Backend::renderSppmPass(const SppmParams&, const std::atomic<bool>&, SppmState*,
                                     std::vector<PixelSample>*) {
    return Error{name() + " does not render photon maps; use path tracing or the CPU", {}};
}

std::unique_ptr<Backend> makeCpuBackend(int threads, KernelChoice choice) {
    return std::make_unique<CpuBackend>(threads, choice);
}

}  // namespace glint
