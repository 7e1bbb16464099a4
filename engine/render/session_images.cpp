#include "engine/render/session_images.h"

#include <algorithm>
#include <utility>

namespace glint {
namespace {

/// Where a whole pass takes longer than this, finer previews fill the time.
constexpr double kRefineAboveSeconds = 0.15;

}  // namespace

void AovImages::commit(AovFilm* to, const std::vector<AovSample>& samples, int width, int height,
                       int threads) {
    if (to->width() != width || to->height() != height) { *to = AovFilm(width, height); }
    to->commit(samples, threads);
    shown.reset();
}

SessionImages::SessionImages(bool previews, size_t heldFilmBytes, SessionCounters* counters)
    : hasPreviews_(previews), counters_(counters), held_(heldFilmBytes) {
    use({shownKind()});
}

IntegratorKind SessionImages::shownKind() const {
    return scene_ ? scene_->options.integrator : IntegratorKind::PathTracing;
}

std::vector<IntegratorKind> SessionImages::compared(const RenderRequest& request) const {
    std::vector<IntegratorKind> kinds;
    for (const IntegratorInfo& info : kIntegratorTable) {
        const bool isAsked = std::ranges::find(request.compare, info.kind) != request.compare.end();
        if (isAsked && info.kind != shownKind()) { kinds.push_back(info.kind); }
    }
    return kinds;
}

void SessionImages::use(const std::vector<IntegratorKind>& kinds) {
    for (const IntegratorKind kind : kinds) {
        states_.try_emplace(kind, kind);
    }
}

std::vector<IntegratorKind> SessionImages::takeScene(std::shared_ptr<const SceneDescription> scene,
                                                     EditKind kinds, FilmTake take,
                                                     const RenderRequest& request) {
    const std::shared_ptr<const SceneDescription> before = std::exchange(scene_, std::move(scene));
    use({shownKind()});
    use(compared(request));
    if (has(kinds, EditKind::Everything | EditKind::Accelerator)) {
        for (auto& [kind, state] : states_) {
            state.pace.forget();
        }
    }
    if (take != take_) { kinds |= EditKind::Everything; }
    std::vector<IntegratorKind> emptied = empty(kinds, before, request);
    take_ = take;
    if (held_.isEnabled()) {
        for (IntegratorKind kind : emptied) {
            auto film = held_.takeBack(kind, take_, scene_, request.interacting);
            if (film) { of(kind).goOnFrom(std::move(*film)); }
        }
    }
    begin(request);
    return emptied;
}

std::vector<IntegratorKind> SessionImages::restart(const RenderRequest& request) {
    std::vector<IntegratorKind> emptied = empty(EditKind::Everything, nullptr, request);
    begin(request);
    return emptied;
}

/// Empties what the kinds make wrong; holds films of the scene `before`, where there is one.
std::vector<IntegratorKind> SessionImages::empty(EditKind kinds,
                                                 const std::shared_ptr<const SceneDescription>& before,
                                                 const RenderRequest& request) {
    const EditKind ofOne = allOwnEdits() | EditKind::Integrator;
    const bool isOfAll = (kinds & ofOne) != kinds;
    const bool holds = held_.isEnabled() && before && !isOfDrag_;
    std::vector<IntegratorKind> emptied;
    for (auto& [kind, state] : states_) {
        if (kind != shownKind()) { state.endPreview(); }
        if (!isOfAll && !has(kinds, integratorType(kind).ownEdits())) { continue; }
        emptied.push_back(kind);
        if (holds && state.passes() > 0) {
            held_.hold(kind, take_, before, state.takeFilm());
        } else {
            state.restart();
        }
    }
    if (!emptied.empty()) { isOfDrag_ = request.interacting; }
    if (isOfAll) {
        aovs.film.clear();
        aovs.shown.reset();
    }
    return emptied;
}

void SessionImages::begin(const RenderRequest& request) {
    beginShown(request);
    for (const IntegratorKind kind : compared(request)) {
        startPreviewBeside(kind, request);
    }
}

void SessionImages::beginShown(const RenderRequest& request) {
    IntegratorState& state = shown();
    if (state.passes() > 0) {
        state.endPreview();
        return;
    }
    ++counters_->filmRestarts;
    startShownPreview(previewScaleNow(state.isPreviewing() ? state.previewScale() : 0, request));
}

void SessionImages::takeRequest(const RenderRequest& request) {
    if (request.aovs == 0) { aovs = {}; }
    isOfDrag_ = isOfDrag_ && request.interacting;
    if (!scene_) { return; }
    const std::vector<IntegratorKind> kinds = compared(request);
    use(kinds);
    for (const IntegratorKind kind : kinds) {
        const bool isNew = std::ranges::find(comparedBefore_, kind) == comparedBefore_.end();
        if (isNew && !of(kind).isPreviewing()) { startPreviewBeside(kind, request); }
    }
    for (auto& [kind, state] : states_) {
        state.setRegion(request.region, size());
        const bool isSeen = kind == shownKind() || std::ranges::find(kinds, kind) != kinds.end();
        if (!isSeen) { state.snapshot.reset(); }
    }
    comparedBefore_ = kinds;
}

void SessionImages::startShownPreview(int scale) {
    shown().startPreview(size().width, size().height, scale);
    if (shown().isPreviewing()) { aovs.preview = AovFilm(); }
}

/// Until its film has a pass.
void SessionImages::startPreviewBeside(IntegratorKind kind, const RenderRequest& request) {
    IntegratorState& state = of(kind);
    if (state.passes() > 0) { return; }
    const int scale =
        shown().isPreviewing() ? shown().previewScale() : previewScaleNow(state.previewScale(), request);
    state.startPreview(size().width, size().height, scale);
}

/// While comparing, the previews share the time and have one size: that of the slowest integrator.
int SessionImages::previewScaleNow(int present, const RenderRequest& request) const {
    if (!hasPreviews_) { return 1; }
    const std::vector<IntegratorKind> others = compared(request);
    // All of them together may take a fifth longer than one alone.
    const double share = others.empty() ? 1.0 : 1.2 / static_cast<double>(1 + others.size());
    const double seconds = share * PreviewScale::kTargetSeconds;
    int scale = shown().pace.choose(size().width, size().height, present, seconds);
    for (const IntegratorKind kind : others) {
        scale = std::max(scale, of(kind).pace.choose(size().width, size().height, present, seconds));
    }
    return scale;
}

void SessionImages::refinePreview(const RenderRequest& request) {
    const IntegratorState& state = shown();
    const int scale = state.previewScale();
    if (request.interacting) {
        const int better = previewScaleNow(scale, request);
        if (2 * better <= scale) { startShownPreview(better); }
        return;
    }
    const double passSeconds = state.pace.expectedSeconds(pixelCount(size().width, size().height));
    if (request.aovs == 0 && passSeconds > kRefineAboveSeconds && scale > 3) {
        const int quick = state.pace.choose(size().width, size().height, 0);
        startShownPreview(std::max(2, std::min(scale / 2, quick)));
    }
}

void SessionImages::addMemory(MemoryUse* use) const {
    for (const auto& [kind, state] : states_) {
        (*use)[MemoryPart::Film] += state.image().film.bytes();
        (*use)[MemoryPart::Preview] += state.preview().film.bytes();
        if (const auto& statistics = state.image().statistics) {
            (*use)[statistics->memoryPart()] += statistics->bytes();
        }
        if (const auto& statistics = state.preview().statistics) {
            (*use)[MemoryPart::Preview] += statistics->bytes();
        }
    }
    (*use)[MemoryPart::Preview] += aovs.preview.bytes();
    (*use)[MemoryPart::Aovs] += aovs.film.bytes();
    (*use)[MemoryPart::Film] += held_.bytes();
}

size_t SessionImages::bytes() const {
    MemoryUse use;
    addMemory(&use);
    return use.total();
}

}  // namespace glint
