#include "viewer/commands/measuring_program.h"

#include <algorithm>
#include <filesystem>
#include <string_view>

#include <unistd.h>

#include "engine/base/console.h"
#include "viewer/base/exit_code.h"

namespace glint {
namespace {

bool isMeasuring(char** argv) {
    for (char** word = argv + 1; *word != nullptr; ++word) {
        const std::string_view name(*word);
        if (!name.starts_with("-")) {
            return std::ranges::find(kMeasuringCommands, name, &MeasuringCommand::name) !=
                   std::end(kMeasuringCommands);
        }
    }
    return false;
}

}  // namespace

std::optional<int> runMeasuringCommand(char** argv) {
    if (!isMeasuring(argv)) { return std::nullopt; }
    std::error_code problem;
    const auto here = std::filesystem::read_symlink("/proc/self/exe", problem).parent_path();
    const std::string program = (here / "glint-measure").string();
    execv(program.c_str(), argv);
    say("error: {}: the program that measures is not there; build or install all of Glint\n", program);
    return kExitFailed;
}

}  // namespace glint
