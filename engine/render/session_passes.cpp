// Which pass is next, running it, and committing it. session_snapshots.cpp shows what came of it.
#include <algorithm>

#include "engine/render/noise_calibration.h"
#include "engine/render/pass_params.h"
#include "engine/render/session_worker.h"

namespace glint {
namespace {

/// Where a whole pass takes longer than this, finer previews fill the time.
constexpr double kRefineAboveSeconds = 0.15;

int64_t pixelCount(int width, int height) { return static_cast<int64_t>(width) * height; }

}  // namespace

SessionWorker::NextPass SessionWorker::nextPass(const RenderRequest& request) const {
    if (!built_ || failed_) { return NextPass::None; }
    const bool isBare = (previewing_ ? preview_.passes() : filmPasses()) == 0;  // the picture that is shown
    if (!isBare && otherPreviewIsDue(request)) { return NextPass::OtherPreview; }
    if (previewsOnly(request)) {
        const bool aovTurn = request.aovs != 0 &&
                             previewAovs_.passes() < std::min(RenderSession::kAovPasses, preview_.passes());
        return aovTurn ? NextPass::PreviewAov : NextPass::Preview;
    }
    const bool film = wantsFilmPass(request);
    if (request.aovs != 0 && filmPasses() > 0 && aovFilm_.passes() < RenderSession::kAovPasses) {
        // In step with the film while it grows, so that neither waits for the other.
        if (!film || aovFilm_.passes() < filmPasses()) { return NextPass::FilmAov; }
    }
    return film ? NextPass::Film : NextPass::None;
}

bool SessionWorker::previewsOnly(const RenderRequest& request) const {
    if (!previewing_) { return false; }
    const bool incomplete = preview_.passes() == 0 || (request.aovs != 0 && previewAovs_.passes() == 0);
    return incomplete || (request.interacting && captures_.empty());
}

/// One at least, and then in turn with the other preview while something moves.
bool SessionWorker::otherPreviewIsDue(const RenderRequest& request) const {
    if (!isComparing(request) || !otherPreviewing_ || stateOf(otherIntegrator()).passes() > 0) {
        return false;
    }
    const bool isBehind = previewing_ && request.interacting && otherPreview_.passes() < preview_.passes();
    return otherPreview_.passes() == 0 || isBehind;
}

bool SessionWorker::wantsFilmPass(const RenderRequest& request) const {
    const bool otherIsMissing = isComparing(request) && stateOf(otherIntegrator()).passes() == 0;
    return filmPasses() == 0 || otherIsMissing || (!request.paused && !limitReached(request));
}

bool SessionWorker::limitReached(const RenderRequest& request) const {
    const StopLimits& limits = request.limits;
    const IntegratorState& shown = integratorState();
    const bool reached = (limits.passes > 0 && filmPasses() >= limits.passes) ||
                         (limits.renderSeconds > 0.0 && shown.renderSeconds >= limits.renderSeconds) ||
                         (limits.relativeError > 0.0 && hasReached(shown.curve, limits.relativeError));
    return reached &&
           (!isComparing(request) || stateOf(otherIntegrator()).renderSeconds >= shown.renderSeconds);
}

PassParams SessionWorker::passParams(NextPass kind) const {
    PassParams params = passParamsOf(*scene_);
    switch (kind) {
        case NextPass::Preview:
        case NextPass::PreviewAov:
            params.width = preview_.width();
            params.height = preview_.height();
            params.pass = kind == NextPass::Preview ? preview_.passes() : previewAovs_.passes();
            break;
        case NextPass::OtherPreview:
            params.width = otherPreview_.width();
            params.height = otherPreview_.height();
            params.pass = otherPreview_.passes();
            break;
        case NextPass::Film:
            params.pass = integratorStates_[static_cast<size_t>(passIntegrator_)].passes();
            break;
        case NextPass::FilmAov:
            params.pass = aovFilm_.passes();
            break;
        case NextPass::None:
            break;
    }
    return params;
}

/// Previews spread the photons as thinly over their pixels as the film does.
SppmParams SessionWorker::sppmParams(NextPass kind) const {
    SppmParams params = sppmParamsOf(*scene_);
    params.pass = passParams(kind);
    if (kind == NextPass::Preview || kind == NextPass::OtherPreview) {
        const double share =
            static_cast<double>(pixelCount(params.pass.width, params.pass.height)) /
            static_cast<double>(pixelCount(scene_->resolution.width, scene_->resolution.height));
        params.photonsPerPass = std::max(1u, static_cast<uint32_t>(share * params.photonsPerPass));
    }
    return params;
}

IntegratorKind SessionWorker::nextIntegrator(const RenderRequest& request) const {
    if (!isComparing(request) || filmPasses() == 0) { return integrator(); }
    return integratorStates_[0].renderSeconds <= integratorStates_[1].renderSeconds
               ? IntegratorKind::PathTracing
               : IntegratorKind::Sppm;
}

void SessionWorker::prepareSppm(int width, int height, uint32_t passes, SppmState* state) const {
    if (state->width != width || state->height != height) {
        *state = SppmState(width, height);
    } else if (passes == 0) {
        state->clear();
    }
}

/// The integrator's pass into samples_, and for SPPM into the statistics.
Result<bool> SessionWorker::renderInto(NextPass kind) {
    if (passIntegrator_ == IntegratorKind::PathTracing) {
        return backend_->renderPass(passParams(kind), commandQueue_->stopFlag(), &samples_);
    }
    const SppmParams params = sppmParams(kind);
    SppmState& state = kind != NextPass::Film
                           ? previewSppm_
                           : integratorStates_[static_cast<size_t>(IntegratorKind::Sppm)].sppm;
    prepareSppm(params.pass.width, params.pass.height, params.pass.pass, &state);
    return backend_->renderSppmPass(params, commandQueue_->stopFlag(), &state, &samples_);
}

PassInFlight SessionWorker::passInFlight(NextPass kind) const {
    PassInFlight pass;
    if (kind == NextPass::Preview) {
        pass.mustBeShown = shownTicket_ < previousTicket_;
        pass.previewSeconds = pace().expectedSeconds(pixelCount(preview_.width(), preview_.height()));
    } else if (kind == NextPass::OtherPreview) {
        pass.mustBeShown = shownOther_.ticket < previousTicket_;
        pass.previewSeconds = paceOf(otherIntegrator())
                                  .expectedSeconds(pixelCount(otherPreview_.width(), otherPreview_.height()));
    }
    pass.mayWait = kind == NextPass::Film && filmPasses() > 0 && stateOf(passIntegrator_).passes() > 0;
    return pass;
}

void SessionWorker::runPass(NextPass kind) {
    const bool aov = kind == NextPass::PreviewAov || kind == NextPass::FilmAov;
    passIntegrator_ = kind == NextPass::Film           ? nextIntegrator(request_)
                      : kind == NextPass::OtherPreview ? otherIntegrator()
                                                       : integrator();
    const auto began = SessionClock::now();
    commandQueue_->beginPass(passInFlight(kind));
    const Result<bool> done =
        aov ? backend_->renderAovPass(passParams(kind), commandQueue_->stopFlag(), &aovSamples_)
            : renderInto(kind);
    commandQueue_->endPass();
    if (!done) {
        fail(done.error().format());
    } else if (*done) {
        commitPass(kind, secondsSince(began));
    } else {
        ++status_.counters.passesDiscarded;
        status_.lastCancelSeconds = secondsSince(commandQueue_->stopRaised());
    }
}

void SessionWorker::commitPass(NextPass kind, double seconds) {
    shownIsOld_ = shownIsOld_ || kind != NextPass::OtherPreview;
    switch (kind) {
        case NextPass::OtherPreview:
            otherPreview_.commit(samples_, otherPreview_.passes(), options_.threads);
            paceOf(passIntegrator_)
                .measured(pixelCount(otherPreview_.width(), otherPreview_.height()), seconds);
            ++status_.counters.previewPasses;
            break;
        case NextPass::Preview:
            preview_.commit(samples_, preview_.passes(), options_.threads);
            ++status_.counters.previewPasses;
            refinePreview(seconds);
            break;
        case NextPass::PreviewAov:
            prepareAovFilm(&previewAovs_, preview_.width(), preview_.height());
            previewAovs_.commit(aovSamples_, options_.threads);
            shownAovs_.reset();
            break;
        case NextPass::Film:
            commitFilmPass(seconds);
            break;
        case NextPass::FilmAov:
            prepareAovFilm(&aovFilm_, scene_->resolution.width, scene_->resolution.height);
            aovFilm_.commit(aovSamples_, options_.threads);
            shownAovs_.reset();
            break;
        case NextPass::None:
            break;
    }
}

void SessionWorker::commitFilmPass(double seconds) {
    if (passIntegrator_ == integrator()) {
        previewing_ = false;
    } else {
        otherPreviewing_ = false;
    }
    IntegratorState& rendered = integratorStates_[static_cast<size_t>(passIntegrator_)];
    prepareFilm(&rendered);
    const uint64_t raysBefore = rendered.film.rays();
    rendered.film.commit(samples_, rendered.film.passes(), options_.threads);
    calibrateNoise(&rendered.sppm, static_cast<double>(scene_->sppm.alpha), options_.threads, &rendered.film);
    const int64_t paths = pixelCount(rendered.film.width(), rendered.film.height());
    rendered.renderSeconds += seconds;
    rendered.secondsPerPass =
        rendered.secondsPerPass == 0.0 ? seconds : 0.8 * rendered.secondsPerPass + 0.2 * seconds;
    rendered.raysOfPass = rendered.film.rays() - raysBefore;
    paceOf(passIntegrator_).measured(paths, seconds);
    recordError(passIntegrator_);
}

ErrorEstimate SessionWorker::errorEstimate(const IntegratorState& of) const {
    return estimateError(of.film, &of.sppm, options_.threads);
}

/// A point of the convergence curve where one is due: rarely, so that no pass becomes noticeably slower.
void SessionWorker::recordError(IntegratorKind kind) {
    IntegratorState& rendered = stateOf(kind);
    if (!rendered.curve.isDue(rendered.film.passes())) { return; }
    rendered.error = errorEstimate(rendered);
    rendered.curve.add({.passes = rendered.film.passes(),
                        .renderSeconds = rendered.renderSeconds,
                        .relativeError = rendered.error.relative,
                        .relativeErrorLow = rendered.error.low,
                        .relativeErrorHigh = rendered.error.high,
                        .relativeBias = rendered.error.bias});
    publishCurve(kind);
}

void SessionWorker::publishCurve(IntegratorKind kind) {
    published_->setCurve(kind, std::make_shared<const ConvergenceCurve>(stateOf(kind).curve));
}

void SessionWorker::refinePreview(double seconds) {
    const Resolution& size = scene_->resolution;
    paceOf(integrator()).measured(pixelCount(preview_.width(), preview_.height()), seconds);
    showIfDue();
    if (request_.interacting) {
        const int better = previewScaleNow(previewScale_);
        if (2 * better <= previewScale_) { startPreview(better); }
        return;
    }
    const bool passIsSlow = request_.aovs == 0 &&
                            pace().expectedSeconds(pixelCount(size.width, size.height)) > kRefineAboveSeconds;
    if (passIsSlow && previewScale_ > 3) {
        startPreview(std::max(2, std::min(previewScale_ / 2, pace().choose(size.width, size.height, 0))));
    }
}

void SessionWorker::prepareFilm(IntegratorState* of) {
    if (!of->isStale) { return; }
    const Resolution& size = scene_->resolution;
    if (of->film.width() == size.width && of->film.height() == size.height) {
        of->film.clear();
    } else {
        of->film = Film(size.width, size.height);
        ++status_.counters.filmAllocations;
    }
    of->isStale = false;
}

void SessionWorker::prepareAovFilm(AovFilm* film, int width, int height) {
    if (film->width() != width || film->height() != height) { *film = AovFilm(width, height); }
}

}  // namespace glint
