// What the CUDA back end's integrators share: the device, the scene on it, and how a picture is
// rendered there.
//
// Belongs to the CUDA back end. No CUDA header is named here.
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "cuda/cuda_sppm.h"
#include "cuda/device_buffer.h"
#include "cuda/device_scene.h"
#include "cuda/launch.h"
#include "cuda/paced_launches.h"
#include "engine/render/backend.h"

namespace glint {

struct CudaContext {
    explicit CudaContext(std::unique_ptr<Device> owned) : device(std::move(owned)), scene(*device) {}

    std::unique_ptr<Device> device;
    DeviceScene scene;
    std::shared_ptr<const BuiltScene> host{};  ///< the scene before it was uploaded; null before the first
    DeviceBuffer image{};                      ///< the samples of a pass, of any kind; grows as needed
    std::optional<CudaSppm> sppm{};            ///< gives its memory to a scene that does not fit beside it

    FeatureMask features() const { return host ? host->features : FeatureMask{0}; }

    /// Makes room for the samples of a pass. Error: no scene, no pixels, or not enough memory.
    Status prepareImage(const PassParams& params, size_t sampleBytes);

    /// Runs `kernel` for each pixel of the pass, and brings its samples back; `launch` has what the kernel is
    /// given beside the scene, the pass and the image. As Integrator::renderPass().
    template <class Launch, class Sample>
    Result<bool> renderImage(const Kernel<Launch>& kernel, Launch launch, const PassParams& params,
                             const std::atomic<bool>& stop, ChunkPacer* pacer, std::vector<Sample>* out) {
        if (Status s = prepareImage(params, sizeof(Sample)); !s) { return s.error(); }
        launch.view = scene.view();
        launch.params = params;
        launch.image = image.as<Sample>();
        const uint32_t threads = threadsOfPass(params.width, params.height);
        const Result<bool> done = runPaced(*device, kernel, launch, threads, stop, pacer);
        if (!done || !*done) { return done; }
        out->resize(static_cast<size_t>(params.width) * static_cast<size_t>(params.height));
        if (Status s = device->download(out->data(), image.data(), out->size() * sizeof(Sample)); !s) {
            return s.error();
        }
        return true;
    }
};

}  // namespace glint
