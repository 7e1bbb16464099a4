// What a batch render says at its end: a line for people, warnings, and the JSON report.
//
// Numbers come from the capture that was saved, so that they fit the picture.
#pragma once

#include <optional>

#include "engine/base/result.h"
#include "engine/render/render_session.h"
#include "viewer/commands/render_options.h"

namespace glint {

struct RenderReport {
    const RenderCommandOptions& options;
    const SessionCapture& capture;
    const SessionStatus& status;
    double loadSeconds;
    uint32_t photonsPerPass;  ///< SPPM: what the memory budget allows; 0 for path tracing
    float exposureStops;      ///< of a PNG
    std::optional<double> denoiseSeconds;
};

/// Prints, and writes JSON where options.json asks for it. Error: the JSON file cannot be written.
Status reportRender(const RenderReport& report);

}  // namespace glint
