// Every picture of a session: those of each integrator in use, and the first-hit pictures that they share.
//
// One integrator is shown: the scene's own. Others render beside it while they are compared with it. What is
// in use is kept, so that switching loses nothing.
#pragma once

#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "engine/render/held_films.h"
#include "engine/render/integrator_state.h"
#include "engine/render/render_request.h"
#include "engine/render/session_status.h"
#include "engine/scene/scene_edit.h"

namespace glint {

/// The first-hit pictures of the film and of the preview of the integrator that is shown: they are of the
/// camera, not of an integrator.
struct AovImages {
    AovFilm film;
    AovFilm preview;
    std::shared_ptr<const AovFilm> shown;  ///< shared between snapshots until another pass is made

    void commit(AovFilm* to, const std::vector<AovSample>& samples, int width, int height, int threads);
    size_t bytes() const { return film.bytes() + preview.bytes(); }
};

class SessionImages {
  public:
    /// Without previews, passes have the film's size from the first on. Counts restarts of what is shown.
    /// Of films that edits empty, the last `heldFilmBytes` are kept.
    SessionImages(bool previews, size_t heldFilmBytes, SessionCounters* counters);

    bool hasScene() const { return scene_ != nullptr; }
    const std::shared_ptr<const SceneDescription>& scene() const { return scene_; }
    const Resolution& size() const { return scene_->resolution; }

    /// Takes the scene after an edit of these kinds: empties the films that it makes wrong, and begins anew
    /// with what is shown. All are emptied where the take is another one. Films that are held of this scene
    /// and take go on. Returns the integrators whose films were emptied.
    std::vector<IntegratorKind> takeScene(std::shared_ptr<const SceneDescription> scene, EditKind kinds,
                                          FilmTake take, const RenderRequest& request);
    /// Empties every film.
    std::vector<IntegratorKind> restart(const RenderRequest& request);
    /// Begins what the request adds to the one before, and drops what it no longer asks for.
    void takeRequest(const RenderRequest& request);

    /// The pictures answer this edit from now on.
    void takeTicket(EditTicket ticket) { ticketBefore_ = std::exchange(ticket_, ticket); }
    EditTicket ticket() const { return ticket_; }
    /// Of the edit before.
    EditTicket ticketBefore() const { return ticketBefore_; }

    IntegratorKind shownKind() const;
    IntegratorState& shown() { return of(shownKind()); }
    const IntegratorState& shown() const { return of(shownKind()); }
    IntegratorState& of(IntegratorKind kind) { return states_.at(kind); }
    const IntegratorState& of(IntegratorKind kind) const { return states_.at(kind); }
    /// Those that render beside the one that is shown, in the table's order.
    std::vector<IntegratorKind> compared(const RenderRequest& request) const;
    const std::map<IntegratorKind, IntegratorState>& all() const { return states_; }

    /// A coarser or finer preview of what is shown, from its first pass on.
    void startShownPreview(int scale);
    /// After a preview pass of what is shown: a finer one where there is time for it.
    void refinePreview(const RenderRequest& request);

    /// Of what is shown, as large as that is.
    const AovFilm& visibleAovs() const { return shown().isPreviewing() ? aovs.preview : aovs.film; }
    /// Adds all that is allocated for them.
    void addMemory(MemoryUse* use) const;
    size_t bytes() const;

    AovImages aovs;

  private:
    void use(const std::vector<IntegratorKind>& kinds);
    std::vector<IntegratorKind> empty(EditKind kinds, const std::shared_ptr<const SceneDescription>& before,
                                      const RenderRequest& request);
    void begin(const RenderRequest& request);
    void beginShown(const RenderRequest& request);
    void startPreviewBeside(IntegratorKind kind, const RenderRequest& request);
    int previewScaleNow(int present, const RenderRequest& request) const;

    bool hasPreviews_;
    SessionCounters* counters_;
    std::shared_ptr<const SceneDescription> scene_;
    FilmTake take_ = 0;
    HeldFilms held_;
    /// the films began within the drag that still goes on: they are nothing to go back to
    bool isOfDrag_ = false;
    /// References stay as others come into use. What is shown is always there.
    std::map<IntegratorKind, IntegratorState> states_;
    std::vector<IntegratorKind> comparedBefore_;
    EditTicket ticket_ = 0;
    EditTicket ticketBefore_ = 0;
};

}  // namespace glint
