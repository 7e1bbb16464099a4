// A film of a scene as a session hands it out, for tests of what is done with one.
#pragma once

#include <memory>
#include <utility>

#include "engine/render/render_session.h"

namespace glint::test {

inline SessionCapture captureOf(const SceneDescription& scene, Film film, double renderSeconds) {
    return {.scene = std::make_shared<SceneDescription>(scene),
            .film = std::move(film),
            .renderSeconds = renderSeconds};
}

}  // namespace glint::test
