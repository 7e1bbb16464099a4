// The program's commands. Each add…Command() describes one to the command line parser and runs it when it
// is chosen.
//
// Called by program.cpp. A command prints its result to standard output and its one error message to standard
// error, and answers with an exit code; nothing here calls exit().
#pragma once

#include "engine/base/result.h"

namespace CLI {
class App;
}

namespace glint {

enum ExitCode : int {
    kExitDone = 0,
    kExitBadInput = 1,       ///< the input or the options are wrong
    kExitFailed = 2,         ///< the run failed: disk full, no context, device lost
    kExitBeyondLimit = 3,    ///< done, and what was measured is beyond a limit that was asked for
    kExitInterrupted = 130,  ///< by Ctrl-C, after saving
};

/// Prints the command's one error message to standard error and gives back the exit code.
int reportError(const Error& error, int exitCode);

/// Each adds a subcommand to `app`; when the user chose it, *exitCode is set by running it.
void addViewCommand(CLI::App& app, int* exitCode);
void addRenderCommand(CLI::App& app, int* exitCode);
void addInfoCommand(CLI::App& app, int* exitCode);
void addConvergeCommand(CLI::App& app, int* exitCode);
void addConvertCommand(CLI::App& app, int* exitCode);
void addDiffCommand(CLI::App& app, int* exitCode);
void addStressCommand(CLI::App& app, int* exitCode);
void addBenchCommand(CLI::App& app, int* exitCode);

}  // namespace glint
