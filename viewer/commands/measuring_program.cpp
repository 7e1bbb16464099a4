#include "viewer/commands/measuring_program.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string_view>

#include <unistd.h>

#include "engine/base/console.h"
#include "viewer/base/exit_code.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

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

/// False where one of them is not there.
bool isOlder(const fs::path& a, const fs::path& b) {
    std::error_code problemA, problemB;
    const auto ofA = fs::last_write_time(a, problemA), ofB = fs::last_write_time(b, problemB);
    return !problemA && !problemB && ofA < ofB;
}

}  // namespace

std::optional<int> runMeasuringCommand(char** argv) {
    if (!isMeasuring(argv)) { return std::nullopt; }
    std::error_code problem;
    const fs::path self = fs::read_symlink("/proc/self/exe", problem);
    const fs::path program = self.parent_path() / "glint-measure";
    if (!problem && isOlder(program, self)) {
        say("warning: {} is older than this program; build all of Glint\n", program.string());
    }
    if (!problem) { execv(program.c_str(), argv); }
    say("error: {}, the program that measures, does not start: {}; build or install all of Glint\n",
        program.string(), problem ? problem.message() : std::strerror(errno));
    return kExitFailed;
}

}  // namespace glint
