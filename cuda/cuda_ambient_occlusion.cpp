// Ambient occlusion on a device.
#include "cuda/cuda_context.h"
#include "cuda/cuda_integrators.h"
#include "cuda/preview_launch.h"
#include "engine/render/occlusion_radius.h"

namespace glint {
namespace {

class CudaAmbientOcclusion final : public Integrator {
  public:
    explicit CudaAmbientOcclusion(CudaContext& cuda) : cuda_(cuda) {}

    Result<bool> renderPass(const PassParams& params, const std::atomic<bool>& stop, ImageStatistics*,
                            std::vector<PixelSample>* samples) override {
        OcclusionLaunch launch;
        if (cuda_.host) { launch.radiusWorld = occlusionRadiusOf(*cuda_.host); }
        return cuda_.renderImage(kCudaAmbientOcclusion, launch, params, stop, &pacer_, samples);
    }

  private:
    CudaContext& cuda_;
    ChunkPacer pacer_;
};

}  // namespace

std::unique_ptr<Integrator> makeCudaAmbientOcclusion(CudaContext& cuda) {
    return std::make_unique<CudaAmbientOcclusion>(cuda);
}

}  // namespace glint
