// A moving average over the last few passes: a camera that turns towards glass changes the cost within a
// few frames.
#include "engine/render/preview_scale.h"

#include <algorithm>
#include <cmath>

namespace glint {
namespace {

/// Before the first measurement: slow, so that the first picture of a heavy scene comes soon. It is refined
/// at once.
constexpr double kUnknownSecondsPerPath = 2e-5;

}  // namespace

void PreviewScale::measured(int64_t paths, double seconds) {
    if (paths <= 0 || seconds <= 0.0) { return; }
    const double now = seconds / static_cast<double>(paths);
    secondsPerPath_ = known() ? 0.5 * secondsPerPath_ + 0.5 * now : now;
}

int PreviewScale::choose(int width, int height, int present, double targetSeconds) const {
    const double perPath = known() ? secondsPerPath_ : kUnknownSecondsPerPath;
    const double affordable = std::max(1.0, targetSeconds / perPath);
    const double pixels = static_cast<double>(width) * static_cast<double>(height);
    const double exact = std::sqrt(pixels / affordable);
    if (exact <= 1.0) { return 1; }
    if (present > 1 && exact > 0.7 * present && exact < 1.2 * present) { return present; }
    return std::clamp(static_cast<int>(std::ceil(exact)), 2, kMaxScale);
}

}  // namespace glint
