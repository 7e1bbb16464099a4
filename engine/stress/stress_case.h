// One row of the stability suite: an extreme scene or sum, its truth, and how the two are compared.
//
// Families (stress_<family>.cpp) make cases, stress_verdict.h judges what they measured, stress_suite.h runs
// them. Nothing here may know how a case measures.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/kernels/pass.h"

namespace glint {

/// How much a run of the suite may cost, and how it is given up.
struct StressEffort {
    bool quick = false;                       ///< a fraction of the samples: wider intervals, the same rule
    int threads = 0;                          ///< 0: all
    const std::atomic<bool>* stop = nullptr;  ///< raised: the running case ends with an error
    bool touchOnly = false;  ///< so few samples that verdicts mean nothing: for sanitizers, not for users

    /// `full` in a full run, a sixth of it, but at least `least`, in a quick one.
    uint32_t passes(uint32_t full, uint32_t least = 4) const;
    /// Steps of a sum: `full`, or `quickSteps` in a quick run.
    uint32_t steps(uint32_t full, uint32_t quickSteps) const;
    bool stopped() const { return stop != nullptr && stop->load(); }
};

/// A measured number, what it should be, and the standard error of their difference (0: no randomness).
/// `degrees`: that error comes from so many degrees of freedom; 0: from so many that it is normal.
struct StressValue {
    double measured = 0.0;
    double truth = 0.0;
    double standardError = 0.0;
    int degrees = 0;
};

/// What a case found: its values (usually the mean luminances of blocks of the picture) and samples dropped.
struct StressOutcome {
    std::vector<StressValue> values;
    std::array<uint64_t, kSampleFaultCount> faults{};  ///< by SampleFault
    uint64_t samples = 0;                              ///< all of them, dropped ones included

    uint64_t dropped() const;
    /// Adds another part of the same case.
    void join(const StressOutcome& other);
};

enum class StressVerdict : uint8_t { Ok, Degraded, Broken };

/// "ok", "degraded", "broken".
const char* stressVerdictName(StressVerdict verdict);

/// Half of the step between two values of an 8-bit picture near its middle: what nobody can see.
constexpr double kStressTolerance = 0.005;

struct StressCase {
    std::string family;   ///< "scale"
    std::string grade;    ///< "mesh x 1e-6": unique within its family
    std::string extreme;  ///< what is extreme, in words
    std::string truth;    ///< where the true values come from
    std::function<Result<StressOutcome>(const StressEffort&)> run;
    double tolerance = kStressTolerance;  ///< relative deviation beyond the interval that still is ok
    bool quick = true;                    ///< part of a quick run
    /// The worst verdict that is known and documented as a limit; Ok for all that float can do.
    StressVerdict documented = StressVerdict::Ok;
    std::string limit;  ///< why, where `documented` is not Ok
};

/// A case without its measurement.
StressCase namedCase(std::string family, std::string grade, std::string extreme, std::string truth,
                     double tolerance = kStressTolerance);

}  // namespace glint
