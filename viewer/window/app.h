// The viewer as a whole: a surface, the workspace, the shell, and the loop that joins them.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/render/backend.h"
#include "engine/scene/scene.h"
#include "viewer/model/frame_series.h"
#include "viewer/model/scene_files.h"
#include "viewer/window/script.h"
#include "viewer/window/surface.h"

namespace glint {

struct ViewerOptions {
    bool headless = false;
    BackendMaker anotherBackend;  ///< of the same kind, for renders beside the live one
    SurfaceOptions surface;
    uint32_t passes = 0;  ///< stop limit; headless without a script: how many to wait for, 0: 64
    bool noAutoExposure = false;
    std::shared_ptr<const OcioView> ocio;  ///< in place of the tone map; null: none
    std::string screenshot;                ///< headless: PNG of the whole window at the end
    std::string output;                    ///< headless: the picture alone, .png, .exr or .hdr
    std::optional<std::vector<ScriptStatement>> script;
    std::string checkpoint;  ///< to be resumed with its scene
    SceneReading reading;    ///< of the scene
    /// between two saves for a recovery after a crash; 0: none, nor is one offered
    double recoverySeconds = 0.0;
    std::string frameStats;  ///< JSON file of frame times, "-": standard output; draws every frame for them
    /// takes FrameTimes::uiMs of each frame; draws every frame for them
    std::vector<double>* uiSeconds = nullptr;
};

/// Runs until the window is closed, or headless until the passes or the script are done. False: until the
/// user interrupted (interrupt.h); what the options name is saved all the same. Error: no context, a shader
/// that fails, a file that cannot be written, or a script that failed; `scriptFailed` tells the last from
/// the others.
Result<bool> runViewer(const ViewerOptions& options, std::unique_ptr<Backend> backend,
                       std::optional<SceneDescription> scene, bool* scriptFailed);

}  // namespace glint
