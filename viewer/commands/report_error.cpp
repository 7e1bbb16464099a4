// The one form of a command's error message.
#include "engine/base/console.h"
#include "viewer/commands/commands.h"

namespace glint {

int reportError(const Error& error, int exitCode) {
    say("error: {}\n", error.format());
    return exitCode;
}

}  // namespace glint
