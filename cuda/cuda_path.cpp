// Path tracing on a device.
#include "cuda/cuda_context.h"
#include "cuda/cuda_integrators.h"
#include "cuda/cuda_variant.h"
#include "engine/render/variant_choice.h"

namespace glint {
namespace {

class CudaPaths final : public Integrator {
  public:
    explicit CudaPaths(CudaContext& cuda) : cuda_(cuda) {}

    Result<bool> renderPass(const PassParams& params, const std::atomic<bool>& stop, ImageStatistics*,
                            std::vector<PixelSample>* samples) override {
        const CudaVariant& variant = chooseVariant(cudaVariants(), cuda_.features(), params.sampler);
        return cuda_.renderImage(variant.path, PathLaunch{}, params, stop, &pacer_, samples);
    }

  private:
    CudaContext& cuda_;
    ChunkPacer pacer_;
};

}  // namespace

std::unique_ptr<Integrator> makeCudaPathTracing(CudaContext& cuda) {
    return std::make_unique<CudaPaths>(cuda);
}

}  // namespace glint
