// The desktop's own dialogs, as programs: zenity or kdialog.
#pragma once

#include <string>

namespace glint {

/// The shell's command that asks for a file to open or to save, beginning beside `path`, and prints its name;
/// "" where none of the programs is installed.
std::string desktopDialog(const std::string& title, const std::string& path, bool isForSaving);

/// What the command prints, without the line's end. Blocks.
std::string outputOf(const std::string& command);

}  // namespace glint
