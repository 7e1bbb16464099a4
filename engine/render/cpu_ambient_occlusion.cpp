// Ambient occlusion: a preview of shapes that needs neither light nor materials.
#include "engine/kernels/ambient_occlusion_kernel.h"
#include "engine/render/cpu_context.h"
#include "engine/render/integrator.h"
#include "engine/render/occlusion_radius.h"

namespace glint {
namespace {

class CpuAmbientOcclusion final : public Integrator {
  public:
    explicit CpuAmbientOcclusion(const CpuContext& cpu) : cpu_(cpu) {}

    Result<bool> renderPass(const PassParams& params, const std::atomic<bool>& stop, ImageStatistics*,
                            std::vector<PixelSample>* samples) override {
        if (!cpu_.scene) { return noScene(); }
        const SceneView view = cpu_.scene->view();
        const float radius = occlusionRadiusOf(*cpu_.scene);
        return renderPixels(cpu_, params, stop, samples, [&](int x, int y) {
            return traceAmbientOcclusion<kAllFeatures>(view, params, radius, x, y);
        });
    }

  private:
    const CpuContext& cpu_;
};

class AmbientOcclusion final : public IntegratorType {
  public:
    std::unique_ptr<Integrator> makeOnCpu(const CpuContext& cpu) const override {
        return std::make_unique<CpuAmbientOcclusion>(cpu);
    }
    const char* purpose() const override { return "how open each point is, for a quick look at the form"; }
};

}  // namespace

const IntegratorType& typeOfAmbientOcclusion() {
    static const AmbientOcclusion kType;
    return kType;
}

}  // namespace glint
