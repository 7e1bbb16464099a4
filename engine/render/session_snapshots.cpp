// What the session shows of its films and previews, and when: pictures of the integrator that was chosen, and
// while comparing of the other one beside it.
#include "engine/render/session_worker.h"
#include "engine/render/snapshot.h"

namespace glint {
namespace {

constexpr double kSnapshotInterval = 1.0 / 60.0;

}  // namespace

void SessionWorker::showIfDue() {
    const bool nothingYet = (previewing_ ? preview_.passes() : filmPasses()) == 0;
    if (!shownIsOld_ || nothingYet) {
        showOtherIfDue();
        return;
    }
    const bool firstOfEdit = shownTicket_ != status_.ticket || shownIntegrator_ != integrator();
    const bool resting = nextPass(request_) == NextPass::None;
    const bool sharper = shownPreview_ && !previewing_;
    if (firstOfEdit || resting || sharper || shownLacksRequest() ||
        secondsSince(shownAt_) >= kSnapshotInterval) {
        show(previewing_);
    }
    showOtherIfDue();
}

void SessionWorker::show(bool preview) {
    shownIsOld_ = false;
    IntegratorState& shown = integratorState();
    if (!options_.snapshots) { return; }
    if (!preview) { shown.error = errorEstimate(shown); }
    published_->show(snapshotOf(integrator(), preview));
    shownTicket_ = status_.ticket;
    shownIntegrator_ = integrator();
    shownPreview_ = preview;
    shownStandardError_ = request_.standardError;
    shownIntegratorMaps_ = request_.integratorMaps;
    shownErrorMaps_ = request_.errorMaps;
    shownAt_ = SessionClock::now();
    status_.previewScale = preview ? previewScale_ : 1;
    if (unansweredEdit_) {
        status_.lastEditToImageSeconds = secondsSince(*unansweredEdit_);
        unansweredEdit_.reset();
        ++status_.imagesAfterEdits;
    }
}

std::shared_ptr<FilmSnapshot> SessionWorker::snapshotOf(IntegratorKind kind, bool preview) {
    const IntegratorState& of = stateOf(kind);
    const bool isOther = kind != integrator();
    const Film& film = !preview ? of.film : isOther ? otherPreview_ : preview_;
    const SppmState& sppm = preview ? previewSppm_ : of.sppm;
    const bool hasPhotons = kind == IntegratorKind::Sppm && sppm.passes > 0;
    auto snapshot =
        makeSnapshot(film, hasPhotons ? &sppm : nullptr,
                     {request_.standardError, request_.integratorMaps, request_.errorMaps}, options_.threads);
    snapshot->ticket = status_.ticket;
    snapshot->integrator = kind;
    snapshot->previewScale = !preview ? 1 : isOther ? otherPreviewScale_ : previewScale_;
    snapshot->renderSeconds = of.renderSeconds;
    setError(preview ? ErrorEstimate{} : of.error, snapshot.get());
    // While comparing both pictures share them: they are of the camera, not of an integrator.
    const AovFilm& aovs = previewing_ ? previewAovs_ : aovFilm_;
    const bool fits = aovs.width() == snapshot->width && aovs.height() == snapshot->height;
    if (request_.aovs != 0 && aovs.passes() > 0 && fits) {
        if (!shownAovs_ || shownAovs_->width() != aovs.width() || shownAovs_->height() != aovs.height()) {
            shownAovs_ = std::make_shared<AovFilm>(aovs);
        }
        snapshot->aovs = shownAovs_;
    }
    return snapshot;
}

/// While comparing: the film of the integrator that is not shown, kept beside the one that is.
void SessionWorker::showOtherIfDue() {
    IntegratorState& other = stateOf(otherIntegrator());
    const bool preview = other.passes() == 0;
    const uint32_t passes = !preview ? other.passes() : otherPreviewing_ ? otherPreview_.passes() : 0;
    if (!options_.snapshots || !isComparing(request_) || passes == 0 || shownTicket_ != status_.ticket) {
        return;
    }
    const ShownOther now{status_.ticket,
                         otherIntegrator(),
                         preview,
                         other.restarts,
                         passes,
                         aovFilm_.passes(),
                         request_.standardError,
                         request_.integratorMaps,
                         request_.errorMaps};
    ShownOther before = shownOther_;
    if (now == before) { return; }
    before.passes = now.passes;
    before.aovPasses = now.aovPasses;
    const bool onlyMorePasses = now == before && nextPass(request_) != NextPass::None;
    if (onlyMorePasses && secondsSince(shownOtherAt_) < kSnapshotInterval) { return; }
    before = shownOther_;
    before.ticket = now.ticket;
    std::shared_ptr<FilmSnapshot> image;
    if (now == before && shownOtherImage_) {
        // The same film: an edit of the photons alone must not cost a picture of the other one each time.
        image = std::make_shared<FilmSnapshot>(*shownOtherImage_);
        image->ticket = now.ticket;
    } else {
        if (!preview) { other.error = errorEstimate(other); }
        image = snapshotOf(otherIntegrator(), preview);
    }
    shownOtherImage_ = image;
    published_->showOther(std::move(image));
    shownOther_ = now;
    shownOtherAt_ = SessionClock::now();
}

}  // namespace glint
