#include "engine/render/pass_runner.h"

#include <utility>

namespace glint {

Result<bool> PassRunner::run(const NextPass& pass, bool mustBeShown, SessionImages* images,
                             SessionCounters* counters) {
    const auto began = SessionClock::now();
    queue_->beginPass(inFlight(pass, mustBeShown, *images));
    Result<bool> done = render(pass, images);
    queue_->endPass();
    if (done && *done) { commit(pass, secondsSince(began), images, counters); }
    return done;
}

PassInFlight PassRunner::inFlight(const NextPass& pass, bool mustBeShown, const SessionImages& images) const {
    const IntegratorState& state = images.of(pass.integrator);
    PassInFlight out;
    if (pass.kind == NextPass::Kind::Preview) {
        out.mustBeShown = mustBeShown;
        out.previewSeconds = state.pace.expectedSeconds(state.preview().pixels());
    }
    out.mayWait = pass.kind == NextPass::Kind::Film && images.shown().passes() > 0 && state.passes() > 0;
    return out;
}

Result<bool> PassRunner::render(const NextPass& pass, SessionImages* images) {
    const PassParams params = passParams(*images, pass);
    const FilmRegion* region =
        pass.kind == NextPass::Kind::Film ? images->of(pass.integrator).regionOfPass() : nullptr;
    backend_->setRegion(region != nullptr ? std::optional(*region) : std::nullopt);
    if (pass.isAov()) { return backend_->renderAovPass(params, queue_->stopFlag(), &aovSamples_); }
    const Result<Integrator*> integrator = backend_->integrator(pass.integrator);
    if (!integrator) { return integrator.error(); }
    (*integrator)->prepare(*images->scene());
    IntegratorState& state = images->of(pass.integrator);
    ImageStatistics* statistics = pass.isPreview() ? state.statisticsForPreviewPass()
                                                   : state.statisticsForPass(params.width, params.height);
    return (*integrator)->renderPass(params, queue_->stopFlag(), statistics, &samples_);
}

void PassRunner::commit(const NextPass& pass, double seconds, SessionImages* images,
                        SessionCounters* counters) {
    IntegratorState& state = images->of(pass.integrator);
    const Film& preview = state.preview().film;
    AovImages& aovs = images->aovs;
    switch (pass.kind) {
        case NextPass::Kind::Preview:
            state.commitPreview(samples_, seconds, threads_);
            ++counters->previewPasses;
            break;
        case NextPass::Kind::PreviewAov:
            aovs.commit(&aovs.preview, aovSamples_, preview.width(), preview.height(), threads_);
            break;
        case NextPass::Kind::Film:
            commitFilm(&state, seconds, *images->scene(), counters);
            break;
        case NextPass::Kind::FilmAov:
            aovs.commit(&aovs.film, aovSamples_, images->size().width, images->size().height, threads_);
            break;
        case NextPass::Kind::None:
            break;
    }
}

void PassRunner::commitFilm(IntegratorState* state, double seconds, const SceneDescription& scene,
                            SessionCounters* counters) {
    const double decay = integratorType(state->kind()).statisticsDecay(scene);
    const bool isAllocated = state->commit(samples_, scene.resolution, seconds, decay, threads_);
    counters->filmAllocations += isAllocated ? 1 : 0;
    if (state->recordError(threads_)) { publishCurve(*state); }
}

void PassRunner::publishCurve(const IntegratorState& state) const {
    published_->setCurve(state.kind(), std::make_shared<const ConvergenceCurve>(state.curve()));
}

void PassRunner::addMemory(MemoryUse* use) const {
    (*use)[MemoryPart::PassSamples] += samples_.capacity() * sizeof(PixelSample);
    (*use)[MemoryPart::Aovs] += aovSamples_.capacity() * sizeof(AovSample);
}

}  // namespace glint
