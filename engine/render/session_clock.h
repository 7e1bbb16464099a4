// The clock that a session's latencies are measured by.
#pragma once

#include <chrono>

namespace glint {

using SessionClock = std::chrono::steady_clock;

inline double secondsBetween(SessionClock::time_point from, SessionClock::time_point to) {
    return std::chrono::duration<double>(to - from).count();
}
inline double secondsSince(SessionClock::time_point from) {
    return secondsBetween(from, SessionClock::now());
}

}  // namespace glint
