#include "engine/render/sppm_integrator.h"

#include <algorithm>

#include "engine/render/pass_params.h"

namespace glint {

void SppmIntegrator::prepare(const SceneDescription& scene) { settings_ = sppmParamsOf(scene); }

/// Previews spread the photons as thinly over their pixels as the film does.
Result<bool> SppmIntegrator::renderPass(const PassParams& params, const std::atomic<bool>& stop,
                                        ImageStatistics* statistics, std::vector<PixelSample>* samples) {
    const auto pixels = [](const PassParams& of) {
        return static_cast<double>(int64_t{of.width} * int64_t{of.height});
    };
    SppmParams own = settings_;
    own.pass = params;
    const double share = pixels(params) / pixels(settings_.pass);
    own.photonsPerPass = std::max(1u, static_cast<uint32_t>(share * own.photonsPerPass));
    return renderPhotons(own, stop, static_cast<SppmState*>(statistics), samples);
}

Result<bool> renderSppmPass(Backend& backend, const SppmParams& params, const std::atomic<bool>& stop,
                            SppmState* state, std::vector<PixelSample>* direct) {
    const Result<Integrator*> photons = backend.integrator(IntegratorKind::Sppm);
    if (!photons) { return photons.error(); }
    static_cast<SppmIntegrator*>(*photons)->use(params);
    return (*photons)->renderPass(params.pass, stop, state, direct);
}

}  // namespace glint
