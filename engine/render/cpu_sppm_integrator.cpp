// Stochastic progressive photon mapping as an integrator, and on the CPU.
#include <array>
#include <optional>

#include "engine/builders/power_distribution.h"
#include "engine/render/cpu_context.h"
#include "engine/render/cpu_sppm.h"
#include "engine/render/sppm_integrator.h"

namespace glint {
namespace {

class CpuSppmIntegrator final : public SppmIntegrator {
  public:
    explicit CpuSppmIntegrator(const CpuContext& cpu) : cpu_(cpu), sppm_(cpu.threads) {}

    void sceneChanged() override { power_.reset(); }

    MemoryUse memory() const override {
        MemoryUse use;
        use[MemoryPart::Emission] = power_ ? power_->bytes() : 0;
        use[MemoryPart::SppmVisiblePoints] = sppm_.visiblePointBytes();
        use[MemoryPart::Photons] = sppm_.photonBytes();
        return use;
    }

  protected:
    Result<bool> renderPhotons(const SppmParams& params, const std::atomic<bool>& stop, SppmState* state,
                               std::vector<PixelSample>* direct) override {
        if (!cpu_.scene) { return noScene(); }
        const SceneView view = cpu_.scene->view();
        if (!power_) { power_ = buildPowerDistribution(view); }
        return sppm_.renderPass(view, cpu_.features(), power_->view(), params, stop, state, direct);
    }

  private:
    const CpuContext& cpu_;
    CpuSppm sppm_;
    std::optional<PowerDistribution> power_;  ///< made by the first pass of a scene
};

constexpr auto kMaps = std::to_array<IntegratorMapInfo>({
    {kRadiusMap, "SPPM radius", MapQuantity::Length, "radius", "no visible point", "photons"},
    {kPhotonCountMap, "Photon count", MapQuantity::Count, "photons", nullptr, "photons"},
    {kRadiusMap, "Visible points", MapQuantity::Presence, "visible point", "no visible point", "photons"},
});

class Sppm final : public IntegratorType {
  public:
    std::unique_ptr<Integrator> makeOnCpu(const CpuContext& cpu) const override {
        return std::make_unique<CpuSppmIntegrator>(cpu);
    }
    std::unique_ptr<ImageStatistics> makeStatistics() const override { return std::make_unique<SppmState>(); }
    const char* purpose() const override { return "photons from the lights too, for caustics"; }
    std::span<const IntegratorMapInfo> maps() const override { return kMaps; }
    bool hasBias() const override { return true; }
    EditKind ownEdits() const override { return EditKind::SppmParameters; }
    double statisticsDecay(const SceneDescription& scene) const override {
        return static_cast<double>(scene.sppm.alpha);
    }
    void addPlannedMemory(const SceneDescription& scene, MemoryUse* use) const override {
        const SppmMemory plan = planSppmMemory(scene);
        const size_t statistics = SppmState::bytesFor(scene.resolution.width, scene.resolution.height);
        (*use)[MemoryPart::SppmStatistics] += statistics;
        (*use)[MemoryPart::SppmVisiblePoints] += plan.pixelBytes - statistics;
        (*use)[MemoryPart::Photons] += plan.photonBytes;
    }
};

}  // namespace

const IntegratorType& typeOfSppm() {
    static const Sppm kType;
    return kType;
}

}  // namespace glint
