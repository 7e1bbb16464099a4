#include "engine/render/held_films.h"

#include <utility>

#include "engine/scene/scene_diff.h"

namespace glint {
namespace {

/// Nothing that the integrator's film depends on differs.
bool isOfOneFilm(const SceneDescription& a, const SceneDescription& b, IntegratorKind kind) {
    const EditKind own = integratorType(kind).ownEdits();
    const EditKind ofOthers = without(allOwnEdits(), own) | EditKind::Integrator;
    return without(differences(a, b), ofOthers) == EditKind::None;
}

/// With what the scene has of its own: scenes share meshes and images.
size_t bytesOf(const RenderedFilm& film, const SceneDescription& scene) {
    return film.bytes() + sizeof(scene) +
           (scene.objects.size() + scene.hiddenObjects.size()) * sizeof(Object) +
           scene.materials.size() * sizeof(Material) + scene.lights.size() * sizeof(Light) +
           scene.textures.size() * sizeof(Texture) + scene.meshes.size() * sizeof(Mesh);
}

}  // namespace

void HeldFilms::hold(IntegratorKind kind, FilmTake take, std::shared_ptr<const SceneDescription> scene,
                     RenderedFilm film) {
    bytes_ += bytesOf(film, *scene);
    films_.push_back({kind, take, std::move(scene), std::move(film)});
    while (bytes_ > mostBytes_) {
        bytes_ -= bytesOf(films_.front().film, *films_.front().scene);
        films_.pop_front();
    }
}

std::optional<RenderedFilm> HeldFilms::takeBack(IntegratorKind kind, FilmTake take,
                                                const std::shared_ptr<const SceneDescription>& scene,
                                                bool byIdentity) {
    for (auto held = films_.rbegin(); held != films_.rend(); ++held) {
        if (held->kind != kind || held->take != take) { continue; }
        const bool isIt = held->scene == scene || (!byIdentity && isOfOneFilm(*held->scene, *scene, kind));
        if (!isIt) { continue; }
        RenderedFilm film = std::move(held->film);
        bytes_ -= bytesOf(film, *held->scene);
        films_.erase(std::next(held).base());
        return film;
    }
    return std::nullopt;
}

}  // namespace glint
