// The CPU: integrators by their types, and the first-hit pictures.
#include <map>

#include <fmt/core.h>

#include "engine/base/parallel.h"
#include "engine/render/backend.h"
#include "engine/render/cpu_context.h"

namespace glint {
namespace {

class CpuBackend final : public Backend {
  public:
    CpuBackend(int threads, KernelChoice choice)
        : cpu_{threads > 0 ? threads : defaultThreadCount(), choice} {}

    std::string name() const override {
        return fmt::format("CPU, {} thread{}", cpu_.threads, cpu_.threads == 1 ? "" : "s");
    }

    Status setScene(std::shared_ptr<const BuiltScene> scene) override {
        cpu_.scene = std::move(scene);
        for (const auto& [kind, integrator] : integrators_) {
            integrator->sceneChanged();
        }
        return {};
    }

    std::string kernelName(SamplerKind sampler) const override {
        return cpu_.scene ? cpu_.variant(sampler).name : "";
    }

    MemoryUse memory() const override {
        MemoryUse use;
        for (const auto& [kind, integrator] : integrators_) {
            use.add(integrator->memory());
        }
        return use;
    }

    Result<Integrator*> integrator(IntegratorKind kind) override {
        auto found = integrators_.find(kind);
        if (found == integrators_.end()) {
            // Made first: without memory for it, there must be no entry either.
            auto made = integratorType(kind).makeOnCpu(cpu_);
            found = integrators_.emplace(kind, std::move(made)).first;
        }
        return found->second.get();
    }

    void setRegion(const std::optional<FilmRegion>& region) override { cpu_.region = region; }

    Result<bool> renderAovPass(const PassParams& params, const std::atomic<bool>& stop,
                               std::vector<AovSample>* out) override {
        if (!cpu_.scene) { return noScene(); }
        const SceneView view = cpu_.scene->view();
        const RenderAovTile render = cpu_.variant(params.sampler).renderAovTile;
        return renderTiles(cpu_, params, stop, out,
                           [&](const PixelRect& tile) { render(view, params, tile, out->data()); });
    }

  private:
    CpuContext cpu_;
    std::map<IntegratorKind, std::unique_ptr<Integrator>> integrators_;
};

}  // namespace

std::unique_ptr<Backend> makeCpuBackend(int threads, KernelChoice choice) {
    return std::make_unique<CpuBackend>(threads, choice);
}

}  // namespace glint
