// `glint schema`: prints what scenes/glint.schema.json holds.
#include "engine/base/console.h"
#include "engine/io/scene_schema.h"
#include "viewer/commands/command_line.h"
#include "viewer/commands/commands.h"

namespace glint {

void addSchemaCommand(const Command& program) {
    const Command command = program.subcommand("schema", "Prints the JSON schema of Glint's scene files");
    command.onRun([] {
        putData(sceneSchema());
        return static_cast<int>(kExitDone);
    });
}

}  // namespace glint
