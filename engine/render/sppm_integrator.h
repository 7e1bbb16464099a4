// What SPPM's integrators of all back ends have in common: its settings, and how a pass of any size is told
// of them.
#pragma once

#include "engine/render/backend.h"
#include "engine/render/sppm_state.h"

namespace glint {

class SppmIntegrator : public Integrator {
  public:
    void prepare(const SceneDescription& scene) final;
    /// The settings as they are; of a picture of settings.pass.width x settings.pass.height pixels.
    void use(const SppmParams& settings) { settings_ = settings; }

    Result<bool> renderPass(const PassParams& params, const std::atomic<bool>& stop,
                            ImageStatistics* statistics, std::vector<PixelSample>* samples) final;

  protected:
    /// Direct light and emission go into `direct`, photons into `state`. As renderPass() otherwise.
    virtual Result<bool> renderPhotons(const SppmParams& params, const std::atomic<bool>& stop,
                                       SppmState* state, std::vector<PixelSample>* direct) = 0;

  private:
    SppmParams settings_;
};

/// One pass with these settings, without a session: for measurements. As Integrator::renderPass().
Result<bool> renderSppmPass(Backend& backend, const SppmParams& params, const std::atomic<bool>& stop,
                            SppmState* state, std::vector<PixelSample>* direct);

}  // namespace glint
