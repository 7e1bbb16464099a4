#include "engine/render/pass_schedule.h"

#include <algorithm>

#include "engine/render/pass_params.h"

namespace glint {
namespace {

using Kind = NextPass::Kind;

/// Previews only, while the shown one is incomplete or something moves.
bool keepsToPreviews(const SessionImages& images, const RenderRequest& request, bool captureWaits) {
    if (!images.shown().isPreviewing()) { return false; }
    const bool lacksAovs = request.aovs != 0 && images.aovs.preview.passes() == 0;
    return images.shown().visiblePasses() == 0 || lacksAovs || (request.interacting && !captureWaits);
}

/// One at least, and then in turn with the preview that is shown while something moves.
bool isPreviewBesideDue(const SessionImages& images, const IntegratorState& beside,
                        const RenderRequest& request) {
    if (!beside.isPreviewing() || beside.passes() > 0) { return false; }
    const IntegratorState& shown = images.shown();
    const bool isBehind =
        shown.isPreviewing() && request.interacting && beside.visiblePasses() < shown.visiblePasses();
    return beside.visiblePasses() == 0 || isBehind;
}

bool wantsFilmPass(const SessionImages& images, const RenderRequest& request) {
    const auto isEmpty = [&](IntegratorKind kind) { return images.of(kind).passes() == 0; };
    return images.shown().passes() == 0 || std::ranges::any_of(images.compared(request), isEmpty) ||
           (!request.paused && !isLimitReached(images, request));
}

/// While comparing, whichever had least time.
IntegratorKind nextOfFilms(const SessionImages& images, const RenderRequest& request) {
    if (images.shown().passes() == 0) { return images.shownKind(); }
    std::vector<IntegratorKind> kinds = images.compared(request);
    kinds.push_back(images.shownKind());
    std::ranges::sort(kinds);
    return *std::ranges::min_element(kinds, {},
                                     [&](IntegratorKind kind) { return images.of(kind).renderSeconds(); });
}

}  // namespace

bool isLimitReached(const SessionImages& images, const RenderRequest& request) {
    const StopLimits& limits = request.limits;
    const IntegratorState& shown = images.shown();
    const double seconds = shown.renderSeconds();
    const bool isReached = (limits.passes > 0 && shown.passes() >= limits.passes) ||
                           (limits.renderSeconds > 0.0 && seconds >= limits.renderSeconds) ||
                           (limits.relativeError > 0.0 && hasReached(shown.curve(), limits.relativeError));
    return isReached && std::ranges::all_of(images.compared(request), [&](IntegratorKind kind) {
               return images.of(kind).renderSeconds() >= seconds;
           });
}

NextPass nextPass(const SessionImages& images, const RenderRequest& request, bool captureWaits) {
    const IntegratorState& shown = images.shown();
    if (shown.visiblePasses() > 0) {
        for (const IntegratorKind kind : images.compared(request)) {
            if (isPreviewBesideDue(images, images.of(kind), request)) { return {Kind::Preview, kind}; }
        }
    }
    if (keepsToPreviews(images, request, captureWaits)) {
        const uint32_t most = std::min(kAovPasses, shown.visiblePasses());
        const bool isAovTurn = request.aovs != 0 && images.aovs.preview.passes() < most;
        return {isAovTurn ? Kind::PreviewAov : Kind::Preview, shown.kind()};
    }
    const bool wantsFilm = wantsFilmPass(images, request);
    const uint32_t aovPasses = images.aovs.film.passes();
    const uint32_t mostAovs = request.aovsEndWithFilm ? std::min(kAovPasses, shown.passes()) : kAovPasses;
    if (request.aovs != 0 && shown.passes() > 0 && aovPasses < mostAovs) {
        // In step with the film while it grows, so that neither waits for the other.
        if (!wantsFilm || aovPasses < shown.passes()) { return {Kind::FilmAov, shown.kind()}; }
    }
    return wantsFilm ? NextPass{Kind::Film, nextOfFilms(images, request)} : NextPass{};
}

PassParams passParams(const SessionImages& images, const NextPass& pass) {
    PassParams params = passParamsOf(*images.scene());
    const IntegratorState& state = images.of(pass.integrator);
    if (pass.isPreview()) {
        params.width = state.preview().film.width();
        params.height = state.preview().film.height();
    }
    params.pass = pass.kind == Kind::Preview      ? state.preview().film.passes()
                  : pass.kind == Kind::PreviewAov ? images.aovs.preview.passes()
                  : pass.kind == Kind::FilmAov    ? images.aovs.film.passes()
                                                  : state.passes();
    return params;
}

}  // namespace glint
