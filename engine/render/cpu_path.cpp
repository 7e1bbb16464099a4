// Path tracing, tile by tile, with the smallest kernel variant that does what the scene needs.
//
// Every pixel is a function of (scene, settings, pixel, pass) alone, so which thread takes a tile
// changes nothing.
#include "engine/render/cpu_context.h"
#include "engine/render/integrator.h"
#include "engine/render/path_pass.h"

namespace glint {
namespace {

class CpuPathTracing final : public Integrator {
  public:
    explicit CpuPathTracing(const CpuContext& cpu) : cpu_(cpu) {}

    Result<bool> renderPass(const PassParams& params, const std::atomic<bool>& stop, ImageStatistics*,
                            std::vector<PixelSample>* samples) override {
        if (!cpu_.scene) { return noScene(); }
        const SceneView view = cpu_.scene->view();
        const RenderTile render = cpu_.variant(params.sampler).renderTile;
        return renderTiles(cpu_, params, stop, samples,
                           [&](const PixelRect& tile) { render(view, params, tile, samples->data()); });
    }

  private:
    const CpuContext& cpu_;
};

class PathTracing final : public IntegratorType {
  public:
    std::unique_ptr<Integrator> makeOnCpu(const CpuContext& cpu) const override {
        return std::make_unique<CpuPathTracing>(cpu);
    }
    const char* purpose() const override { return "light followed from the camera"; }
};

}  // namespace

const IntegratorType& typeOfPathTracing() {
    static const PathTracing kType;
    return kType;
}

Result<bool> renderPathPass(Backend& backend, const PassParams& params, const std::atomic<bool>& stop,
                            std::vector<PixelSample>* samples) {
    const Result<Integrator*> paths = backend.integrator(IntegratorKind::PathTracing);
    return paths ? (*paths)->renderPass(params, stop, nullptr, samples) : Result<bool>(paths.error());
}

}  // namespace glint
