#include "engine/stress/stress_case.h"

#include <algorithm>
#include <numeric>

namespace glint {

uint32_t StressEffort::passes(uint32_t full, uint32_t least) const {
    if (touchOnly) { return std::min(full, 2u); }
    return quick ? std::min(full, std::max(least, full / 6)) : full;
}

uint32_t StressEffort::steps(uint32_t full, uint32_t quickSteps) const {
    if (touchOnly) { return std::min(full, 100u); }
    return quick ? quickSteps : full;
}

uint64_t StressOutcome::dropped() const { return std::accumulate(faults.begin(), faults.end(), uint64_t{0}); }

void StressOutcome::join(const StressOutcome& other) {
    values.insert(values.end(), other.values.begin(), other.values.end());
    for (size_t i = 0; i < faults.size(); ++i) {
        faults[i] += other.faults[i];
    }
    samples += other.samples;
}

const char* stressVerdictName(StressVerdict verdict) {
    switch (verdict) {
        case StressVerdict::Ok:
            return "ok";
        case StressVerdict::Degraded:
            return "degraded";
        case StressVerdict::Broken:
            break;
    }
    return "broken";
}

StressCase namedCase(std::string family, std::string grade, std::string extreme, std::string truth,
                     double tolerance) {
    StressCase c;
    c.family = std::move(family);
    c.grade = std::move(grade);
    c.extreme = std::move(extreme);
    c.truth = std::move(truth);
    c.tolerance = tolerance;
    return c;
}

}  // namespace glint
