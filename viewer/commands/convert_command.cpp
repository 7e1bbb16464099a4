// `glint convert IN OUT.json`: any readable scene as Glint's own JSON.
#include <fmt/format.h>

#include "engine/base/log.h"
#include "engine/io/file_path.h"
#include "engine/io/scene_json.h"
#include "viewer/base/run_files.h"
#include "viewer/commands/command_line.h"
#include "viewer/commands/commands.h"
#include "viewer/commands/scene_opening.h"

namespace glint {
namespace {

struct ConvertOptions {
    std::string in, out;
    LoadOptions load;
};

int runConvert(const ConvertOptions& options) {
    if (!hasExtension(options.out, ".json")) {
        return reportError({fmt::format("'{}': expected a name that ends in .json", options.out), {}},
                           kExitBadInput);
    }
    RunFiles files;
    files.reads("the scene", options.in);
    if (Status writable = files.writes(options.out); !writable) {
        return reportError(writable.error(), kExitBadInput);
    }
    const auto scene = openScene(options.in, options.load);
    if (!scene) { return reportError(scene.error(), kExitBadInput); }
    files.readsScene(*scene);
    if (Status checked = files.check(); !checked) { return reportError(checked.error(), kExitBadInput); }
    if (Status saved = saveSceneJson(*scene, options.out); !saved) {
        return reportError(saved.error(), kExitFailed);
    }
    return kExitDone;
}

}  // namespace

void addConvertCommand(const Command& program) {
    const Command command = program.subcommand("convert", "Writes any readable scene as Glint's own JSON");
    const auto options = std::make_shared<ConvertOptions>();
    command.option("in", &options->in, "The scene to read").required().typeName("IN");
    command.option("out", &options->out, "The file to write, OUT.json").required().typeName("OUT");
    addLoadOptions(command, &options->load);
    command.onRun([options] { return runConvert(*options); });
}

}  // namespace glint
