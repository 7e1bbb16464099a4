// The --json option of commands: where the report goes, and how it is written. Keys are listed in
// README.md here.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "engine/base/result.h"

namespace glint {

class Command;

/// Adds `--json FILE` (`-`: standard output) to a command.
void addJsonOption(const Command& command, std::string* target);

/// Error: it cannot be written, or is an existing file that is not a report (the next argument may have been
/// taken for the option's own).
Status checkReportFile(const std::string& target);

/// Nothing to do for an empty target. `command` becomes the first key, "report", by which a report is known.
/// Numbers that JSON cannot hold (infinite, not a number) become null.
Status writeJson(const std::string& target, const std::string& command, const nlohmann::ordered_json& report);

/// True when the report takes standard output, so that nothing else may be printed there.
inline bool jsonTakesOutput(const std::string& target) { return target == "-"; }

}  // namespace glint
