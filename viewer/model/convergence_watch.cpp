#include "viewer/model/convergence_watch.h"

#include <utility>

#include <fmt/format.h>

#include "viewer/model/display_settings.h"

namespace glint {

ConvergenceWatch::ConvergenceWatch(const SceneDocument* document, RenderControl* render, Notice* notice)
    : document_(document), render_(render), notice_(notice) {
    const auto empty = std::make_shared<const ConvergenceCurve>();
    films_.fill({empty, empty});
}

void ConvergenceWatch::forget() {
    isAnotherScene_ = true;
    for (IntegratorFilms& films : films_) {
        films.before = std::make_shared<const ConvergenceCurve>();
    }
}

void ConvergenceWatch::takeCurve(IntegratorKind kind) {
    constexpr size_t kWorthKeeping = 8;
    IntegratorFilms& films = films_[static_cast<size_t>(kind)];
    auto now = render_->curve(kind);
    const auto began = [](const ConvergenceCurve& curve) { return curve.points().front().renderSeconds; };
    const bool isAnother = !films.curve->empty() && (now->empty() || began(*now) != began(*films.curve));
    if (isAnother && !isAnotherScene_ && films.curve->points().size() >= kWorthKeeping) {
        films.before = std::move(films.curve);
    }
    films.curve = std::move(now);
}

/// The log has it already.
void ConvergenceWatch::tellOfReference() {
    if (const auto& error = reference.loadError()) {
        notice_->show(error->format(), true);
    } else if (reference.loaded()) {
        notice_->show(fmt::format("Reference {}", reference.loaded()->path));
    }
}

void ConvergenceWatch::refresh() {
    const bool wasLoading = reference.loading();
    reference.refresh();
    if (wasLoading && !reference.loading()) { tellOfReference(); }
    for (const IntegratorInfo& info : kIntegratorTable) {
        takeCurve(info.kind);
        reference.follow(info.kind, *curve(info.kind));
    }
    isAnotherScene_ = isAnotherScene_ && render_->awaitsImage();
    fit.check(reference.loaded(), document_->posted(), !render_->request.interacting);
    if (render_->awaitsImage() || !usableReference()) {
        return;  // what is shown may be of the scene before an edit
    }
    const SessionState state = render_->status().state;
    const bool resting = state == SessionState::Finished || state == SessionState::Paused;
    for (const auto& shown : {render_->snapshot(), render_->otherSnapshot()}) {
        if (shown) { reference.observe(shown, resting); }
    }
}

std::vector<IntegratorKind> ConvergenceWatch::integrators() const {
    const ComparedPair usual = DisplaySettings().pairOf(document_->draft().options.integrator);
    std::vector<IntegratorKind> kinds;
    for (const IntegratorInfo& info : kIntegratorTable) {
        const bool isUsual = info.kind == usual.left || info.kind == usual.right;
        if (isUsual || !curve(info.kind)->empty() || !curveBefore(info.kind)->empty()) {
            kinds.push_back(info.kind);
        }
    }
    return kinds;
}

std::shared_ptr<const LoadedReference> ConvergenceWatch::usableReference() const {
    const auto& image = reference.loaded();
    const Resolution& size = document_->draft().resolution;
    const bool isUsable =
        image && reference.mismatch(size.width, size.height).empty() && (fit.fits() || fit.useAnyway);
    return isUsable ? image : nullptr;
}

}  // namespace glint
