// The program's commands. Each add…Command() describes one to the command line parser and runs it when it
// is chosen.
//
// A command prints its result to standard output and its one error message to standard error, and answers
// with an exit code; nothing here calls exit().
#pragma once

#include "engine/base/result.h"
#include "viewer/base/exit_code.h"

namespace glint {

class Command;

/// Prints the command's one error message to standard error and gives back the exit code.
int reportError(const Error& error, int exitCode);

/// Each adds a command to the program, which runs when the user chose it.
void addViewCommand(const Command& program);
void addRenderCommand(const Command& program);
void addInfoCommand(const Command& program);
void addConvergeCommand(const Command& program);
void addConvertCommand(const Command& program);
void addSchemaCommand(const Command& program);
void addDiffCommand(const Command& program);
void addBesideCommand(const Command& program);
void addExampleCommand(const Command& program);

}  // namespace glint
