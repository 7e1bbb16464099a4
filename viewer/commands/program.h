// The whole command line: which command, which options, which exit code. main() and tests call it.
#pragma once

#include <string>
#include <vector>

namespace glint {

class Command;

/// `arguments` without the program's name, of a program with these commands. Returns the exit code
/// (base/exit_code.h) and never throws.
int runProgram(std::vector<std::string> arguments, void (*addCommands)(const Command& program));

/// All commands of `glint`; those that measure only by name (measuring_program.h).
void addProgramCommands(const Command& program);

}  // namespace glint
