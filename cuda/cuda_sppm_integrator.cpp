// Photon mapping on a device: CudaSppm as an integrator.
#include "cuda/cuda_context.h"
#include "cuda/cuda_integrators.h"
#include "engine/render/sppm_integrator.h"

namespace glint {
namespace {

class CudaPhotons final : public SppmIntegrator {
  public:
    explicit CudaPhotons(CudaContext& cuda) : cuda_(cuda) {}

    void sceneChanged() override {
        if (cuda_.sppm) { cuda_.sppm->sceneChanged(); }
    }

  protected:
    Result<bool> renderPhotons(const SppmParams& params, const std::atomic<bool>& stop, SppmState* state,
                               std::vector<PixelSample>* direct) override {
        if (Status s = cuda_.prepareImage(params.pass, sizeof(PixelSample)); !s) { return s.error(); }
        if (!cuda_.sppm) { cuda_.sppm.emplace(*cuda_.device); }
        const SceneView host = cuda_.host->view();
        return cuda_.sppm->renderPass({cuda_.scene.view(), host, cuda_.features()}, params, stop,
                                      cuda_.image.as<PixelSample>(), state, direct);
    }

  private:
    CudaContext& cuda_;
};

}  // namespace

std::unique_ptr<Integrator> makeCudaSppm(CudaContext& cuda) { return std::make_unique<CudaPhotons>(cuda); }

}  // namespace glint
