// The render thread's own state and its loop: take mail, rebuild what an edit names, run the next pass, show
// it.
//
// Used by render_session.cpp alone. Everything here belongs to the render thread; the mailbox and the
// bulletin are the only ways in and out.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/render/bulletin.h"
#include "engine/render/mailbox.h"
#include "engine/render/preview_scale.h"

namespace glint {

class SessionWorker {
  public:
    SessionWorker(std::unique_ptr<Backend> backend, SessionOptions options, Mailbox* mailbox,
                  Bulletin* bulletin);
    /// Until Mail::quit. Never throws: what goes wrong becomes SessionState::Failed.
    void run();

  private:
    enum class NextPass { None, Preview, PreviewAov, Film, FilmAov };

    void runOnce(Mail mail);
    void fail(const std::string& why);

    void takeEdit(SceneEdit edit, std::optional<ResumePoint> resume);
    bool rebuild(const SceneEdit& edit);
    void refuse(EditKind kinds, const std::string& why);
    void restartPicture();
    void continueFrom(ResumePoint resume);
    void startPreview(int scale);

    NextPass nextPass(const Wishes& wishes) const;
    bool previewsOnly(const Wishes& wishes) const;
    bool wantsFilmPass(const Wishes& wishes) const;
    bool limitReached(const StopLimits& limits) const;
    uint32_t filmPasses() const { return filmIsStale_ ? 0 : film_.passes(); }

    void runPass(NextPass kind);
    void commitPass(NextPass kind, double seconds);
    void commitFilmPass(double seconds);
    void refinePreview(double seconds);
    void prepareFilm();
    void prepareAovFilm(AovFilm* film, int width, int height);
    PassParams passParams(NextPass kind) const;
    PassInFlight passInFlight(NextPass kind) const;

    void takeRequests();
    void serveCaptures();
    void answerCaptures();
    void showIfDue();
    void show(bool preview);
    void setStatus();
    SessionState state() const;

    std::unique_ptr<Backend> backend_;
    SessionOptions options_;
    Mailbox* mailbox_;
    Bulletin* bulletin_;

    Wishes wishes_;
    uint64_t ticket_ = 0;
    std::vector<CapturePromise> captures_;
    std::shared_ptr<const SceneDescription> scene_;
    std::shared_ptr<const BuiltScene> built_;
    EditKind refusedKinds_ =
        EditKind::None;  ///< of edits that were refused: the next one has to make up for them
    bool failed_ = false;

    Film film_;
    bool filmIsStale_ =
        true;  ///< cleared only when a pass is ready to be added, to keep it out of the edit's way
    AovFilm aovFilm_;
    double renderSeconds_ = 0.0;
    double relativeError_ = 0.0;
    std::vector<PixelSample> samples_;
    std::vector<AovSample> aovSamples_;

    bool previewing_ = false;
    int previewScale_ = 1;
    Film preview_;
    AovFilm previewAovs_;
    PreviewScale pace_;

    bool shownIsOld_ = false;  ///< something was committed since the last snapshot
    bool shownPreview_ = false;
    bool shownStandardError_ = false;
    uint64_t shownGeneration_ = 0;
    SessionClock::time_point shownAt_;
    std::shared_ptr<const AovFilm> shownAovs_;  ///< shared between snapshots until another AOV pass is made
    std::optional<SessionClock::time_point> unansweredEdit_;

    SessionStatus status_;
    double secondsPerPass_ = 0.0;
};

}  // namespace glint
