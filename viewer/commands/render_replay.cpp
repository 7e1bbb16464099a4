// One path again, step by step: `glint render --pixel X,Y --pass N`.
#include <fmt/format.h>

#include "engine/base/console.h"
#include "engine/builders/scene_builder.h"
#include "engine/render/pass_params.h"
#include "engine/render/path_replay.h"
#include "viewer/commands/commands.h"
#include "viewer/commands/render_run.h"

namespace glint {

int runReplay(const SceneDescription& scene, const RenderCommandOptions& options) {
    const Result<Vec2i> pixel = parsePair(options.pixel, ',', "--pixel");
    if (!pixel) { return reportError(pixel.error(), kExitBadInput); }
    if (scene.options.integrator == IntegratorKind::Sppm) {
        return reportError(Error{"--pixel follows the path tracer's paths; add --integrator path", {}},
                           kExitBadInput);
    }
    const Resolution& size = scene.resolution;
    if (pixel->x < 0 || pixel->y < 0 || pixel->x >= size.width || pixel->y >= size.height) {
        return reportError(Error{fmt::format("--pixel {} lies outside the picture of {}x{} pixels",
                                             options.pixel, size.width, size.height),
                                 {}},
                           kExitBadInput);
    }
    const auto built = buildScene({std::make_shared<SceneDescription>(scene), EditKind::Everything}, nullptr,
                                  options.threads, nullptr, nullptr);
    if (!built) { return reportError(built.error(), kExitBadInput); }
    PassParams params = passParamsOf(scene);
    params.pass = options.replayPass.value_or(0);
    PathReplay replay = replayPath((*built)->view(), (*built)->features, params, pixel->x, pixel->y);
    for (PathEvent& event : replay.events) {
        event.position += (*built)->origin();
    }
    put("{}", formatPathLog(replay, params, pixel->x, pixel->y));
    return kExitDone;
}

}  // namespace glint
