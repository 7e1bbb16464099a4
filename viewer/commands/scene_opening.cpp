#include "viewer/commands/scene_opening.h"

#include "engine/base/log.h"
#include "engine/io/scene_loader.h"
#include "viewer/commands/command_line.h"

namespace glint {

void addLoadOptions(const Command& command, LoadOptions* options) {
    command.flag("--allow-missing", &options->allowMissing,
                 "Go on without what is missing, and without what Glint cannot draw");
    command.flag("--strict", &options->strict,
                 "Refuse what is otherwise repaired or left out with a warning");
    command.flag("--no-studio", &options->noStudio,
                 "Models without light: a plain white environment instead of key light, fill and ground");
    command
        .optionEach(
            "-D,--define",
            [options](const std::string& text) -> Status {
                const size_t at = text.find('=');
                if (at == 0 || at == std::string::npos) {
                    return Error{"\"" + text + "\" is no parameter; expected NAME=VALUE", {}};
                }
                options->parameters.emplace_back(text.substr(0, at), text.substr(at + 1));
                return {};
            },
            "A value for a Mitsuba scene's $NAME, before its own default; of glTF, animation=NAME, "
            "time=SECONDS and variant=NAME")
        .oneValueEach()
        .typeName("NAME=VALUE");
}

Result<SceneDescription> openScene(const std::string& path, const LoadOptions& options) {
    Result<SceneDescription> scene = loadScene(path, options);
    if (!scene) { return scene; }
    for (const std::string& warning : scene->warnings) {
        logWarning("{}", warning);
    }
    for (const std::string& note : scene->notes) {
        logInfo("{}", note);
    }
    return scene;
}

}  // namespace glint
