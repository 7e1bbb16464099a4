// The one virtual seam of the renderer: who runs the kernels.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/builders/built_scene.h"
#include "engine/kernels/pass.h"
#include "engine/render/film.h"
#include "engine/render/film_region.h"
#include "engine/render/integrator.h"
#include "engine/render/memory_use.h"

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

    /// Made at the first call, and the back end's own from then on. Error: it has no kernels for it.
    virtual Result<Integrator*> integrator(IntegratorKind kind) = 0;

    /// Passes that follow need no samples outside. Those that render the whole picture nevertheless are
    /// right, too, but slow.
    virtual void setRegion(const std::optional<FilmRegion>& /*region*/) {}

    /// Renders the first-hit pictures into `out`, an entry a pixel, which is resized as needed; with the
    /// camera rays of params.pass. Checks `stop` at least once a tile; returns false when it stopped early,
    /// and `out` is then to be thrown away.
    virtual Result<bool> renderAovPass(const PassParams& params, const std::atomic<bool>& stop,
                                       std::vector<AovSample>* out) = 0;
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
