#include "viewer/window/view_outputs.h"

#include "engine/base/console.h"
#include "engine/io/atomic_file.h"
#include "engine/io/image_io.h"
#include "viewer/base/interrupt.h"

namespace glint {
namespace {

Status saveWindow(const ViewerOptions& options, const Surface& surface, const Workspace& workspace) {
    if (options.screenshot.empty()) { return {}; }
    // Scenes and references that came later may have it as an input.
    if (Status free = workspace.inputs.checkIsNoInput(options.screenshot); !free) { return free; }
    Status saved = saveScreenshot(surface, options.screenshot);
    if (saved) { say("the window is in {}\n", options.screenshot); }
    return saved;
}

Status saveImageFile(const ViewerOptions& options, bool interrupted, Workspace* workspace) {
    if (options.output.empty()) { return {}; }
    if (Status free = workspace->inputs.checkIsNoInput(options.output); !free) { return free; }
    if (interrupted) {
        workspace->render.request.paused = true;
        workspace->render.send();
        if (!announceInterruption(workspace->render.statusNow())) { return {}; }
    }
    Status saved = workspace->filmFiles.saveNow(options.output, workspace->display);
    if (saved) { say("the picture is in {}\n", options.output); }
    return saved;
}

Status saveFrameStats(const ViewerOptions& options, const FrameStats& stats, Workspace* workspace) {
    if (options.frameStats.empty()) { return {}; }
    if (Status free = workspace->inputs.checkIsNoInput(options.frameStats); !free) { return free; }
    const std::string report = stats.json(workspace->render.statusNow(), workspace->document.draft().camera);
    if (options.frameStats != "-") { return writeFileAtomically(options.frameStats, report); }
    putData(report);
    return {};
}

}  // namespace

Status saveScreenshot(const Surface& surface, const std::string& path) {
    const Vec2i size = surface.framebufferSize();
    return savePng(path, Image8{size.x, size.y, readSurface(surface)});
}

Status saveViewOutputs(const ViewerOptions& options, const Surface& surface, const FrameStats& stats,
                       bool interrupted, Workspace* workspace) {
    const Status window = saveWindow(options, surface, *workspace);
    const Status image = saveImageFile(options, interrupted, workspace);
    const Status times = saveFrameStats(options, stats, workspace);
    return !window ? window : !image ? image : times;
}

}  // namespace glint
