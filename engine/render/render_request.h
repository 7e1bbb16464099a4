// What is wanted of a session beside its scene, as one value: the controlling thread changes its copy and
// hands it over whole.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/render/film_region.h"
#include "engine/scene/integrator_kind.h"

namespace glint {

/// When to stop by itself; 0: no such limit.
struct StopLimits {
    uint32_t passes = 0;
    double renderSeconds = 0.0;
    double relativeError = 0.0;

    bool operator==(const StopLimits&) const = default;
};

/// AOVs are complete after so many passes.
constexpr uint32_t kAovPasses = 64;

/// Holds until another one is asked for. None of it ever restarts a film.
struct RenderRequest {
    StopLimits limits{};
    bool paused = false;
    /// While true (a drag, a flight), passes after an edit run at low resolution so that the picture
    /// stays fluid. Full resolution follows at once when it turns false. Without an edit the picture
    /// keeps its resolution.
    bool interacting = false;
    uint32_t aovs = 0;             ///< bits of Aov that snapshots carry
    bool aovsEndWithFilm = false;  ///< they get no more passes than the film has
    bool standardError = false;    ///< snapshots carry FilmSnapshot::standardError
    bool errorMaps = false;        ///< snapshots carry `errorBound`, and `bias` where the integrator has one
    bool integratorMaps = false;   ///< snapshots carry the integrator's own maps, such as SPPM's radii
    /// These render in turn with the scene's own integrator (which may be among them), so that each had the
    /// same time.
    std::vector<IntegratorKind> compare{};

    /// Passes after a film's first one are of these pixels alone, by integrators without statistics of their
    /// own; the others go on with the whole picture. Errors are of the region, and curves wait.
    std::optional<FilmRegion> region{};

    bool operator==(const RenderRequest&) const = default;
};

}  // namespace glint
