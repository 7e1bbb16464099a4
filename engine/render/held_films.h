// The last films that edits made wrong, kept so that going back to a scene shows its film at once.
#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <optional>

#include "engine/render/integrator_state.h"
#include "engine/scene/scene.h"

namespace glint {

class HeldFilms {
  public:
    /// `mostBytes` of films in all; 0: none is held. The oldest goes first.
    explicit HeldFilms(size_t mostBytes) : mostBytes_(mostBytes) {}

    bool isEnabled() const { return mostBytes_ > 0; }
    void hold(IntegratorKind kind, FilmTake take, std::shared_ptr<const SceneDescription> scene,
              RenderedFilm film);
    /// The film of that take which is of this scene, as far as the integrator is concerned; it is no longer
    /// held. `byIdentity`: only where the scene is the very object, which costs nothing.
    std::optional<RenderedFilm> takeBack(IntegratorKind kind, FilmTake take,
                                         const std::shared_ptr<const SceneDescription>& scene,
                                         bool byIdentity);
    size_t bytes() const { return bytes_; }

  private:
    struct Held {
        IntegratorKind kind;
        FilmTake take;
        std::shared_ptr<const SceneDescription> scene;
        RenderedFilm film;
    };

    size_t mostBytes_;
    size_t bytes_ = 0;
    std::deque<Held> films_;  ///< the oldest first
};

}  // namespace glint
