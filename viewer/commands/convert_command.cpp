// `glint convert IN OUT`: any readable scene as Glint's own JSON, or as another kind that Glint writes.
#include <fmt/format.h>

#include "engine/base/log.h"
#include "engine/io/exporter.h"
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
    const Exporter* exporter = exporterOf(options.out);
    if (exporter == nullptr) {
        return reportError({isOnlyEnding(options.out)
                                ? fmt::format("'{}': expected a name before the ending", options.out)
                                : fmt::format("'{}': expected the name of {}", options.out, listExporters()),
                            {}},
                           kExitBadInput);
    }
    RunFiles files;
    files.reads("the scene", options.in);
    if (Status writable = files.writes(options.out); !writable) {
        return reportError(writable.error(), kExitBadInput);
    }
    if (Status replaces = checkReplaces(options.out, exporter->isOwn, "written by Glint"); !replaces) {
        return reportError(replaces.error(), kExitBadInput);
    }
    const auto scene = openScene(options.in, options.load);
    if (!scene) { return reportError(scene.error(), kExitBadInput); }
    files.readsScene(*scene);
    if (Status checked = files.check(); !checked) { return reportError(checked.error(), kExitBadInput); }
    std::vector<std::string> warnings;
    if (Status saved = exporter->save(*scene, options.out, &warnings); !saved) {
        return reportError(saved.error(), kExitFailed);
    }
    for (const std::string& warning : warnings) {
        logWarning("{}: {}", options.out, warning);
    }
    return kExitDone;
}

}  // namespace

void addConvertCommand(const Command& program) {
    const Command command = program.subcommand(
        "convert", "Writes any readable scene as Glint's own JSON, as glTF, as Mitsuba XML or as pbrt-v4");
    const auto options = std::make_shared<ConvertOptions>();
    command.option("in", &options->in, "The scene to read").required().typeName("IN");
    command
        .option("out", &options->out, "The file to write, OUT.json, OUT.gltf, OUT.glb, OUT.xml or OUT.pbrt")
        .required()
        .typeName("OUT");
    addLoadOptions(command, &options->load);
    command.onRun([options] { return runConvert(*options); });
}

}  // namespace glint
