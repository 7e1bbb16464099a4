// `glint view`: reads the options and the scene, and opens the window, or draws it in memory.
#include <cstdio>
#include <cstdlib>
#include <future>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "engine/io/file_path.h"
#include "engine/io/image_formats.h"
#include "engine/io/scene_loader.h"
#include "engine/render/checkpoint.h"
#include "viewer/base/make_backend.h"
#include "viewer/base/run_files.h"
#include "viewer/commands/command_line.h"
#include "viewer/commands/commands.h"
#include "viewer/commands/json_output.h"
#include "viewer/commands/scene_opening.h"
#if GLINT_HAS_VIEWER
#include "viewer/base/job_queue.h"
#include "viewer/window/app.h"
#endif

namespace glint {
namespace {

constexpr const char* kFooter = R"(Examples:
  glint view scenes/cornell.json
  glint view scenes/cornell.json --headless --size 1280x720 --passes 64 --screenshot window.png --output picture.png
  glint view scenes/cornell.json --headless --script drag.txt
The script language is described in viewer/window/README.md.)";

struct ViewCommandOptions {
    std::string scene;
    bool headless = false;
    std::string size = "1280x720";
    float scale = 0.0f;
    uint32_t passes = 0;
    std::string screenshot;
    std::string output;
    std::string script;
    std::string json;
    std::optional<float> recoverySeconds;
    std::string backend = "cpu";
    int threads = 0;
    bool noAutoExposure = false;
    std::string ocio;
    LoadOptions load;
};

#if GLINT_HAS_VIEWER

constexpr float kRecoverySeconds = 30.0f;
constexpr int kSmallestSide = 64;
constexpr int kLargestSide = 16384;

Result<Vec2i> parseSize(const std::string& text) {
    int width = 0;
    int height = 0;
    char rest = 0;
    const bool read = std::sscanf(text.c_str(), "%dx%d%c", &width, &height, &rest) == 2;
    if (!read || std::min(width, height) < kSmallestSide || std::max(width, height) > kLargestSide) {
        return Error{fmt::format("--size {}: expected WIDTHxHEIGHT, each from {} to {}", text, kSmallestSide,
                                 kLargestSide),
                     {}};
    }
    return Vec2i(width, height);
}

Status checkScreenshots(const std::vector<ScriptStatement>& script, const RunFiles& files) {
    for (const ScriptStatement& statement : script) {
        if (statement.verb != "screenshot") { continue; }
        const Status free = files.checkCanWrite(statement.words[0].text);
        if (!free) { return statement.errorAt(0, free.error().format()); }
    }
    return {};
}

Result<ViewerOptions> viewerOptions(const ViewCommandOptions& o, RunFiles* files) {
    ViewerOptions options;
    const auto size = parseSize(o.size);
    if (!size) { return size.error(); }
    if (!o.headless && (!o.screenshot.empty() || !o.output.empty())) {
        return Error{"--screenshot and --output need --headless", {}};
    }
    if (!o.screenshot.empty() && !hasExtension(o.screenshot, ".png")) {
        return Error{fmt::format("--screenshot {}: expected a name {}", o.screenshot,
                                 isOnlyEnding(o.screenshot) ? "before the ending" : "that ends in .png"),
                     {}};
    }
    for (const std::string& output : {o.screenshot, o.output, o.json}) {
        if (const Status writable = files->writes(output); !writable) { return writable.error(); }
    }
    if (!o.script.empty()) {
        auto script = loadScript(o.script);
        if (!script) { return script.error(); }
        if (const Status free = checkScreenshots(*script, *files); !free) { return free.error(); }
        options.script = std::move(*script);
    }
    options.headless = o.headless;
    options.anotherBackend = [name = o.backend, threads = o.threads] { return makeBackend(name, threads); };
    options.surface = {.width = size->x, .height = size->y, .contentScale = o.scale};
    options.passes = o.passes;
    options.noAutoExposure = o.noAutoExposure;
    if (!o.ocio.empty()) {
        auto view = loadOcioView(parseOcioChoice(o.ocio));
        if (!view) { return view.error(); }
        options.ocio = std::move(*view);
    }
    options.screenshot = o.screenshot;
    options.output = o.output;
    options.frameStats = o.json;
    options.recoverySeconds = o.recoverySeconds.value_or(o.headless ? 0.0f : kRecoverySeconds);
    return options;
}

bool hasDisplay() {
    const auto isSet = [](const char* name) {
        const char* value = std::getenv(name);
        return value != nullptr && *value != '\0';
    };
    return isSet("DISPLAY") || isSet("WAYLAND_DISPLAY");
}

int runCommand(const ViewCommandOptions& o) {
    RunFiles files;
    files.reads("the scene", o.scene);
    files.reads("the script", o.script);
    files.reads("the OpenColorIO configuration", parseOcioChoice(o.ocio).config);
    auto options = viewerOptions(o, &files);
    if (!options) { return reportError(options.error(), kExitBadInput); }
    auto backend = makeBackend(o.backend, o.threads);
    if (!backend) { return reportError(backend.error(), kExitBadInput); }
    std::optional<SceneDescription> scene;
    if (hasExtension(o.scene, ".glintfilm")) {
        const auto checkpoint = readCheckpointInfo(o.scene);
        if (!checkpoint) { return reportError(checkpoint.error(), kExitBadInput); }
        options->checkpoint = o.scene;
    } else if (!o.scene.empty()) {
        options->reading = {.path = o.scene, .options = o.load, .choices = readSceneChoices(o.scene)};
        auto loaded = loadScene(o.scene, o.load);
        if (!loaded) { return reportError(loaded.error(), kExitBadInput); }
        scene = std::move(*loaded);
        files.readsScene(*scene);
        if (const Status checked = files.check(); !checked) {
            return reportError(checked.error(), kExitBadInput);
        }
    } else if (o.headless && o.script.empty()) {
        return reportError(Error{"--headless needs a SCENE or a --script", {}}, kExitBadInput);
    }
    if (!o.headless && !hasDisplay()) {
        return reportError(
            Error{"there is no display (DISPLAY and WAYLAND_DISPLAY are not set); `glint view --headless` "
                  "draws the same window without one, and `glint render` only renders",
                  {}},
            kExitFailed);
    }
    bool scriptFailed = false;
    const Result<bool> done = runViewer(*options, std::move(*backend), std::move(scene), &scriptFailed);
    const int exitCode = done ? (*done ? kExitDone : kExitInterrupted)
                              : reportError(done.error(), scriptFailed ? kExitBadInput : kExitFailed);
    if (JobQueue::anyAbandoned()) {
        // A scene is still being loaded by a thread that nobody needs any more; it must not outlive
        // the statics.
        std::fflush(nullptr);
        std::_Exit(exitCode);
    }
    return exitCode;
}

#else

int runCommand(const ViewCommandOptions&) {
    return reportError(
        Error{"this build has no window (GLINT_VIEWER=OFF); `glint render` renders without one", {}},
        kExitFailed);
}

#endif

}  // namespace

void addViewCommand(const Command& program) {
    const Command command = program.subcommand("view", "Open a scene in the window and watch it converge");
    auto options = std::make_shared<ViewCommandOptions>();
    // The last one counts: `run` gives defaults before the user's own options.
    command.lastCounts();
    command.option("SCENE", &options->scene, "Scene to open, or a checkpoint to go on with");
    command.flag("--headless", &options->headless, "Draw the same window in memory, without a display");
    command.option("--size", &options->size, "Size of the window in pixels, as 1280x720");
    command.option("--scale", &options->scale, "Size of text and controls, 1 or 2; the screen's by default")
        .range(0.5, 4.0);
    command.option("--passes", &options->passes, "Stop after so many passes; headless 64 by default");
    command.option("--screenshot", &options->screenshot, "PNG of the whole window at the end (headless)");
    command.option("--output", &options->output,
                   "The picture at the end (headless): " + listSavedExtensions());
    command.option("--script", &options->script, "Play input from a file");
    command.option("--json", &options->json, "Frame times to a file, or - for standard output")
        .accepts(checkReportFile);
    command
        .option("--recovery", &options->recoverySeconds,
                "Seconds between two saves of the session, which the next start offers after a crash; 0: "
                "none; 30 with a window by default")
        .range(0.0, 86400.0);
    command.option("--backend", &options->backend, "cpu or cuda");
    command.option("--threads", &options->threads, "Threads that render; 0: all").range(0, 1024);
    command.flag("--no-auto-exposure", &options->noAutoExposure,
                 "Exposure 0 also where that shows a scene black or white");
    command
        .option("--ocio", &options->ocio,
                "A view of an OpenColorIO configuration in place of the tone map, by default its first")
        .typeName("CONFIG[:DISPLAY[/VIEW]]");
    addLoadOptions(command, &options->load);
    command.footer(kFooter);
    command.onRun([options] { return runCommand(*options); });
}

}  // namespace glint
