// `glint example NAME FOLDER`: writes a large scene of Glint's own.
#include <fmt/format.h>

#include "engine/base/console.h"
#include "engine/examples/example_scenes.h"
#include "viewer/commands/command_line.h"
#include "viewer/commands/commands.h"

namespace glint {
namespace {

struct ExampleOptions {
    std::string name, folder;
    double detail = 1.0;
    bool overwrite = false;
};

int runExample(const ExampleOptions& options) {
    const auto triangles = examples::writeExampleScene(*examples::findExampleScene(options.name),
                                                       options.detail, options.folder, options.overwrite);
    if (!triangles) { return reportError(triangles.error(), kExitBadInput); }
    putData(fmt::format("{}/scene.json: {} triangles\n", options.folder, *triangles));
    return kExitDone;
}

}  // namespace

void addExampleCommand(const Command& program) {
    const Command command =
        program.subcommand("example", "Writes a large scene of Glint's own, modelled by code");
    const auto options = std::make_shared<ExampleOptions>();
    std::vector<std::string> names;
    std::string footer;
    for (const examples::ExampleScene& scene : examples::exampleScenes()) {
        names.emplace_back(scene.name);
        footer += fmt::format("{}: {}\n", scene.name, scene.shows);
    }
    command.option("name", &options->name, "Which scene").required().oneOf(names);
    command.option("folder", &options->folder, "Where scene.json, its meshes and its images go")
        .required()
        .typeName("FOLDER");
    command.option("--detail", &options->detail, "Share of the triangles, about")
        .between(0.01, 10.0)
        .showDefault();
    command.flag("--overwrite", &options->overwrite, "Also into a folder with files in it");
    command.footer(footer);
    command.onRun([options] { return runExample(*options); });
}

}  // namespace glint
