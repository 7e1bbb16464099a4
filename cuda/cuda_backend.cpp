// A device as a back end: its scene, and the integrators that render it.

#include "cuda/cuda_backend.h"

#include <array>
#include <string>
#include <utility>

#include "cuda/cuda_context.h"
#include "cuda/cuda_integrators.h"
#include "cuda/cuda_variant.h"
#include "engine/render/variant_choice.h"

namespace glint {
namespace {

/// Null where CUDA has no kernels for it.
std::unique_ptr<Integrator> makeCudaIntegrator(IntegratorKind wanted, CudaContext& cuda) {
#define GLINT_MAKE_INTEGRATOR(kind) \
    if (wanted == IntegratorKind::kind) { return makeCuda##kind(cuda); }
    GLINT_CUDA_INTEGRATORS(GLINT_MAKE_INTEGRATOR)
#undef GLINT_MAKE_INTEGRATOR
    return nullptr;
}

class CudaBackend final : public Backend {
  public:
    explicit CudaBackend(std::unique_ptr<Device> device) : cuda_(std::move(device)) {}

    std::string name() const override { return "CUDA, " + cuda_.device->name(); }

    std::string kernelName(SamplerKind sampler) const override {
        return cuda_.scene.empty() ? "" : chooseVariant(cudaVariants(), cuda_.features(), sampler).name;
    }

    Status setScene(std::shared_ptr<const BuiltScene> scene) override {
        cuda_.host = scene;
        for (const std::unique_ptr<Integrator>& integrator : integrators_) {
            if (integrator) { integrator->sceneChanged(); }
        }
        Status taken = cuda_.scene.update(scene);
        if (taken || !cuda_.sppm) { return taken; }
        // Photons are kept from pass to pass only to be faster.
        cuda_.sppm.reset();
        return cuda_.scene.update(std::move(scene));
    }

    Result<Integrator*> integrator(IntegratorKind kind) override {
        std::unique_ptr<Integrator>& made = integrators_[static_cast<size_t>(kind)];
        if (!made) { made = makeCudaIntegrator(kind, cuda_); }
        if (!made) {
            return Error{std::string("CUDA has no kernels for ") + integratorInfo(kind).displayName, {}};
        }
        return made.get();
    }

    Result<bool> renderAovPass(const PassParams& params, const std::atomic<bool>& stop,
                               std::vector<AovSample>* out) override {
        const CudaVariant& variant = chooseVariant(cudaVariants(), cuda_.features(), params.sampler);
        return cuda_.renderImage(variant.aov, AovLaunch{}, params, stop, &aovPacer_, out);
    }

  private:
    CudaContext cuda_;
    std::array<std::unique_ptr<Integrator>, kIntegratorTable.size()> integrators_;
    ChunkPacer aovPacer_;
};

}  // namespace

Result<std::unique_ptr<Backend>> makeCudaBackend() {
    Result<std::unique_ptr<Device>> device = openGpu();
    if (!device) { return device.error(); }
    return makeCudaBackend(std::move(*device));
}

std::unique_ptr<Backend> makeCudaBackend(std::unique_ptr<Device> device) {
    return std::make_unique<CudaBackend>(std::move(device));
}

}  // namespace glint
