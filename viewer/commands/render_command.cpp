// `glint render`: reads the options and the scene, refuses what cannot be written, and leaves the rest
// to render_run.
#include <chrono>

#include <fmt/format.h>

#include "engine/base/log.h"
#include "engine/io/image_formats.h"
#include "engine/render/checkpoint.h"
#include "engine/render/checkpoint_scene.h"
#include "viewer/base/numbered_files.h"
#include "viewer/base/run_files.h"
#include "viewer/commands/command_line.h"
#include "viewer/commands/commands.h"
#include "viewer/commands/render_frames.h"
#include "viewer/commands/render_run.h"

namespace glint {
namespace {

constexpr const char* kRenderFooter = R"(Examples:
  glint render scenes/cornell.json -o cornell.png --passes 256
  glint render scene.obj -o out.exr --time 60 --aov albedo,normal --checkpoint out.glintfilm
  glint render scene.obj -o out.exr --passes 4096 --resume out.glintfilm
  glint render scenes/sppm_glass_mesh.json -o out.png --passes 400 --checkpoint-every 50
Ctrl-C saves the picture and the checkpoint.)";

/// An old checkpoint is replaced where it is gone on from, or where this film is of the same scene and can
/// become as long. `scene` is null before it is known.
Status checkCheckpoint(const RenderCommandOptions& o, const SceneDescription* scene) {
    if (o.checkpoint.empty() || o.overwrite) { return {}; }
    const uint32_t most = finalLimits(o).passes;
    const Status replaces = checkReplacesCheckpoint(o.checkpoint, most > 0 ? most : UINT32_MAX, scene);
    return replaces
               ? replaces
               : Error{fmt::format("--checkpoint {}; expected another name, --resume to go on from it, or "
                                   "--overwrite",
                                   replaces.error().format()),
                       {}};
}

/// Beside the picture, or in its place.
NumberedFiles numberedPictures(const RenderCommandOptions& o) {
    if (frameCount(o) > 0) { return {.path = o.output, .last = frameCount(o)}; }
    const uint32_t every = parseSaveInterval(o.checkpointEvery).value().passes;
    // The last one has no number. Without a limit of passes, wrapping round leaves all.
    return {.path = o.output, .every = every, .last = every > 0 ? finalLimits(o).passes - 1 : 0};
}

Status checkOutputs(const RenderCommandOptions& o, RunFiles* files) {
    if (o.output.empty()) {
        return Error{"no picture is named; expected -o OUT.png, OUT.exr or OUT.hdr", {}};
    }
    const ImageFormat* format = savedFormatOf(o.output);
    if (format == nullptr) {
        return Error{
            isOnlyEnding(o.output)
                ? fmt::format("-o {}: expected a name before the ending", o.output)
                : fmt::format("-o {}: expected a name that ends in {}", o.output, listSavedExtensions()),
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
    files->reads("the scene", o.scene);
    files->reads("the OpenColorIO configuration", parseOcioChoice(o.ocio).config);
    // A checkpoint that is gone on from may become the longer one.
    if (!isSameFile(o.resume, o.checkpoint)) { files->reads("the checkpoint to go on from", o.resume); }
    if (frameCount(o) > 0) { return checkFrames(o, *files); }
    for (const std::string& output : {o.output, o.checkpoint, o.json}) {
        if (Status writable = files->writes(output); !writable) { return writable; }
    }
    if (interval->passes > 0) {
        const std::string first = numberedPath(o.output, interval->passes);
        if (Status writable = files->checkCanWrite(first); !writable) { return writable; }
    }
    return checkCheckpoint(o, nullptr);
}

/// As the command line has it. Where that gives no parameters and the scene is that of the checkpoint to go
/// on from, it is read as it was then.
LoadOptions loadOptions(const RenderCommandOptions& o) {
    if (o.resume.empty() || !o.load.parameters.empty()) { return o.load; }
    const Result<CheckpointInfo> info = readCheckpointInfo(o.resume);
    if (!info || info->scenePath != absolutePath(o.scene)) { return o.load; }
    LoadOptions load = o.load;
    load.allowMissing |= info->readWith.allowMissing;
    load.noStudio |= info->readWith.noStudio;
    load.parameters = info->readWith.parameters;
    for (const auto& [name, value] : load.parameters) {
        logInfo("-D {}={}, as {} has it", name, value, o.resume);
    }
    return load;
}

int runCommand(const RenderCommandOptions& options) {
    RunFiles files;
    if (options.pixel.empty()) {
        if (Status outputs = checkOutputs(options, &files); !outputs) {
            return reportError(outputs.error(), kExitBadInput);
        }
    }
    const auto began = std::chrono::steady_clock::now();
    Result<SceneDescription> loaded = openScene(options.scene, loadOptions(options));
    if (!loaded) { return reportError(loaded.error(), kExitBadInput); }
    const double loadSeconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    files.readsScene(*loaded);
    if (Status outputs = files.check(); !outputs) { return reportError(outputs.error(), kExitBadInput); }
    if (options.pixel.empty()) {
        const Status images = files.checkCanWrite(numberedPictures(options));
        if (!images) { return reportError(images.error(), kExitBadInput); }
    }
    if (Status applied = applyTo(options.overrides, &*loaded); !applied) {
        return reportError(applied.error(), kExitBadInput);
    }
    if (!options.pixel.empty()) { return runReplay(*loaded, options); }
    if (Status replaces = checkCheckpoint(options, &*loaded); !replaces) {
        return reportError(replaces.error(), kExitBadInput);
    }
    if (frameCount(options) > 0) { return runFrames(*loaded, options, loadSeconds); }
    return runRender(std::make_shared<SceneDescription>(std::move(*loaded)), options, loadSeconds).exitCode;
}

}  // namespace

void addRenderCommand(const Command& program) {
    const Command command = program.subcommand("render", "Renders a scene to a picture, without a window");
    const auto options = std::make_shared<RenderCommandOptions>();
    addRenderOptions(command, options.get());
    command.footer(kRenderFooter);
    command.onRun([command, options] {
        options->sceneOptions = sceneOptionsAsWritten(command);
        if (!options->ocio.empty()) {
            auto view = loadOcioView(parseOcioChoice(options->ocio));
            if (!view) { return reportError(view.error(), kExitBadInput); }
            options->view = std::move(*view);
        }
        return runCommand(*options);
    });
}

}  // namespace glint
