// Ray casting: Phong's model under the scene's lights, without bounces.
#include "engine/kernels/raycast_kernel.h"
#include "engine/render/cpu_context.h"
#include "engine/render/integrator.h"

namespace glint {
namespace {

class CpuRayCast final : public Integrator {
  public:
    explicit CpuRayCast(const CpuContext& cpu) : cpu_(cpu) {}

    void prepare(const SceneDescription& scene) override {
        materials_.clear();
        for (const Material& material : scene.materials) {
            materials_.push_back({material.phongSpecular, material.phongExponent});
        }
        options_ = scene.rayCast;
    }

    Result<bool> renderPass(const PassParams& params, const std::atomic<bool>& stop, ImageStatistics*,
                            std::vector<PixelSample>* samples) override {
        if (!cpu_.scene) { return noScene(); }
        const SceneView view = cpu_.scene->view();
        const RayCastView settings{viewOf(materials_), options_.ambient, options_.shadows, options_.falloff};
        return renderTiles(cpu_, params, stop, samples, [&](const PixelRect& tile) {
            for (int y = tile.y0; y < tile.y1; ++y) {
                PixelSample* row =
                    samples->data() + static_cast<size_t>(y) * static_cast<size_t>(params.width);
                for (int x = tile.x0; x < tile.x1; ++x) {
                    row[x] = traceRayCast<kAllFeatures>(view, settings, params, x, y);
                }
            }
        });
    }

  private:
    const CpuContext& cpu_;
    std::vector<PhongMaterial> materials_;
    RayCastOptions options_;
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
