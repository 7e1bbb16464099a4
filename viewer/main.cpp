// The entry of both programs, glint and glint-measure. Everything else is in the folders beside.
//
// OpenMP's idle threads would spin for milliseconds after every pass, on the cores that the window needs to
// draw. Whether they do is read from the environment when the OpenMP library is loaded, before main() begins:
// so the program sets the variable and starts itself once more. A value that the user has set is left alone.
// It does so before the libraries' own initialisation, and holds signals back from there on. Until then,
// while the loader maps the libraries for the first time (1 to 3 ms; 10 to 15 ms with a cold cache or a busy
// machine), a Ctrl-C ends the program without an answer, as it ends any program that has not begun.
#include <algorithm>
#include <string_view>

#include <alloca.h>
#include <unistd.h>

#include "viewer/base/interrupt.h"
#include "viewer/commands/program.h"
#if GLINT_MEASURES
#include "viewer/bench/measuring.h"
#else
#include "viewer/commands/measuring_program.h"
#endif

namespace {

char kSleepingThreads[] = "OMP_WAIT_POLICY=passive";

/// Runs before anything is initialised: neither the heap nor getenv() may be used.
void restartWithSleepingThreads(int, char** argv, char** environment) {
    glint::holdSignals();
    const std::string_view name = std::string_view(kSleepingThreads).substr(0, sizeof "OMP_WAIT_POLICY=" - 1);
    size_t count = 0;
    for (; environment[count] != nullptr; ++count) {
        if (std::string_view(environment[count]).starts_with(name)) { return; }
    }
    auto** with = static_cast<char**>(alloca((count + 2) * sizeof(char*)));
    std::copy_n(environment, count + 1, with + 1);
    with[0] = kSleepingThreads;
    execve("/proc/self/exe", argv, with);
    // Where that fails, the program runs all the same, and merely shares the processor less well.
}

[[gnu::section(".preinit_array"), gnu::used]] void (*beforeAll)(int, char**,
                                                                char**) = restartWithSleepingThreads;

}  // namespace

int main(int argc, char** argv) {
#if GLINT_MEASURES
    return glint::runProgram({argv + 1, argv + argc}, glint::addMeasuringCommands);
#else
    if (const auto exitCode = glint::runMeasuringCommand(argv)) { return *exitCode; }
    return glint::runProgram({argv + 1, argv + argc}, glint::addProgramCommands);
#endif
}
