// What a viewer's options ask to be saved at its end.
#pragma once

#include <string>

#include "engine/base/result.h"
#include "viewer/model/workspace.h"
#include "viewer/window/app.h"
#include "viewer/window/frame_stats.h"
#include "viewer/window/surface.h"

namespace glint {

/// A PNG of the whole window.
Status saveScreenshot(const Surface& surface, const std::string& path);

/// The window, the picture and the frame times. What cannot be written does not cost the rest: the first
/// error of all. Inputs of the run are never written, also those that came after its start.
Status saveViewOutputs(const ViewerOptions& options, const Surface& surface, const FrameStats& stats,
                       bool interrupted, Workspace* workspace);

}  // namespace glint
