// A render that runs on its own thread while someone edits: the heart of the window, of `glint render` and of
// the tests.
//
// Everything public may be called from one controlling thread (the UI) and returns at once, unless it says
// otherwise. Edits and requests go into a command queue, coalesced; the render thread takes them between
// passes, or at once through the backend's stop flag. What comes back are immutable snapshots. Exceptions and
// errors end up in SessionStatus.
#pragma once

#include <functional>
#include <future>
#include <memory>
#include <optional>

#include "engine/builders/scene_builder.h"
#include "engine/render/backend.h"
#include "engine/render/convergence_curve.h"
#include "engine/render/film_snapshot.h"
#include "engine/render/render_request.h"
#include "engine/render/session_status.h"
#include "engine/scene/scene_edit.h"

namespace glint {

/// What is needed to go on exactly where a render stopped (checkpoint.h saves and loads it).
struct ResumePoint {
    Film film;
    std::unique_ptr<ImageStatistics> statistics{};  ///< null where the integrator has none
    double renderSeconds = 0.0;
    ConvergenceCurve curve{};
};

/// The film at one moment, exactly, with the description that made it.
struct SessionCapture {
    std::shared_ptr<const SceneDescription> scene;
    Film film{};
    std::shared_ptr<const ImageStatistics> statistics{};  ///< null where the integrator has none
    AovFilm aovs{};
    double renderSeconds = 0.0;
    ConvergenceCurve curve{};
};

using SceneBuildFunction = std::function<Result<std::shared_ptr<const BuiltScene>>(
    const SceneEdit&, const BuiltScene* previous, int threads, const std::atomic<bool>* stop, BuildReport*)>;

struct SessionOptions {
    bool previews = true;   ///< low-resolution passes after edits; off for batch renders
    bool snapshots = true;  ///< off: snapshot() stays null
    /// Where another scene has as many triangles to build, there is a first frame meanwhile (where previews
    /// and snapshots are asked for).
    size_t heavyTriangles = 200'000;
    bool lowPriority = true;   ///< render threads give way to the UI
    int threads = 0;           ///< for building, committing and snapshots; 0: all
    size_t heldFilmBytes = 0;  ///< of films that edits made wrong, for the way back; 0: none are kept
    SceneBuildFunction build = buildScene;
};

class RenderSession {
  public:
    explicit RenderSession(std::unique_ptr<Backend> backend, SessionOptions options = {});
    /// Stops within one tile and joins.
    ~RenderSession();
    RenderSession(const RenderSession&) = delete;
    RenderSession& operator=(const RenderSession&) = delete;

    /// Takes the scene after an edit. The first edit must be EditKind::Everything. Edits that wait are
    /// joined: the answer of one is the first status, or the first snapshot, with its ticket or a later one.
    /// Another take than that of the post before empties all films, and the films of a take that are still
    /// held go on where its scene is posted again.
    EditTicket post(SceneEdit edit, FilmTake take = 0);
    /// Like post() with EditKind::Everything, going on from a checkpoint instead of an empty film.
    EditTicket resume(std::shared_ptr<const SceneDescription> scene, ResumePoint from, FilmTake take = 0);
    /// Empties the films; none of them is held.
    EditTicket restart();
    /// What holds from now on. Costs nothing when it is the same as before.
    void request(const RenderRequest& request);

    /// The newest picture by the scene's own integrator, of the newest edit or of the one before while there
    /// is none; while a heavy scene is built, its first frame (first_frame.h); null before the first.
    std::shared_ptr<const FilmSnapshot> snapshot() const;
    /// The newest picture by this integrator: of the scene's own as above, of one that is compared with it
    /// null before the first of the newest edit, of any other null.
    std::shared_ptr<const FilmSnapshot> snapshot(IntegratorKind integrator) const;
    SessionStatus status() const;
    /// The scene that is rendered, as kernels see it; null before the first, and while a first frame
    /// is shown.
    std::shared_ptr<const BuiltScene> builtScene() const;
    /// The error so far of the film that the integrator has, shown or not. Never null; empty until its second
    /// pass and after whatever restarts that film. Immutable: a longer one replaces it.
    std::shared_ptr<const ConvergenceCurve> convergenceCurve(IntegratorKind integrator) const;

    /// Blocks until the state is Finished, Failed or Paused with everything asked for so far taken into
    /// account, or `seconds` have passed; returns the state then.
    SessionState wait(double seconds);
    /// Copies the film exactly, as soon as the pass in flight and at least one pass are committed, of the
    /// AOVs too where they were asked for. Nothing: there is no scene, it failed, or the session ended.
    /// captureLater() returns at once; capture() blocks.
    /// Throws std::bad_alloc (the future does) where there is no memory for the copy; the film stays.
    using Capture = SessionCapture;
    std::future<std::optional<Capture>> captureLater();
    std::optional<Capture> capture();

  private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace glint
