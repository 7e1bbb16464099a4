// fork, exec and two pipes; a shell in between would take the signal for itself.
#include "tests/support/run_program.h"

#include <array>

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

namespace glint::test {
namespace {

/// Reads what is there; false at the end.
bool drain(int file, std::string* text) {
    std::array<char, 4096> buffer{};
    const ssize_t count = read(file, buffer.data(), buffer.size());
    if (count > 0) { text->append(buffer.data(), static_cast<size_t>(count)); }
    return count > 0;
}

[[noreturn]] void becomeProgram(const std::vector<std::string>& arguments, const RunSetup& setup,
                                const int out[2], const int err[2]) {
    dup2(out[1], STDOUT_FILENO);
    dup2(err[1], STDERR_FILENO);
    for (const int file : {out[0], out[1], err[0], err[1]}) {
        close(file);
    }
    std::vector<char*> argv{const_cast<char*>(GLINT_PROGRAM)};
    for (const std::string& argument : arguments) {
        argv.push_back(const_cast<char*>(argument.c_str()));
    }
    argv.push_back(nullptr);
    if (setup.before) { setup.before(); }
    execv(GLINT_PROGRAM, argv.data());
    _exit(127);
}

}  // namespace

bool programExists() { return access(GLINT_PROGRAM, X_OK) == 0; }

ProgramRun runProgram(const std::vector<std::string>& arguments, const RunSetup& setup) {
    ProgramRun run;
    int out[2], err[2];
    if (pipe(out) != 0 || pipe(err) != 0) { return run; }
    const pid_t child = fork();
    if (child == 0) { becomeProgram(arguments, setup, out, err); }
    close(out[1]);
    close(err[1]);
    bool isSignalled = setup.signalAfter.empty();
    std::array<pollfd, 2> files{{{out[0], POLLIN, 0}, {err[0], POLLIN, 0}}};
    while (files[0].fd >= 0 || files[1].fd >= 0) {
        poll(files.data(), files.size(), -1);
        if (files[0].revents != 0 && !drain(out[0], &run.out)) { files[0].fd = -1; }
        if (files[1].revents != 0 && !drain(err[0], &run.err)) { files[1].fd = -1; }
        if (!isSignalled && run.err.find(setup.signalAfter) != std::string::npos) {
            kill(child, setup.signal);
            if (setup.signalsTwice) {
                usleep(20'000);
                kill(child, setup.signal);
            }
            isSignalled = true;
        }
    }
    close(out[0]);
    close(err[0]);
    int status = 0;
    waitpid(child, &status, 0);
    run.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return run;
}

}  // namespace glint::test
