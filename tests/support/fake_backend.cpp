// Passes wait in short steps and look at the stop flag after each, as a backend's tiles do.
#include "tests/support/fake_backend.h"

#include <chrono>
#include <stdexcept>
#include <thread>
#include <utility>

#include "engine/render/sppm_state.h"

namespace glint::test {
namespace {

using Clock = std::chrono::steady_clock;

/// The same picture by every integrator; where it has photons, every pixel has a visible point of radius 1.
class FakeIntegrator final : public Integrator {
  public:
    explicit FakeIntegrator(std::shared_ptr<FakeControl> control) : control_(std::move(control)) {}

    Result<bool> renderPass(const PassParams& params, const std::atomic<bool>& stop,
                            ImageStatistics* statistics, std::vector<PixelSample>* out) override {
        {
            const std::lock_guard lock(control_->mutex);
            control_->begun.push_back(params);
        }
        if (control_->throwInPass) { throw std::runtime_error("thrown in a pass"); }
        if (control_->failPasses) { return Error{"the device was lost", {}}; }
        if (!spend(params, stop)) {
            ++control_->stopped;
            return false;
        }
        out->resize(static_cast<size_t>(params.width) * params.height);
        for (int y = 0; y < params.height; ++y) {
            for (int x = 0; x < params.width; ++x) {
                PixelSample& sample = (*out)[static_cast<size_t>(y) * params.width + x];
                sample = {fakeRadiance(x, y, params.pass, params.seed), SampleFault::None, 3};
            }
        }
        if (auto* photons = dynamic_cast<SppmState*>(statistics)) {
            for (SppmPixel& pixel : photons->pixels) {
                pixel.radiusSquared = 1.0;
            }
            ++photons->passes;
            photons->emittedPhotons += 1000;
        }
        ++control_->passes;
        return true;
    }

  private:
    bool spend(const PassParams& params, const std::atomic<bool>& stop) const {
        const double seconds = control_->secondsPerPass +
                               control_->secondsPerPath * static_cast<double>(params.width * params.height);
        const auto end = Clock::now() + std::chrono::duration<double>(seconds);
        while (Clock::now() < end) {
            if (stop) { return false; }
            std::this_thread::sleep_for(std::chrono::microseconds(200));
        }
        return !stop;
    }

    std::shared_ptr<FakeControl> control_;
};

class FakeBackend final : public Backend {
  public:
    explicit FakeBackend(std::shared_ptr<FakeControl> control)
        : control_(std::move(control)), integrator_(control_) {}

    std::string name() const override { return "fake"; }

    Status setScene(std::shared_ptr<const BuiltScene>) override {
        ++control_->scenes;
        return control_->failScenes ? Status(Error{"the scene does not fit", {}}) : Status();
    }

    Result<Integrator*> integrator(IntegratorKind) override { return &integrator_; }

    Result<bool> renderAovPass(const PassParams& params, const std::atomic<bool>& stop,
                               std::vector<AovSample>* out) override {
        if (stop) { return false; }
        out->assign(static_cast<size_t>(params.width) * params.height, AovSample{});
        ++control_->aovPasses;
        return true;
    }

  private:
    std::shared_ptr<FakeControl> control_;
    FakeIntegrator integrator_;
};

Result<std::shared_ptr<const BuiltScene>> fakeBuild(FakeControl& control, const SceneEdit& edit,
                                                    const std::atomic<bool>* stop, BuildReport* report) {
    const auto end = Clock::now() + std::chrono::duration<double>(control.buildSeconds.load());
    while (Clock::now() < end) {
        if (*stop) { return Error{"abandoned", {}}; }
        std::this_thread::sleep_for(std::chrono::microseconds(200));
    }
    if (control.buildsFailing > 0) {
        --control.buildsFailing;
        return Error{"object 'teapot' is flat", {}};
    }
    const bool all = has(edit.kinds, EditKind::Everything);
    report->materialsBuilt = all || has(edit.kinds, EditKind::MaterialParameters | EditKind::MaterialKind);
    report->lightsBuilt = all || has(edit.kinds, EditKind::Lights);
    report->topLevelBuilt = all || has(edit.kinds, EditKind::ObjectTransform);
    return std::make_shared<const BuiltScene>();
}

}  // namespace

Vec3 fakeRadiance(int x, int y, uint32_t pass, uint32_t seed) {
    const uint32_t mixed = (static_cast<uint32_t>(x) * 73856093u) ^ (static_cast<uint32_t>(y) * 19349663u) ^
                           (pass * 83492791u) ^ (seed * 2654435761u);
    const float value = static_cast<float>(mixed % 1009u) / 1009.0f;
    return {value, 0.5f * value, 1.0f - value};
}

std::unique_ptr<Backend> makeFakeBackend(std::shared_ptr<FakeControl> control) {
    return std::make_unique<FakeBackend>(std::move(control));
}

SessionOptions fakeOptions(std::shared_ptr<FakeControl> control) {
    SessionOptions options;
    options.threads = 1;
    options.build = [control](const SceneEdit& edit, const BuiltScene*, int, const std::atomic<bool>* stop,
                              BuildReport* report) { return fakeBuild(*control, edit, stop, report); };
    return options;
}

std::shared_ptr<SceneDescription> fakeScene(int width, int height) {
    auto scene = std::make_shared<SceneDescription>();
    scene->resolution = {width, height};
    return scene;
}

}  // namespace glint::test
