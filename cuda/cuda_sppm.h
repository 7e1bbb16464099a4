// One SPPM pass on a device: camera paths, photons, sorting, gathering, update. Owned by the CUDA back end.
//
// The stages and their arithmetic are the CPU's (render/cpu_sppm.h). The statistics belong to the host, which
// may clear, load or exchange them between passes: they are uploaded at a pass's begin and fetched at its
// end, 56 bytes a pixel each way. A pass that is stopped or fails leaves them as they were.
#pragma once

#include <atomic>
#include <optional>
#include <vector>

#include "cuda/chunk_pacer.h"
#include "cuda/device_photons.h"
#include "engine/builders/power_distribution.h"
#include "engine/render/sppm_state.h"

namespace glint {

struct CudaSppmVariant;

class CudaSppm {
  public:
    /// The device must outlive it.
    explicit CudaSppm(Device& device) : device_(device), photons_(device) {}

    /// The scene to render, on the device and on the host.
    struct Scene {
        const SceneView& device;
        const SceneView& host;
        FeatureMask features;
    };
    /// Forgets what was made for the scene before.
    void sceneChanged() { power_.reset(); }

    /// As SppmIntegrator::renderPhotons(); `image` is device memory for one sample a pixel.
    Result<bool> renderPass(const Scene& scene, const SppmParams& params, const std::atomic<bool>& stop,
                            PixelSample* image, SppmState* state, std::vector<PixelSample>* direct);

    /// Device memory held.
    size_t bytes() const;

  private:
    struct Job;

    Status reserve(const SppmParams& params, uint32_t room);
    Status takeMemory(const SppmParams& params, uint32_t room);
    Status uploadEmission(const SceneView& host);
    Result<bool> runStages(const Job& job);
    Result<bool> traceCamera(const Job& job);
    Status findSpace(const Job& job, GridSpace* space, uint32_t* levelsInUse);
    Result<Bounds> findBounds(const SpaceLaunch& launch);
    Result<bool> tracePhotons(const Job& job, const GridSpace& space, uint32_t* stored);
    Result<bool> gather(const Job& job);
    Status commit(const Job& job, SppmState* state, std::vector<PixelSample>* direct);

    Device& device_;
    DeviceBuffer statistics_;
    DeviceBuffer pixels_;
    DeviceBuffer slices_;
    DeviceBuffer powerCdf_;
    DevicePhotons photons_;
    std::optional<PowerDistribution> power_;
    std::vector<SppmPixel> fetched_;  ///< becomes the state when all of it has arrived
    ChunkPacer cameraPacer_;
    ChunkPacer photonPacer_;
    ChunkPacer gatherPacer_;
};

}  // namespace glint
