// spdlog formats the lines for standard error; the ring is ours, since the panel wants levels and
// times apart.
#include "engine/base/log.h"

#include <atomic>
#include <chrono>
#include <deque>
#include <exception>
#include <mutex>

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include "engine/base/console.h"

namespace glint {
namespace {

using Clock = std::chrono::steady_clock;

struct Log {
    std::shared_ptr<spdlog::logger> console =
        std::make_shared<spdlog::logger>("glint", std::make_shared<spdlog::sinks::stderr_color_sink_mt>());
    Clock::time_point began = Clock::now();
    std::atomic<LogLevel> least{LogLevel::Warning};
    std::mutex mutex;
    std::deque<LogLine> lines;
    uint64_t count = 0;

    Log() {
        console->set_pattern("%^%l%$: %v");
        console->set_level(spdlog::level::trace);
        console->flush_on(spdlog::level::trace);
    }
};

Log& theLog() {
    // Never destroyed: another thread may still log while the program exits.
    static Log* log = new Log;
    return *log;
}

spdlog::level::level_enum consoleLevel(LogLevel level) {
    switch (level) {
        case LogLevel::Debug:
            return spdlog::level::debug;
        case LogLevel::Info:
            return spdlog::level::info;
        case LogLevel::Warning:
            return spdlog::level::warn;
        case LogLevel::Error:
            return spdlog::level::err;
    }
    return spdlog::level::info;
}

void addLine(LogLevel level, std::string text) {
    Log& log = theLog();
    const LogLevel least = log.least.load();
    if (level >= least) { log.console->log(consoleLevel(level), "{}", text); }
    if (level == LogLevel::Debug && least != LogLevel::Debug) { return; }
    const double seconds = std::chrono::duration<double>(Clock::now() - log.began).count();
    const std::lock_guard lock(log.mutex);
    log.lines.push_back({level, seconds, std::move(text)});
    if (log.lines.size() > kLogLinesKept) { log.lines.pop_front(); }
    ++log.count;
}

}  // namespace

void logMessage(LogLevel level, fmt::string_view format, fmt::format_args args) noexcept {
    try {
        addLine(level, printable(fmt::vformat(format, args)));
    } catch (const std::exception&) {
        if (level >= LogLevel::Warning) { say("there is not enough memory to say more\n"); }
    }
}

void setLogLevel(LogLevel least) { theLog().least = least; }

std::vector<LogLine> recentLogLines(uint64_t* seen) {
    Log& log = theLog();
    const std::lock_guard lock(log.mutex);
    if (*seen == log.count) { return {}; }
    *seen = log.count;
    return {log.lines.begin(), log.lines.end()};
}

}  // namespace glint
