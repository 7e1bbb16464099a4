// Runs the built program as a user would, and collects what it said.
#pragma once

#include <csignal>
#include <functional>
#include <string>
#include <vector>

namespace glint::test {

struct ProgramRun {
    int exitCode = -1;  ///< 128 + signal when it was killed
    std::string out;
    std::string err;
};

struct RunSetup {
    /// After it has appeared on standard error, the program gets a signal; empty: none.
    std::string signalAfter = {};
    int signal = SIGINT;
    bool signalsTwice = false;  ///< within some milliseconds, as who kills a process and its group does
    /// Called in the new process before it becomes the program: closes streams, sets limits.
    std::function<void()> before = {};
};

/// Runs GLINT_PROGRAM to its end, without a terminal.
ProgramRun runProgram(const std::vector<std::string>& arguments, const RunSetup& setup = {});

/// True when the program was built (the build without it skips these tests).
bool programExists();

}  // namespace glint::test
