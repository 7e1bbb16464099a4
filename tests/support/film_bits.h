// Films that must be the same to the last bit, of a scene and of the scene that saving and loading makes
// of it.
#pragma once

#include <string>

#include "engine/render/film.h"
#include "engine/scene/scene.h"

namespace glint::test {

/// By the CPU back end, without a session.
Film renderPasses(const SceneDescription& scene, uint32_t passes, int threads);

void expectSameBits(const Film& a, const Film& b);

/// Loads the file with missing parts allowed, saves it into another folder, loads that, and compares
/// the films.
void expectSameFilmWhenSaved(const std::string& path);

}  // namespace glint::test
