#include "viewer/model/render_control.h"

#include <utility>

#include "engine/base/log.h"

namespace glint {

RenderControl::RenderControl(std::unique_ptr<Backend> backend) : session_(std::move(backend)) {}

void RenderControl::setInteracting(bool interacting) {
    if (request.interacting == interacting) { return; }
    request.interacting = interacting;
    send();
}

void RenderControl::resume(std::shared_ptr<const SceneDescription> scene, ResumePoint from) {
    awaited_ = session_.resume(std::move(scene), std::move(from));
}

void RenderControl::restart() {
    awaited_ = session_.restart();
    logInfo("Restarted by hand");
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
