#include "viewer/commands/render_frames.h"

#include <memory>
#include <vector>

#include <fmt/format.h>

#include "engine/base/log.h"
#include "engine/builders/scene_builder.h"
#include "viewer/base/camera_bookmarks.h"
#include "viewer/base/camera_way.h"
#include "viewer/base/state_folder.h"
#include "viewer/commands/commands.h"
#include "viewer/commands/render_run.h"

namespace glint {
namespace {

std::vector<Camera> bookmarkedViews(const std::string& scene) {
    CameraBookmarks bookmarks;
    bookmarks.begin(stateFolder() + "/views");
    std::vector<Camera> views;
    for (const CameraBookmarks::Bookmark& each : bookmarks.of(scene)) {
        views.push_back(each.camera);
    }
    return views;
}

/// A scene that cannot be built is the first picture's error.
void warnOfObstacles(const CameraWay& way, const SceneDescription& scene, int threads) {
    const SceneEdit edit{std::make_shared<SceneDescription>(scene), EditKind::Everything};
    BuildReport report;
    const auto built = buildScene(edit, nullptr, threads, nullptr, &report);
    const std::string obstacles = built ? obstaclesOn(way, scene, **built) : "";
    if (!obstacles.empty()) { logWarning("in the way: {}", obstacles); }
}

}  // namespace

uint32_t frameCount(const RenderCommandOptions& o) { return o.turntable > 0 ? o.turntable : o.flight; }

Status checkFrames(const RenderCommandOptions& o, const RunFiles& files) {
    if (!o.checkpoint.empty() || !o.resume.empty() || !o.checkpointEvery.empty() || !o.json.empty()) {
        return Error{"--turntable and --flight write pictures alone; expected no checkpoint and no --json",
                     {}};
    }
    if (o.flight > 0 && bookmarkedViews(o.scene).size() < 2) {
        return Error{
            fmt::format(
                "--flight goes from bookmark to bookmark, and {} has fewer than two; expected some from "
                "glint view, Camera, Bookmark this view",
                o.scene),
            {}};
    }
    return files.checkCanWrite(numberedPath(o.output, 1));
}

int runFrames(const SceneDescription& scene, const RenderCommandOptions& options, double loadSeconds) {
    const uint32_t frames = frameCount(options);
    const CameraWay way = options.flight > 0 ? CameraWay::flight(bookmarkedViews(options.scene), frames)
                                             : CameraWay::turntable(scene.camera, frames);
    warnOfObstacles(way, scene, options.threads);
    RenderCommandOptions ofFrame = options;
    for (uint32_t frame = 0; frame < frames; ++frame) {
        auto moved = std::make_shared<SceneDescription>(scene);
        moved->camera = way.at(static_cast<float>(frame));
        ofFrame.output = numberedPath(options.output, frame + 1);
        const RenderOutcome outcome = runRender(std::move(moved), ofFrame, loadSeconds);
        if (outcome.exitCode != kExitDone) { return outcome.exitCode; }
        ofFrame.exposure = outcome.exposureStops;
    }
    return kExitDone;
}

}  // namespace glint
