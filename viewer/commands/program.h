// The whole command line: which command, which options, which exit code. main() and tests call it.
#pragma once

#include <string>
#include <vector>

namespace glint {

/// `arguments` without the program's name. Returns the exit code (commands.h) and never throws.
int runProgram(std::vector<std::string> arguments);

}  // namespace glint
