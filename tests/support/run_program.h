// Runs the built program as a user would, and collects what it said.
#pragma once

#include <string>
#include <vector>

namespace glint::test {

struct ProgramRun {
    int exitCode = -1;  ///< 128 + signal when it was killed
    std::string out;
    std::string err;
};

/// Runs GLINT_PROGRAM to its end, without a terminal. After `interruptAfterLine` (when not empty) has
/// appeared on standard error, it gets one SIGINT.
ProgramRun runProgram(const std::vector<std::string>& arguments, const std::string& interruptAfterLine = {});

/// True when the program was built (the build without it skips these tests).
bool programExists();

}  // namespace glint::test
