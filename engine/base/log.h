// The log: lines to standard error, and the most recent ones kept for the window's panel.
//
// Any thread may write. Not for a command's results, which go to standard output, nor for its one
// error message.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/core.h>

namespace glint {

enum class LogLevel : uint8_t { Debug, Info, Warning, Error };

struct LogLine {
    LogLevel level = LogLevel::Info;
    double seconds = 0.0;  ///< since the program began
    std::string text;      ///< without time and level
};

/// Adds the line that fmt makes of it, printable (console.h). Never throws: a line for which there is no
/// memory is lost.
void logMessage(LogLevel level, fmt::string_view format, fmt::format_args args) noexcept;

template <class... Args>
void logInfo(fmt::format_string<Args...> format, Args&&... args) {
    logMessage(LogLevel::Info, format, fmt::make_format_args(args...));
}
template <class... Args>
void logWarning(fmt::format_string<Args...> format, Args&&... args) {
    logMessage(LogLevel::Warning, format, fmt::make_format_args(args...));
}
template <class... Args>
void logError(fmt::format_string<Args...> format, Args&&... args) {
    logMessage(LogLevel::Error, format, fmt::make_format_args(args...));
}

/// The least level that reaches standard error; Warning at first. The ring keeps every level but Debug,
/// unless Debug is shown too.
void setLogLevel(LogLevel least);

/// The kept lines, oldest first, but only when there are more than `seen`, which is the count the caller got
/// last time and is updated. An empty answer: nothing new.
std::vector<LogLine> recentLogLines(uint64_t* seen);

constexpr int kLogLinesKept = 1000;

}  // namespace glint
