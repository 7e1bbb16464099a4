// Ray casting: Phong's model under the scene's lights, without bounces.
#include "engine/render/cpu_context.h"
#include "engine/render/integrator.h"
#include "engine/render/raycast_settings.h"

namespace glint {
namespace {

class CpuRayCast final : public Integrator {
  public:
    explicit CpuRayCast(const CpuContext& cpu) : cpu_(cpu) {}

    void prepare(const SceneDescription& scene) override { settings_ = rayCastSettingsOf(scene); }

    Result<bool> renderPass(const PassParams& params, const std::atomic<bool>& stop, ImageStatistics*,
                            std::vector<PixelSample>* samples) override {
        if (!cpu_.scene) { return noScene(); }
        const SceneView view = cpu_.scene->view();
        const RayCastView settings = settings_.view();
        return renderPixels(cpu_, params, stop, samples, [&](int x, int y) {
            return traceRayCast<kAllFeatures>(view, settings, params, x, y);
        });
    }

  private:
    const CpuContext& cpu_;
    RayCastSettings settings_;
};

class RayCast final : public IntegratorType {
  public:
    std::unique_ptr<Integrator> makeOnCpu(const CpuContext& cpu) const override {
        return std::make_unique<CpuRayCast>(cpu);
    }
    const char* purpose() const override { return "lights and colours without noise, for a quick look"; }
    EditKind ownEdits() const override { return EditKind::RayCastParameters; }
};

}  // namespace

const IntegratorType& typeOfRayCast() {
    static const RayCast kType;
    return kType;
}

}  // namespace glint
