// The render thread's own state and its loop: take commands, rebuild what an edit names, run the next pass,
// show it.
//
// Used by render_session.cpp alone. Everything here belongs to the render thread; the command queue and the
// published state are the only ways in and out.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "engine/render/command_queue.h"
#include "engine/render/error_estimate.h"
#include "engine/render/preview_scale.h"
#include "engine/render/published_state.h"

namespace glint {

class SessionWorker {
  public:
    SessionWorker(std::unique_ptr<Backend> backend, SessionOptions options, CommandQueue* commandQueue,
                  PublishedState* published);
    /// Until Commands::quit. Never throws: what goes wrong becomes SessionState::Failed.
    void run();

  private:
    /// One integrator's picture. Both are kept, so that switching loses nothing.
    struct IntegratorState {
        Film film;
        SppmState sppm;  ///< empty for path tracing
        /// cleared only when a pass is ready to be added, to keep it out of the edit's way
        bool isStale = true;
        uint64_t restarts = 0;  ///< tells this film from those before
        double renderSeconds = 0.0;
        ErrorEstimate error;
        double secondsPerPass = 0.0;
        uint64_t raysOfPass = 0;
        ConvergenceCurve curve;

        uint32_t passes() const { return isStale ? 0 : film.passes(); }
    };
    static constexpr size_t kIntegrators = 2;

    enum class NextPass { None, Preview, PreviewAov, OtherPreview, Film, FilmAov };

    void runOnce(Commands commands);
    void fail(const std::string& why);

    void takeEdit(SceneEdit edit, std::optional<ResumePoint> resume);
    bool rebuild(const SceneEdit& edit);
    void refuse(EditKind kinds, const std::string& why);
    /// Empties the films that an edit of these kinds makes wrong, and begins anew with the one that is shown.
    void restartImage(EditKind kinds);
    void startIntegratorState();
    void continueFrom(ResumePoint resume);
    void startPreview(int scale);
    /// While comparing: previews of the integrator that is not shown, until its film has a pass.
    void startOtherPreview();
    int previewScaleNow(int present) const;

    NextPass nextPass(const RenderRequest& request) const;
    bool previewsOnly(const RenderRequest& request) const;
    bool otherPreviewIsDue(const RenderRequest& request) const;
    bool wantsFilmPass(const RenderRequest& request) const;
    /// Of the film that is shown; while comparing, the other one must have had as much time too.
    bool limitReached(const RenderRequest& request) const;
    uint32_t filmPasses() const { return integratorState().passes(); }
    /// The integrator that is shown, and the one that the next film pass is for: while comparing, whichever
    /// had less time.
    IntegratorKind integrator() const;
    IntegratorKind nextIntegrator(const RenderRequest& request) const;
    IntegratorKind otherIntegrator() const;
    bool isComparing(const RenderRequest& request) const;
    IntegratorState& stateOf(IntegratorKind kind) { return integratorStates_[static_cast<size_t>(kind)]; }
    const IntegratorState& stateOf(IntegratorKind kind) const {
        return integratorStates_[static_cast<size_t>(kind)];
    }
    IntegratorState& integratorState() { return stateOf(integrator()); }
    const IntegratorState& integratorState() const { return stateOf(integrator()); }

    void runPass(NextPass kind);
    Result<bool> renderInto(NextPass kind);
    void commitPass(NextPass kind, double seconds);
    void commitFilmPass(double seconds);
    void refinePreview(double seconds);
    void prepareFilm(IntegratorState* integratorState);
    void prepareSppm(int width, int height, uint32_t passes, SppmState* state) const;
    ErrorEstimate errorEstimate(const IntegratorState& integratorState) const;
    void recordError(IntegratorKind kind);
    void publishCurve(IntegratorKind kind);
    void prepareAovFilm(AovFilm* film, int width, int height);
    PassParams passParams(NextPass kind) const;
    SppmParams sppmParams(NextPass kind) const;
    PassInFlight passInFlight(NextPass kind) const;

    void takeRequests();
    bool shownLacksRequest() const;
    void serveCaptures();
    void answerCaptures();
    void showIfDue();
    void show(bool preview);
    void showOtherIfDue();
    std::shared_ptr<FilmSnapshot> snapshotOf(IntegratorKind kind, bool preview);
    const PreviewScale& paceOf(IntegratorKind kind) const { return paces_[static_cast<size_t>(kind)]; }
    PreviewScale& paceOf(IntegratorKind kind) { return paces_[static_cast<size_t>(kind)]; }
    const PreviewScale& pace() const { return paceOf(integrator()); }
    MemoryUse memoryUse() const;
    void setStatus();
    SessionState state() const;

    std::unique_ptr<Backend> backend_;
    SessionOptions options_;
    CommandQueue* commandQueue_;
    PublishedState* published_;

    RenderRequest request_;
    uint64_t messages_ = 0;
    EditTicket previousTicket_ = 0;  ///< of the edit that was taken before the newest one
    std::vector<CapturePromise> captures_;
    std::shared_ptr<const SceneDescription> scene_;
    std::shared_ptr<const BuiltScene> built_;
    MemoryUse sceneMemory_;  ///< of built_
    /// of edits that were refused: the next one has to make up for them
    EditKind refusedKinds_ = EditKind::None;
    bool failed_ = false;

    std::array<IntegratorState, kIntegrators> integratorStates_;
    AovFilm aovFilm_;
    std::vector<PixelSample> samples_;
    std::vector<AovSample> aovSamples_;

    IntegratorKind passIntegrator_ = IntegratorKind::PathTracing;  ///< of the pass in flight
    bool previewing_ = false;
    int previewScale_ = 1;
    Film preview_;
    SppmState previewSppm_;  ///< of the one of the two previews that is SPPM's
    AovFilm previewAovs_;
    bool comparing_ = false;  ///< as the request was before
    bool otherPreviewing_ = false;
    int otherPreviewScale_ = 1;
    Film otherPreview_;
    std::array<PreviewScale, kIntegrators> paces_;  ///< by IntegratorKind

    bool shownIsOld_ = false;  ///< something was committed since the last snapshot
    bool shownPreview_ = false;
    bool shownStandardError_ = false;
    bool shownIntegratorMaps_ = false;
    bool shownErrorMaps_ = false;
    uint64_t shownTicket_ = 0;
    IntegratorKind shownIntegrator_ = IntegratorKind::PathTracing;
    SessionClock::time_point shownAt_;
    std::shared_ptr<const AovFilm> shownAovs_;  ///< shared between snapshots until another AOV pass is made
    std::optional<SessionClock::time_point> unansweredEdit_;

    /// What the newest picture of the other integrator is of: a new one is due when any of it changed.
    struct ShownOther {
        uint64_t ticket = 0;
        IntegratorKind integrator = IntegratorKind::PathTracing;
        bool preview = false;
        uint64_t restarts = 0;
        uint32_t passes = 0;
        uint32_t aovPasses = 0;
        bool standardError = false;
        bool integratorMaps = false;
        bool errorMaps = false;
        bool operator==(const ShownOther&) const = default;
    };
    ShownOther shownOther_;
    std::shared_ptr<const FilmSnapshot> shownOtherImage_;
    SessionClock::time_point shownOtherAt_;

    SessionStatus status_;
};

}  // namespace glint
