// The render of the open scene: what is wanted of it, and what has come back.
//
// The one place that holds the request and the ticket of the newest edit. Lives on the UI thread.
#pragma once

#include <future>
#include <memory>
#include <optional>
#include <utility>

#include "engine/render/render_session.h"

namespace glint {

class RenderControl {
  public:
    explicit RenderControl(std::unique_ptr<Backend> backend);

    /// Limits and pause are changed by panels and keys at any time; a frame's send() hands all of it over.
    RenderRequest request;
    void send();
    bool isHeld = false;  ///< other work comes first: paused, whatever the request says
    /// Edits that follow are shown at low resolution until it is called with false.
    void setInteracting(bool interacting);

    void post(SceneEdit edit, FilmTake take) { awaited_ = session_.post(std::move(edit), take); }
    void resume(std::shared_ptr<const SceneDescription> scene, ResumePoint from, FilmTake take) {
        awaited_ = session_.resume(std::move(scene), std::move(from), take);
    }

    /// Empties the films, as the edit of this frame.
    void restart() { isRestartAsked_ = true; }
    bool takeRestart() { return std::exchange(isRestartAsked_, false); }

    /// Once a frame: takes what the render thread has published. `compared`: whose image is shown beside the
    /// scene's own; nothing: none.
    void refresh(std::optional<IntegratorKind> compared);
    const SessionStatus& status() const { return status_; }
    /// Of the scene's own integrator; null before the first.
    const std::shared_ptr<const FilmSnapshot>& snapshot() const { return snapshot_; }
    /// Of the one that it is compared with; null while nothing is, and before its first pass.
    const std::shared_ptr<const FilmSnapshot>& otherSnapshot() const { return otherSnapshot_; }
    /// The image is at full resolution and belongs to the scene as it is now.
    bool imageIsCurrent() const;
    /// An edit was posted, and no image of it has come back.
    bool awaitsImage() const { return awaited_ != 0; }

    std::shared_ptr<const BuiltScene> builtScene() const { return session_.builtScene(); }
    /// As of this moment, whatever the frame began with.
    SessionStatus statusNow() const { return session_.status(); }
    std::shared_ptr<const ConvergenceCurve> curve(IntegratorKind integrator) const {
        return session_.convergenceCurve(integrator);
    }
    /// The film, exactly, when the pass in flight is done (RenderSession::captureLater).
    std::future<std::optional<SessionCapture>> captureLater() { return session_.captureLater(); }
    /// The same; blocks.
    std::optional<SessionCapture> capture() { return session_.capture(); }

  private:
    void refreshOther(std::optional<IntegratorKind> compared);

    RenderSession session_;
    SessionStatus status_;
    std::shared_ptr<const FilmSnapshot> snapshot_;
    std::shared_ptr<const FilmSnapshot> otherSnapshot_;
    bool isRestartAsked_ = false;
    EditTicket awaited_ = 0;  ///< 0: every edit has been answered
};

}  // namespace glint
