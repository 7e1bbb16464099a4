// What a session says of itself: one value, copied out at any time.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "engine/kernels/pass.h"
#include "engine/render/film_snapshot.h"
#include "engine/render/memory_use.h"

namespace glint {

enum class SessionState {
    Empty,     ///< no scene yet
    Building,  ///< an edit is being built
    Rendering,
    Paused,    ///< as asked; after an edit only when every picture that is shown has a full pass
    Finished,  ///< a limit is reached, and the AOVs that were asked for are done
    Failed,    ///< no picture can be made: status.error says why. An edit or a restart tries again
};

/// How often each part was rebuilt or cleared since the session began: what tests and the log read.
struct SessionCounters {
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
};

struct SessionStatus {
    SessionState state = SessionState::Empty;
    IntegratorKind integrator = IntegratorKind::PathTracing;  ///< that is shown; all figures are its own
    EditTicket ticket = 0;         ///< of the newest edit that was taken: it was built, or refused
    EditTicket refusedTicket = 0;  ///< of the newest edit that was refused
    uint32_t passes = 0;
    double renderSeconds = 0.0;
    double passesPerSecond = 0.0;
    double pathsPerSecond = 0.0;
    double raysPerSecond = 0.0;
    double relativeError = 0.0;     ///< of the newest snapshot or point of the convergence curve
    double relativeErrorLow = 0.0;  ///< 90 % band of relativeError
    double relativeErrorHigh = 0.0;
    std::optional<FilmRegion> region{};  ///< that alone is rendered on, and that the errors are of
    std::array<uint64_t, kSampleFaultCount> faultCounts{};
    std::string backend;
    /// Why the last edit was refused (the scene before it goes on), or why the state is Failed.
    std::string error;
    int previewScale = 1;    ///< of the newest snapshot
    uint32_t aovPasses = 0;  ///< of kAovPasses, where AOVs were asked for
    size_t filmBytes = 0;
    MemoryUse memory;    ///< all that is allocated: scene, films, the integrators', the back end's own
    std::string kernel;  ///< the kernel variant in use
    double lastBuildSeconds = 0.0;  ///< of the last edit
    /// Edits that have been answered by a picture: a new latency figure each time.
    uint64_t imagesAfterEdits = 0;
    SessionCounters counters;
    /// Latency of the last edit, seconds: from post() to the stop of the pass in flight.
    double lastCancelSeconds = 0.0;
    double lastEditToImageSeconds = 0.0;  ///< from post() to the first new snapshot
};

}  // namespace glint
