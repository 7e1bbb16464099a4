// What the program says to people, and its results: standard error and standard output.
//
// A full disk, a closed stream or a reader that went away must never end a render. Nothing here throws for
// them: what cannot be said is dropped, and a result that cannot be written is remembered until the end.
// Names that come from files may hold anything, so control characters never reach a terminal.
#pragma once

#include <string>
#include <string_view>

#include <fmt/core.h>

namespace glint {

/// With '?' for control characters, those of UTF-8 (C1) included, a blank for a tab, and `lineEnd` for a
/// line end.
std::string printable(std::string text, char lineEnd = '\n');

/// Writes to standard error, printable.
void sayText(std::string_view text);
/// Draws over the terminal's current line, which is standard error's; empty: erases it.
void sayOverLine(std::string_view text);
/// Writes to standard output, printable.
void putText(std::string_view text);
/// The same of data for other programs, byte for byte.
void putData(std::string_view bytes);

/// Flushes standard output. 0, or the errno of the first piece that could not be written there.
int finishOutput();

/// Standard streams that were closed are opened so that writing fails, and no file that is opened later gets
/// their numbers; files and pipes that cannot take more give errors instead of signals. To be called first.
void prepareStandardStreams();

/// sayText() of what fmt makes of it. Never throws: without memory it says that.
void sayFormatted(fmt::string_view format, fmt::format_args args) noexcept;

template <class... Args>
void say(fmt::format_string<Args...> format, Args&&... args) {
    sayFormatted(format, fmt::make_format_args(args...));
}
template <class... Args>
void put(fmt::format_string<Args...> format, Args&&... args) {
    putText(fmt::format(format, std::forward<Args>(args)...));
}

}  // namespace glint
