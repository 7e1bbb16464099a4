// `glint render`: reads the options and the scene, refuses what cannot be written, and leaves the rest
// to render_run.
#include <chrono>

#include <fmt/format.h>

#include "engine/base/log.h"
#include "engine/io/image_formats.h"
#include "engine/io/scene_loader.h"
#include "viewer/commands/command_line.h"
#include "viewer/commands/commands.h"
#include "viewer/commands/output_files.h"
#include "viewer/commands/render_run.h"

namespace glint {
namespace {

constexpr const char* kFooter = R"(Examples:
  glint render scenes/cornell.json -o cornell.png --passes 256
  glint render scene.obj -o out.exr --time 60 --aov albedo,normal --checkpoint out.glintfilm
  glint render scene.obj -o out.exr --passes 4096 --resume out.glintfilm
  glint render scenes/sppm_glass_mesh.json -o out.png --passes 400 --checkpoint-every 50
Ctrl-C saves the picture and the checkpoint.)";

Status checkOutputs(const RenderCommandOptions& o) {
    if (o.output.empty()) {
        return Error{"no picture is named; expected -o OUT.png, OUT.exr or OUT.hdr", {}};
    }
    const ImageFormat* format = savedFormatOf(o.output);
    if (format == nullptr) {
        return Error{fmt::format("-o {}: expected a name that ends in {}", o.output, listSavedExtensions()),
                     {}};
    }
    if (!o.aovs.empty() && !format->hasLayers) {
        return Error{
            fmt::format("--aov needs a picture with layers; expected -o OUT.exr instead of {}", o.output),
            {}};
    }
    const Result<SaveInterval> interval = parseSaveInterval(o.checkpointEvery);
    if (!interval) { return interval.error(); }
    if (interval->seconds > 0.0 && o.checkpoint.empty()) {
        return Error{"--checkpoint-every with seconds needs --checkpoint FILE", {}};
    }
    if (o.replayPass) { return Error{"--pass needs --pixel X,Y: the path to look into", {}}; }
    const std::string numbered = interval->passes > 0 ? numberedPath(o.output, interval->passes) : "";
    return checkAllWritable({o.output, numbered, o.checkpoint, o.json == "-" ? std::string() : o.json});
}

int runCommand(const RenderCommandOptions& options) {
    if (options.pixel.empty()) {
        if (Status outputs = checkOutputs(options); !outputs) {
            return reportError(outputs.error(), kExitBadInput);
        }
    }
    const auto began = std::chrono::steady_clock::now();
    Result<SceneDescription> loaded = loadScene(options.scene, {.allowMissing = options.allowMissing});
    if (!loaded) { return reportError(loaded.error(), kExitBadInput); }
    const double loadSeconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    for (const std::string& warning : loaded->warnings) {
        logWarning("{}", warning);
    }
    if (Status applied = applyTo(options.overrides, &*loaded); !applied) {
        return reportError(applied.error(), kExitBadInput);
    }
    if (!options.pixel.empty()) { return runReplay(*loaded, options); }
    return runRender(std::make_shared<SceneDescription>(std::move(*loaded)), options, loadSeconds);
}

}  // namespace

void addRenderCommand(const Command& program) {
    const Command command = program.subcommand("render", "Renders a scene to a picture, without a window");
    const auto options = std::make_shared<RenderCommandOptions>();
    addRenderOptions(command, options.get());
    command.footer(kFooter);
    command.onRun([command, options] {
        options->sceneOptions = sceneOptionsAsWritten(command);
        return runCommand(*options);
    });
}

}  // namespace glint
