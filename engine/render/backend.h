// The one virtual seam of the renderer: who runs the kernels. A call per pass, never per ray.
#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/builders/built_scene.h"
#include "engine/kernels/pass.h"
#include "engine/render/film.h"
#include "engine/render/memory_use.h"
#include "engine/render/sppm_state.h"

namespace glint {

class Backend {
  public:
    virtual ~Backend() = default;

    /// "CPU, 2 threads" or "CUDA, <device name>".
    virtual std::string name() const = 0;

    /// Takes the scene for the following passes (uploads what changed). Error: does not fit the
    /// device's memory.
    virtual Status setScene(std::shared_ptr<const BuiltScene> scene) = 0;

    /// The kernel variant that the present scene runs, for status lines; empty before setScene().
    virtual std::string kernelName(SamplerKind) const { return {}; }

    /// What passes have made the back end allocate and it still holds, on the host; the scene not included.
    virtual MemoryUse memory() const { return {}; }

    /// Renders one path for each pixel into `out`, which is resized as needed. Checks `stop` at least once a
    /// tile; returns false when it stopped early, and `out` is then to be thrown away.
    virtual Result<bool> renderPass(const PassParams& params, const std::atomic<bool>& stop,
                                    std::vector<PixelSample>* out) = 0;

    /// The same for the first-hit pictures, with the same camera rays.
    virtual Result<bool> renderAovPass(const PassParams& params, const std::atomic<bool>& stop,
                                       std::vector<AovSample>* out) = 0;

    /// One SPPM pass: direct light and emission into `direct`, one sample a pixel, photons into `state`,
    /// which must have the pass's resolution and params.pass.pass passes. False: stopped early, and `state`
    /// has not changed. Error: not enough memory, or this back end does not do SPPM.
    virtual Result<bool> renderSppmPass(const SppmParams& params, const std::atomic<bool>& stop,
                                        SppmState* state, std::vector<PixelSample>* direct);
};

/// Which of the kernels compiled ahead of time run. Both give the same bits; the full one is for measuring
/// what the others gain.
enum class KernelChoice : uint8_t {
    Specialised,  ///< the smallest that does what the scene needs
    Full,         ///< the one that does everything
};

/// The OpenMP loop over tiles. threads 0: all.
std::unique_ptr<Backend> makeCpuBackend(int threads, KernelChoice choice = KernelChoice::Specialised);

}  // namespace glint
