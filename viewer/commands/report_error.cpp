// The one form of a command's error message.
#include <fmt/format.h>

#include "viewer/commands/commands.h"

namespace glint {

int reportError(const Error& error, int exitCode) {
    fmt::print(stderr, "error: {}\n", error.format());
    return exitCode;
}

}  // namespace glint
