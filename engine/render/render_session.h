// A render that runs on its own thread while someone edits: the heart of the window, of `glint render` and of
// the tests.
//
// Everything public may be called from one controlling thread (the UI) and returns at once, unless it says
// otherwise. Edits and requests go into a command queue, coalesced; the render thread takes them between
// passes, or at once through the backend's stop flag. What comes back are immutable snapshots. Exceptions and
// errors end up in SessionStatus.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/builders/scene_builder.h"
#include "engine/render/backend.h"
#include "engine/render/convergence_curve.h"
#include "engine/render/film.h"
#include "engine/scene/scene_edit.h"

namespace glint {

/// When to stop by itself; 0: no such limit. Changing one never restarts anything.
struct StopLimits {
    uint32_t passes = 0;
    double renderSeconds = 0.0;
    double relativeError = 0.0;
};

/// A picture at one moment. Immutable and shared.
struct FilmSnapshot {
    uint64_t generation = 0;  ///< counts the edits that had been taken when it was made
    int width = 0;            ///< smaller than the film's while something moves
    int height = 0;
    int previewScale = 1;  ///< film pixels per snapshot pixel in each direction; 1: full resolution
    IntegratorKind integrator = IntegratorKind::PathTracing;
    uint32_t passes = 0;
    double renderSeconds = 0.0;     ///< time spent in passes since the last restart, resumed time included
    double relativeError = 0.0;     ///< of the whole picture, noise and bias (error_estimate.h)
    double relativeErrorLow = 0.0;  ///< 90 % band of relativeError
    double relativeErrorHigh = 0.0;
    std::vector<float> radiance;       ///< linear RGB, 3 per pixel
    std::vector<float> standardError;  ///< of the mean luminance, 1 per pixel; empty unless asked for
    /// SPPM: present radius; 0: no visible point yet. Empty unless asked for
    std::vector<float> radiusWorld;
    std::vector<float> photonCount;  ///< SPPM: photons kept so far (N). Empty unless asked for
    std::vector<float> bias;  ///< SPPM: estimate of the luminance's bias, signed. Empty unless asked for
    /// with 90 %, the true luminance is within +- this. Empty unless asked for
    std::vector<float> errorBound;
    /// of the snapshot's size; null unless asked for, and until the first is made
    std::shared_ptr<const AovFilm> aovs;
};

enum class SessionState {
    Empty,     ///< no scene yet
    Building,  ///< an edit is being built
    Rendering,
    Paused,    ///< by setPaused; after an edit only when every picture that is shown has a full pass
    Finished,  ///< a limit is reached, and the AOVs that were asked for are done
    Failed,    ///< no picture can be made: status.error says why. An edit or a restart tries again
};

struct SessionStatus {
    SessionState state = SessionState::Empty;
    IntegratorKind integrator = IntegratorKind::PathTracing;  ///< that is shown; all figures are its own
    uint32_t photonsPerPass = 0;  ///< SPPM: what the memory budget allows of what the scene asks for
    uint64_t generation = 0;
    uint32_t passes = 0;
    double renderSeconds = 0.0;
    double passesPerSecond = 0.0;
    double pathsPerSecond = 0.0;
    double raysPerSecond = 0.0;
    double relativeError = 0.0;     ///< of the newest snapshot or point of the convergence curve
    double relativeErrorLow = 0.0;  ///< 90 % band of relativeError
    double relativeErrorHigh = 0.0;
    std::array<uint64_t, kSampleFaultCount> faultCounts{};
    std::string backend;
    /// why the last edit was refused (the scene before it goes on), or why the state is Failed
    std::string error;
    int previewScale = 1;    ///< of the newest snapshot
    uint32_t aovPasses = 0;  ///< of kAovPasses, where AOVs were asked for
    size_t filmBytes = 0;
    MemoryUse memory;               ///< all that is allocated: scene, films, SPPM, the back end's own
    std::string kernel;             ///< the kernel variant in use
    double lastBuildSeconds = 0.0;  ///< of the last edit
    /// edits that have been answered by a picture: a new latency figure each time
    uint64_t imagesAfterEdits = 0;
    /// How often each part was rebuilt or cleared since the session began: what tests and the log read.
    struct Counters {
        uint64_t meshBuilds = 0;
        uint64_t topLevelBuilds = 0;
        uint64_t materialTables = 0;
        uint64_t textureTables = 0;
        uint64_t lightTables = 0;
        uint64_t featureScans = 0;
        uint64_t filmRestarts = 0;
        uint64_t filmAllocations = 0;
        uint64_t passesDiscarded = 0;
        uint64_t editsRefused = 0;
        uint64_t previewPasses = 0;
    } counters;
    /// Latency of the last edit, seconds: from post() to the stop of the pass in flight, and to the first
    /// new snapshot.
    double lastCancelSeconds = 0.0;
    double lastEditToImageSeconds = 0.0;
};

/// What is needed to go on exactly where a render stopped (io/checkpoint.h saves and loads it).
struct ResumePoint {
    Film film;
    SppmState sppm{};  ///< empty for path tracing
    double renderSeconds = 0.0;
    ConvergenceCurve curve{};
};

/// The film at one moment, exactly, with the description that made it.
struct SessionCapture {
    std::shared_ptr<const SceneDescription> scene;
    Film film{};
    SppmState sppm{};  ///< empty for path tracing
    AovFilm aovs{};
    double renderSeconds = 0.0;
    ConvergenceCurve curve{};
};

using SceneBuildFunction = std::function<Result<std::shared_ptr<const BuiltScene>>(
    const SceneEdit&, const BuiltScene* previous, int threads, const std::atomic<bool>* stop, BuildReport*)>;

struct SessionOptions {
    bool previews = true;     ///< low-resolution passes after edits; off for batch renders
    bool snapshots = true;    ///< off: snapshot() stays null
    bool lowPriority = true;  ///< render threads give way to the UI
    int threads = 0;          ///< for building, committing and snapshots; 0: all
    SceneBuildFunction build = buildScene;
};

class RenderSession {
  public:
    explicit RenderSession(std::unique_ptr<Backend> backend, SessionOptions options = {});
    /// Stops within one tile and joins.
    ~RenderSession();
    RenderSession(const RenderSession&) = delete;
    RenderSession& operator=(const RenderSession&) = delete;

    /// Takes the scene after an edit. The first edit must be EditKind::Everything.
    void post(SceneEdit edit);
    /// Like post() with EditKind::Everything, going on from a checkpoint instead of an empty film.
    void resume(std::shared_ptr<const SceneDescription> scene, ResumePoint from);

    void setLimits(const StopLimits& limits);
    void setPaused(bool paused);
    void restart();
    /// While true (a drag, a flight), passes after an edit run at low resolution so that the picture
    /// stays fluid. Full resolution follows at once when it turns false. Without an edit the picture
    /// keeps its resolution.
    void setInteracting(bool interacting);
    /// Bits of Aov, plus whether snapshots carry standard errors. Never restarts the film.
    void request(uint32_t aovs, bool standardError);

    /// Whether snapshots carry `bias` (SPPM only) and `errorBound`. Never restarts anything.
    void requestErrorMaps(bool wanted);
    /// Whether SPPM's snapshots carry radii and photon counts. Never restarts anything.
    void requestPhotonStatistics(bool wanted);
    /// While true both integrators render in turn, so that each had the same time. Never restarts anything.
    void setComparing(bool comparing);
    /// While comparing: the newest picture of the integrator that snapshot() does not show; null before the
    /// first of the present generation.
    std::shared_ptr<const FilmSnapshot> otherSnapshot() const;

    /// The newest picture of the current generation, or of the one before while there is none; null before
    /// the first.
    std::shared_ptr<const FilmSnapshot> snapshot() const;
    SessionStatus status() const;
    /// The error so far of the film that the integrator has, shown or not. Never null; empty until its second
    /// pass and after whatever restarts that film. Immutable: a longer one replaces it.
    std::shared_ptr<const ConvergenceCurve> convergenceCurve(IntegratorKind integrator) const;

    /// Blocks until the state is Finished, Failed or Paused with everything asked for so far taken into
    /// account, or `seconds` have passed; returns the state then.
    SessionState wait(double seconds);
    /// Copies the film exactly, as soon as the pass in flight and at least one pass are committed. Nothing:
    /// there is no scene, it failed, or the session ended. captureLater() returns at once; capture() blocks.
    using Capture = SessionCapture;
    std::future<std::optional<Capture>> captureLater();
    std::optional<Capture> capture();

    static constexpr uint32_t kAovPasses = 64;

  private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace glint
