// What the controlling thread wants of the render thread: edits joined to one, captures, and the
// present request.
//
// It also owns the stop flag, since whether a pass in flight is worth stopping has to be decided together
// with taking the message. Knows nothing of films or passes. Thread-safe.
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <future>
#include <mutex>
#include <optional>
#include <vector>

#include "engine/render/render_session.h"
#include "engine/render/session_clock.h"

namespace glint {

using CapturePromise = std::promise<std::optional<SessionCapture>>;

/// What happened since the render thread last looked; each happens once.
struct Commands {
    std::optional<SceneEdit> edit;      ///< the newest scene; kinds of all edits that waited
    FilmTake take = 0;                  ///< belongs to `edit`
    std::optional<ResumePoint> resume;  ///< belongs to `edit`
    bool restart = false;
    bool quit = false;
    std::vector<CapturePromise> captures;
    std::optional<SessionClock::time_point> firstPosted;  ///< of the edits and restarts
    EditTicket ticket = 0;                                ///< of the newest edit or restart
    uint64_t messages = 0;  ///< counts everything asked for up to now, requests included

    bool invalidatesImage() const { return edit.has_value() || restart; }
};

/// What runs now, as far as it matters to whether an edit or a pause should stop it.
struct PassInFlight {
    /// nothing has been shown since an edit before: stopping again would freeze the picture
    bool mustBeShown = false;
    /// a preview that should take so long: one that is almost done is let through
    double previewSeconds = 0.0;
    /// A film pass while there is a picture to look at: a pause stops it, and so does a request for something
    /// that the picture does not show, which then comes at once instead of after the pass.
    bool mayWait = false;
};

class CommandQueue {
  public:
    EditTicket post(SceneEdit edit, FilmTake take, std::optional<ResumePoint> resume);
    EditTicket postRestart();
    void postQuit();
    void postCapture(CapturePromise capture);
    /// Nothing is posted when it equals the present one.
    void request(const RenderRequest& request);

    /// Blocks until anything was asked for or hasWork(request), which must not touch the queue. Hands over
    /// the commands, and the request of that moment.
    Commands take(const std::function<bool(const RenderRequest&)>& hasWork, RenderRequest* request);

    /// Declares that a pass begins, and clears the stop flag unless a command already waits that should
    /// stop it.
    void beginPass(const PassInFlight& pass);
    void endPass();
    /// Raised by edits, restarts and pauses that are worth it, and by quitting.
    const std::atomic<bool>& stopFlag() const { return stop_; }
    /// When what raised the flag was posted; now, if nothing did.
    SessionClock::time_point stopRaised() const;

    /// Raised while a build under way is for nothing: another scene waits, or the session ends.
    const std::atomic<bool>& abandonBuild() const { return abandonBuild_; }
    /// Counts everything asked for.
    uint64_t messages() const;

  private:
    EditTicket postEdit(SessionClock::time_point now);
    bool worthStopping(SessionClock::time_point now) const;
    void asked();
    void raiseStopFor(SessionClock::time_point posted);

    mutable std::mutex mutex_;
    std::condition_variable changed_;
    Commands commands_;
    RenderRequest request_;
    uint64_t taken_ = 0;
    std::optional<PassInFlight> pass_;
    SessionClock::time_point passBegan_;
    SessionClock::time_point stopRaised_;
    std::atomic<bool> stop_{false};
    std::atomic<bool> abandonBuild_{false};
};

}  // namespace glint
