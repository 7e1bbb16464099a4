// What a session shows of its pictures, and when: snapshots of the integrator that is shown, and of those
// that are compared with it.
#pragma once

#include <optional>

#include "engine/render/published_state.h"
#include "engine/render/session_images.h"

namespace glint {

class SnapshotPublisher {
  public:
    /// threads: for making snapshots; 0: all. Without `enabled`, nothing is ever shown.
    SnapshotPublisher(PublishedState* published, bool enabled, int threads)
        : published_(published), isEnabled_(enabled), threads_(threads) {}

    /// An edit was posted then; the first picture after it answers it.
    void expectAnswer(SessionClock::time_point posted) { unanswered_ = unanswered_.value_or(posted); }
    /// It was refused: no picture will.
    void forgetAnswer() { unanswered_.reset(); }

    /// Publishes what is worth it: at once what is the first of an edit, sharper, or carries what was asked
    /// for; more passes at 60 Hz, and when `rests`: no further pass will come by itself. Updates the status'
    /// figures of snapshots.
    void showIfDue(SessionImages* images, const RenderRequest& request, bool rests, SessionStatus* status);

    /// The newest edit that a picture of this integrator has been shown of.
    EditTicket shownTicket(const SessionImages& images, IntegratorKind kind) const {
        return kind == images.shownKind() ? shownTicket_ : images.of(kind).shown.ticket;
    }

  private:
    bool isDue(const IntegratorState& state, const PublishedImage& now, bool rests) const;
    /// Makes the snapshot that `now` describes.
    void refresh(const PublishedImage& now, SessionImages* images, IntegratorState* state) const;

    PublishedState* published_;
    bool isEnabled_;
    int threads_;
    EditTicket shownTicket_ = 0;
    std::optional<SessionClock::time_point> unanswered_;
};

}  // namespace glint
