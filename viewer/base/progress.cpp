// Each limit says when it will be reached; the first one counts.
#include "viewer/base/progress.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <unistd.h>

#include "engine/base/console.h"

namespace glint {
namespace {

constexpr int kBarWidth = 24;
/// Without a terminal: a line at every tenth, but no more often than this.
constexpr double kPlainInterval = 2.0;

/// A range that is narrower than this is one figure.
constexpr double kWideRange = 1.25;

void consider(double fraction, const ErrorForecast& ahead, Forecast* best) {
    if (best->secondsLeft < 0.0 || ahead.secondsLeft < best->secondsLeft) {
        *best = {std::clamp(fraction, 0.0, 1.0), std::max(0.0, ahead.secondsLeft),
                 std::max(0.0, ahead.secondsLow), std::max(0.0, ahead.secondsHigh)};
    }
}

void consider(double fraction, double seconds, Forecast* best) {
    consider(fraction, {.secondsLeft = seconds, .secondsLow = seconds, .secondsHigh = seconds}, best);
}

std::string describeError(const SessionStatus& status) {
    if (!std::isfinite(status.relativeError)) { return "?"; }
    return fmt::format("{:.2f} % ({:.2f} to {:.2f})", 100.0 * status.relativeError,
                       100.0 * status.relativeErrorLow, 100.0 * status.relativeErrorHigh);
}

std::string describe(const SessionStatus& status, const StopLimits& limits, const Forecast& ahead) {
    std::string passes = fmt::format("pass {}", status.passes);
    if (limits.passes > 0) { passes += fmt::format("/{}", limits.passes); }
    return fmt::format("{:3.0f} %  {}  {:.2f} Mpaths/s  error {}  left {}", 100.0 * ahead.fraction, passes,
                       status.pathsPerSecond * 1e-6, describeError(status), describeTimeLeft(ahead));
}

}  // namespace

Forecast forecast(const SessionStatus& status, const StopLimits& limits, const ConvergenceCurve& curve) {
    Forecast best;
    if (status.passes == 0 || status.passesPerSecond <= 0.0) { return best; }
    const double passes = status.passes;
    if (limits.passes > 0) {
        consider(passes / limits.passes, (limits.passes - passes) / status.passesPerSecond, &best);
    }
    if (limits.renderSeconds > 0.0) {
        consider(status.renderSeconds / limits.renderSeconds, limits.renderSeconds - status.renderSeconds,
                 &best);
    }
    if (const auto ahead = forecastError(curve, limits.relativeError)) {
        consider(status.renderSeconds / (status.renderSeconds + ahead->secondsLeft), *ahead, &best);
    }
    return best;
}

std::string formatSeconds(double seconds) {
    if (!(seconds >= 0.0) || seconds > 1e7) { return "?"; }
    const auto whole = static_cast<long>(std::lround(seconds));
    const long hours = whole / 3600, minutes = whole / 60 % 60;
    return hours > 0 ? fmt::format("{}:{:02}:{:02}", hours, minutes, whole % 60)
                     : fmt::format("{}:{:02}", minutes, whole % 60);
}

std::string describeTimeLeft(const Forecast& ahead) {
    const std::string low = formatSeconds(ahead.secondsLow);
    if (ahead.secondsHigh <= kWideRange * ahead.secondsLow || low == formatSeconds(ahead.secondsHigh)) {
        return formatSeconds(ahead.secondsLeft);
    }
    const std::string high = formatSeconds(ahead.secondsHigh);
    return high == "?" ? "more than " + low : low + " to " + high;
}

ProgressLine::ProgressLine() : terminal_(isatty(STDERR_FILENO) == 1) {}

void ProgressLine::update(const SessionStatus& status, const StopLimits& limits,
                          const ConvergenceCurve& curve) {
    const Forecast ahead = forecast(status, limits, curve);
    const std::string text = describe(status, limits, ahead);
    if (terminal_) {
        const int filled = static_cast<int>(std::lround(ahead.fraction * kBarWidth));
        sayOverLine(fmt::format("[{:#<{}}{:<{}}] {}", "", filled, "", kBarWidth - filled, text));
        drawn_ = true;
        return;
    }
    const bool tenth = std::floor(ahead.fraction * 10.0) > std::floor(lastFraction_ * 10.0);
    if (status.passes > 0 && tenth &&
        (lastFraction_ < 0.0 || status.renderSeconds - lastSeconds_ >= kPlainInterval)) {
        say("{}\n", text);
        lastFraction_ = ahead.fraction;
        lastSeconds_ = status.renderSeconds;
    }
}

void ProgressLine::finish() {
    if (drawn_) {
        say("\n");
        drawn_ = false;
    }
}

}  // namespace glint
