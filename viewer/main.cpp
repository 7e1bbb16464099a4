// The program's entry. Everything else is in commands/ and window/.
//
// OpenMP's idle threads would spin for milliseconds after every pass, on the cores that the window needs to
// draw. Whether they do is read from the environment when the OpenMP library is loaded, before main() begins:
// so the program sets the variable and starts itself once more, which takes about a millisecond. A value that
// the user has set is left alone.
#include <cstdlib>

#include <unistd.h>

#include "viewer/commands/program.h"

namespace {

constexpr const char* kWaitPolicy = "OMP_WAIT_POLICY";

void restartWithSleepingThreads(char** argv) {
    if (std::getenv(kWaitPolicy) == nullptr && setenv(kWaitPolicy, "passive", 0) == 0) {
        execv("/proc/self/exe", argv);
        // Where that fails, the program runs all the same, and merely shares the processor less well.
    }
}

}  // namespace

int main(int argc, char** argv) {
    restartWithSleepingThreads(argv);
    return glint::runProgram({argv + 1, argv + argc});
}
