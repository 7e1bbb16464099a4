// Pictures of a film for displays: float copies, made in parallel.
#pragma once

#include <memory>

#include "engine/render/render_session.h"

namespace glint {

/// Everything of `film`, with standard errors where asked for; generation, scale, seconds and AOVs are the
/// caller's. A pixel without samples is black; a standard error that is not known yet is infinite.
std::shared_ptr<FilmSnapshot> makeSnapshot(const Film& film, bool standardError, int threads);

}  // namespace glint
