// When a render is stopped to measure its error: at about logarithmically spaced seconds or passes.
//
// A pass is never cut, so two stops within one pass become one.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace glint {

/// Stops for a render of `seconds`: the first after its first pass, at t seconds, the i-th of n at
/// t (seconds / t)^((i - 1) / (n - 1)); and at `extra` seconds, which rise.
class SecondsSchedule {
  public:
    SecondsSchedule(double seconds, int points, std::vector<double> extra = {})
        : seconds_(seconds), points_(points), extra_(std::move(extra)) {}

    /// The next stop of a render that has had a pass and stands at `now` seconds; `firstPass` is where it
    /// stood after that pass. Nothing: the end is reached.
    std::optional<double> next(double firstPass, double now) const;

  private:
    double seconds_;
    int points_;
    std::vector<double> extra_;
};

/// Pass counts from 1 to `passes`, rounded from a geometric sequence of `points`, and `extra` ones,
/// each once.
std::vector<uint32_t> spacedPasses(uint32_t passes, int points, const std::vector<double>& extra = {});

/// `count` moments of a render of `whole` seconds or passes: the end, a tenth, a hundredth ..., rising.
std::vector<double> decadesOf(double whole, int count);

}  // namespace glint
