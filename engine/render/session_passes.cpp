// Which pass is next, running it, committing it, and showing what came of it.
#include <algorithm>
#include <limits>

#include "engine/render/pass_params.h"
#include "engine/render/session_worker.h"
#include "engine/render/snapshot.h"

namespace glint {
namespace {

constexpr double kSnapshotInterval = 1.0 / 60.0;
/// Where a whole pass takes longer than this, finer previews fill the time.
constexpr double kRefineAboveSeconds = 0.15;

int64_t pixelCount(int width, int height) { return static_cast<int64_t>(width) * height; }

}  // namespace

SessionWorker::NextPass SessionWorker::nextPass(const Wishes& wishes) const {
    if (!built_ || failed_) {
        return NextPass::None;
    }
    if (previewsOnly(wishes)) {
        const bool aovTurn = wishes.aovs != 0 &&
                             previewAovs_.passes() < std::min(RenderSession::kAovPasses, preview_.passes());
        return aovTurn ? NextPass::PreviewAov : NextPass::Preview;
    }
    const bool film = wantsFilmPass(wishes);
    if (wishes.aovs != 0 && filmPasses() > 0 && aovFilm_.passes() < RenderSession::kAovPasses) {
        // In step with the film while it grows, so that neither waits for the other.
        if (!film || aovFilm_.passes() < filmPasses()) {
            return NextPass::FilmAov;
        }
    }
    return film ? NextPass::Film : NextPass::None;
}

bool SessionWorker::previewsOnly(const Wishes& wishes) const {
    if (!previewing_) {
        return false;
    }
    const bool incomplete = preview_.passes() == 0 || (wishes.aovs != 0 && previewAovs_.passes() == 0);
    return incomplete || (wishes.interacting && captures_.empty());
}

bool SessionWorker::wantsFilmPass(const Wishes& wishes) const {
    return filmPasses() == 0 || (!wishes.paused && !limitReached(wishes.limits));
}

bool SessionWorker::limitReached(const StopLimits& limits) const {
    return (limits.passes > 0 && filmPasses() >= limits.passes) ||
           (limits.renderSeconds > 0.0 && renderSeconds_ >= limits.renderSeconds) ||
           (limits.relativeError > 0.0 && filmPasses() > 1 && relativeError_ <= limits.relativeError);
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
        case NextPass::Film:
            params.pass = filmPasses();
            break;
        case NextPass::FilmAov:
            params.pass = aovFilm_.passes();
            break;
        case NextPass::None:
            break;
    }
    return params;
}

PassInFlight SessionWorker::passInFlight(NextPass kind) const {
    PassInFlight pass;
    if (kind == NextPass::Preview) {
        pass.mustBeShown = shownGeneration_ + 1 < status_.generation;
        pass.previewSeconds = pace_.expectedSeconds(pixelCount(preview_.width(), preview_.height()));
    }
    pass.stopsOnPause = kind == NextPass::Film && filmPasses() > 0;
    return pass;
}

void SessionWorker::runPass(NextPass kind) {
    const PassParams params = passParams(kind);
    const bool aov = kind == NextPass::PreviewAov || kind == NextPass::FilmAov;
    const auto began = SessionClock::now();
    mailbox_->beginPass(passInFlight(kind));
    const Result<bool> done = aov ? backend_->renderAovPass(params, mailbox_->stopFlag(), &aovSamples_)
                                  : backend_->renderPass(params, mailbox_->stopFlag(), &samples_);
    mailbox_->endPass();
    if (!done) {
        fail(done.error().format());
    } else if (*done) {
        commitPass(kind, secondsSince(began));
    } else {
        ++status_.counters.passesDiscarded;
        status_.lastCancelSeconds = secondsSince(mailbox_->stopRaised());
    }
}

void SessionWorker::commitPass(NextPass kind, double seconds) {
    shownIsOld_ = true;
    switch (kind) {
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
    previewing_ = false;
    prepareFilm();
    const uint64_t raysBefore = film_.rays();
    film_.commit(samples_, film_.passes(), options_.threads);
    const int64_t paths = pixelCount(film_.width(), film_.height());
    pace_.measured(paths, seconds);
    renderSeconds_ += seconds;
    secondsPerPass_ = secondsPerPass_ == 0.0 ? seconds : 0.8 * secondsPerPass_ + 0.2 * seconds;
    status_.passesPerSecond = 1.0 / std::max(1e-9, secondsPerPass_);
    status_.pathsPerSecond = status_.passesPerSecond * static_cast<double>(paths);
    status_.raysPerSecond = status_.passesPerSecond * static_cast<double>(film_.rays() - raysBefore);
    if (wishes_.limits.relativeError > 0.0) {
        relativeError_ = film_.relativeErrorEstimate(options_.threads);
    }
}

void SessionWorker::refinePreview(double seconds) {
    const Resolution& size = scene_->resolution;
    pace_.measured(pixelCount(preview_.width(), preview_.height()), seconds);
    showIfDue();
    if (wishes_.interacting) {
        const int better = pace_.choose(size.width, size.height, previewScale_);
        if (2 * better <= previewScale_) {
            startPreview(better);
        }
        return;
    }
    const bool passIsSlow =
        wishes_.aovs == 0 && pace_.expectedSeconds(pixelCount(size.width, size.height)) > kRefineAboveSeconds;
    if (passIsSlow && previewScale_ > 3) {
        startPreview(std::max(2, std::min(previewScale_ / 2, pace_.choose(size.width, size.height, 0))));
    }
}

void SessionWorker::prepareFilm() {
    if (!filmIsStale_) {
        return;
    }
    const Resolution& size = scene_->resolution;
    if (film_.width() == size.width && film_.height() == size.height) {
        film_.clear();
    } else {
        film_ = Film(size.width, size.height);
        ++status_.counters.filmAllocations;
    }
    filmIsStale_ = false;
}

void SessionWorker::prepareAovFilm(AovFilm* film, int width, int height) {
    if (film->width() != width || film->height() != height) {
        *film = AovFilm(width, height);
    }
}

void SessionWorker::showIfDue() {
    if (!shownIsOld_) {
        return;
    }
    const bool firstOfGeneration = shownGeneration_ != status_.generation;
    const bool resting = nextPass(wishes_) == NextPass::None;
    const bool sharper = shownPreview_ && !previewing_;
    if (firstOfGeneration || resting || sharper || secondsSince(shownAt_) >= kSnapshotInterval) {
        show(previewing_);
    }
}

void SessionWorker::show(bool preview) {
    shownIsOld_ = false;
    if (!options_.snapshots) {
        relativeError_ = preview || wishes_.limits.relativeError > 0.0
                             ? relativeError_
                             : film_.relativeErrorEstimate(options_.threads);
        return;
    }
    const Film& source = preview ? preview_ : film_;
    if (!preview) {
        relativeError_ = film_.relativeErrorEstimate(options_.threads);
    }
    auto snapshot = makeSnapshot(source, wishes_.standardError, options_.threads);
    snapshot->generation = status_.generation;
    snapshot->previewScale = preview ? previewScale_ : 1;
    snapshot->renderSeconds = renderSeconds_;
    snapshot->relativeError = preview ? std::numeric_limits<double>::infinity() : relativeError_;
    const AovFilm& aovs = preview ? previewAovs_ : aovFilm_;
    if (wishes_.aovs != 0 && aovs.passes() > 0) {
        if (!shownAovs_) {
            shownAovs_ = std::make_shared<AovFilm>(aovs);
        }
        snapshot->aovs = shownAovs_;
    }
    bulletin_->show(std::move(snapshot));
    shownGeneration_ = status_.generation;
    shownPreview_ = preview;
    shownStandardError_ = wishes_.standardError;
    shownAt_ = SessionClock::now();
    status_.previewScale = preview ? previewScale_ : 1;
    if (unansweredEdit_) {
        status_.lastEditToPictureSeconds = secondsSince(*unansweredEdit_);
        unansweredEdit_.reset();
        ++status_.picturesAfterEdits;
    }
}

}  // namespace glint
