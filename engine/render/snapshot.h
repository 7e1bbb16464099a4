// Pictures of a film for displays: float copies, made in parallel.
#pragma once

#include <memory>

#include "engine/render/error_estimate.h"
#include "engine/render/render_session.h"

namespace glint {

struct SnapshotRequest {
    bool standardError = false;
    bool integratorMaps = false;
    bool errorMaps = false;  ///< the bound of 90 %, and the bias of SPPM
};

/// Everything of `film`, and of SPPM's statistics where there are any (may be null), with extras where asked
/// for; ticket, scale, seconds and AOVs are the caller's. A pixel without samples is black; a standard
/// error that is not known yet is infinite.
std::shared_ptr<FilmSnapshot> makeSnapshot(const Film& film, const ImageStatistics* statistics,
                                           const SnapshotRequest& request, int threads);

/// The same of a capture, with its integrator, seconds and error.
std::shared_ptr<FilmSnapshot> makeSnapshot(const SessionCapture& capture, const SnapshotRequest& request,
                                           int threads);

/// Its figures for the whole picture.
void setError(const ErrorEstimate& error, FilmSnapshot* snapshot);

}  // namespace glint
