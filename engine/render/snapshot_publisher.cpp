#include "engine/render/snapshot_publisher.h"

#include "engine/render/snapshot.h"

namespace glint {
namespace {

constexpr double kSnapshotInterval = 1.0 / 60.0;

PublishedImage describe(const IntegratorState& state, const SessionImages& images,
                        const RenderRequest& request) {
    return {images.ticket(),
            state.isPreviewing(),
            state.region(),
            state.restarts(),
            state.isPreviewing() ? state.previewScale() : 1,
            state.visiblePasses(),
            images.visibleAovs().passes(),
            request.standardError,
            request.integratorMaps,
            request.errorMaps};
}

bool lacksRequest(const PublishedImage& shown, const PublishedImage& wanted) {
    return (wanted.standardError && !shown.standardError) ||
           (wanted.integratorMaps && !shown.integratorMaps) || (wanted.errorMaps && !shown.errorMaps);
}

/// Null unless asked for, and until there are some of the snapshot's size.
std::shared_ptr<const AovFilm> aovsFor(const FilmSnapshot& snapshot, SessionImages* images) {
    const AovFilm& now = images->visibleAovs();
    if (now.passes() == 0 || now.width() != snapshot.width || now.height() != snapshot.height) {
        return nullptr;
    }
    std::shared_ptr<const AovFilm>& shared = images->aovs.shown;
    if (!shared || shared->width() != now.width() || shared->height() != now.height()) {
        shared = std::make_shared<AovFilm>(now);
    }
    return shared;
}

}  // namespace

bool SnapshotPublisher::isDue(const IntegratorState& state, const PublishedImage& now, bool rests) const {
    const PublishedImage& before = state.shown;
    if (now.passes == 0) { return false; }
    const bool isSharper = before.isPreview && !now.isPreview;
    if (before.ticket != now.ticket || isSharper || lacksRequest(before, now)) { return true; }
    const bool isNewer = now.isPreview != before.isPreview || now.passes != before.passes ||
                         now.previewScale != before.previewScale || now.aovPasses != before.aovPasses ||
                         now.region != before.region;
    return isNewer && (rests || secondsSince(state.shownAt) >= kSnapshotInterval);
}

void SnapshotPublisher::refresh(const PublishedImage& now, SessionImages* images,
                                IntegratorState* state) const {
    PublishedImage before = state->shown;
    before.ticket = now.ticket;
    std::shared_ptr<FilmSnapshot> snapshot;
    if (before == now && state->snapshot) {
        // The same picture: an edit of another integrator's settings must not cost a new one each time.
        snapshot = std::make_shared<FilmSnapshot>(*state->snapshot);
    } else {
        if (!now.isPreview) { state->estimateErrorAnew(threads_); }
        const RenderedImage& image = state->visible();
        snapshot = makeSnapshot(image.film, image.statistics.get(),
                                {now.standardError, now.integratorMaps, now.errorMaps}, threads_);
        snapshot->integrator = state->kind();
        snapshot->previewScale = now.previewScale;
        snapshot->renderSeconds = state->renderSeconds();
        setError(now.isPreview ? ErrorEstimate{} : state->error(), snapshot.get());
        snapshot->aovs = aovsFor(*snapshot, images);
    }
    snapshot->ticket = now.ticket;
    state->snapshot = std::move(snapshot);
    state->shown = now;
    state->shownAt = SessionClock::now();
}

void SnapshotPublisher::showIfDue(SessionImages* images, const RenderRequest& request, bool rests,
                                  SessionStatus* status) {
    if (!isEnabled_) { return; }
    IntegratorState& main = images->shown();
    if (const PublishedImage now = describe(main, *images, request); isDue(main, now, rests)) {
        refresh(now, images, &main);
        published_->show(main.snapshot);
        shownTicket_ = now.ticket;
        status->previewScale = now.previewScale;
        if (unanswered_) {
            status->lastEditToImageSeconds = secondsSince(*unanswered_);
            unanswered_.reset();
            ++status->imagesAfterEdits;
        }
    }
    if (shownTicket_ != images->ticket()) { return; }
    for (const IntegratorKind kind : images->compared(request)) {
        IntegratorState& beside = images->of(kind);
        if (const PublishedImage now = describe(beside, *images, request); isDue(beside, now, rests)) {
            refresh(now, images, &beside);
            published_->showBeside(beside.snapshot);
        }
    }
}

}  // namespace glint
