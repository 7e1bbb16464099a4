// The commands that measure are in a program of their own, glint-measure, which lies beside this one: who
// wants a picture need not wait until they are built.
#pragma once

#include <optional>

namespace glint {

struct MeasuringCommand {
    const char* name;
    const char* about;
};
constexpr MeasuringCommand kStress{"stress", "Numerical stability on extreme scenes, as a table"};
constexpr MeasuringCommand kBench{"bench",
                                  "Measures speed: rays, paths, photon passes, latency, loading, threads, "
                                  "kernels, acceleration structures"};
constexpr MeasuringCommand kMeasuringCommands[] = {kStress, kBench};

/// Becomes glint-measure with the same arguments where the first that is no option names one of its commands.
/// Nothing: it does not. The exit code where that program does not start, which is said; so it is where that
/// is older than this one.
std::optional<int> runMeasuringCommand(char** argv);

}  // namespace glint
