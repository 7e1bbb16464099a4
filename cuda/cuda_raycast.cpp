// Ray casting on a device.
#include "cuda/cuda_context.h"
#include "cuda/cuda_integrators.h"
#include "cuda/preview_launch.h"
#include "engine/render/raycast_settings.h"

namespace glint {
namespace {

class CudaRayCast final : public Integrator {
  public:
    explicit CudaRayCast(CudaContext& cuda) : cuda_(cuda) {}

    void prepare(const SceneDescription& scene) override {
        settings_ = rayCastSettingsOf(scene);
        isUploaded_ = false;
    }

    Result<bool> renderPass(const PassParams& params, const std::atomic<bool>& stop, ImageStatistics*,
                            std::vector<PixelSample>* samples) override {
        if (Status s = uploadMaterials(); !s) { return s.error(); }
        RayCastLaunch launch;
        launch.settings = settings_.view();
        launch.settings.materials.data = materials_.as<PhongMaterial>();
        return cuda_.renderImage(kCudaRayCast, launch, params, stop, &pacer_, samples);
    }

  private:
    Status uploadMaterials() {
        const size_t bytes = settings_.materials.size() * sizeof(PhongMaterial);
        if (isUploaded_ || bytes == 0) { return {}; }
        if (Status s = materials_.reserve(*cuda_.device, bytes); !s) { return s; }
        if (Status s = cuda_.device->upload(materials_.data(), settings_.materials.data(), bytes); !s) {
            return s;
        }
        isUploaded_ = true;
        return {};
    }

    CudaContext& cuda_;
    RayCastSettings settings_;
    DeviceBuffer materials_;
    bool isUploaded_ = false;
    ChunkPacer pacer_;
};

}  // namespace

std::unique_ptr<Integrator> makeCudaRayCast(CudaContext& cuda) { return std::make_unique<CudaRayCast>(cuda); }

}  // namespace glint
