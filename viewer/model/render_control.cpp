#include "viewer/model/render_control.h"

#include <algorithm>

#include <unistd.h>

namespace glint {

namespace {

/// The last few films of a window's size, and not much of a small machine.
SessionOptions sessionOptions() {
    constexpr size_t kMostHeldBytes = size_t{768} << 20;
    const auto pages = static_cast<size_t>(std::max(sysconf(_SC_PHYS_PAGES), 0L));
    const auto pageBytes = static_cast<size_t>(std::max(sysconf(_SC_PAGESIZE), 0L));
    SessionOptions options;
    options.heldFilmBytes = std::min(kMostHeldBytes, pages * pageBytes / 8);
    return options;
}

}  // namespace

RenderControl::RenderControl(std::unique_ptr<Backend> backend)
    : session_(std::move(backend), sessionOptions()) {}

void RenderControl::send() {
    RenderRequest sent = request;
    sent.paused = sent.paused || isHeld;
    session_.request(sent);
}

void RenderControl::setInteracting(bool interacting) {
    if (request.interacting == interacting) { return; }
    request.interacting = interacting;
    send();
}

void RenderControl::refresh(std::optional<IntegratorKind> compared) {
    status_ = session_.status();
    snapshot_ = session_.snapshot();
    refreshOther(compared);
    const bool isShown = status_.ticket >= awaited_ && imageIsCurrent();
    if (isShown || status_.refusedTicket >= awaited_ || status_.state == SessionState::Failed) {
        awaited_ = 0;
    }
}

/// While the image moves, an other one that is an edit old is better than none: it would flicker.
void RenderControl::refreshOther(std::optional<IntegratorKind> compared) {
    auto other = compared ? session_.snapshot(*compared) : nullptr;
    const bool mayStay = compared && otherSnapshot_ && snapshot_ && snapshot_->previewScale > 1 &&
                         otherSnapshot_->integrator == *compared;
    if (other || !mayStay) { otherSnapshot_ = std::move(other); }
}

bool RenderControl::imageIsCurrent() const {
    return snapshot_ && snapshot_->previewScale == 1 && snapshot_->ticket == status_.ticket;
}

}  // namespace glint
