// How coarse a preview has to be so that it is on screen within a frame: measures passes and answers with
// a scale.
#pragma once

#include <cstdint>

namespace glint {

class PreviewScale {
  public:
    /// A preview should take no longer than this, in seconds.
    static constexpr double kTargetSeconds = 0.014;
    static constexpr int kMaxScale = 32;

    /// Another scene: what was measured says nothing about it.
    void forget() { secondsPerPath_ = 0.0; }
    void measured(int64_t paths, double seconds);
    bool known() const { return secondsPerPath_ > 0.0; }

    /// Seconds that so many paths should take; 0 while nothing has been measured.
    double expectedSeconds(int64_t paths) const { return secondsPerPath_ * static_cast<double>(paths); }

    /// Film pixels per preview pixel in each direction; 1: a whole pass is quick enough. `present` (0: none)
    /// is kept when it is nearly right, so that the picture does not flicker between two sizes.
    int choose(int width, int height, int present, double targetSeconds = kTargetSeconds) const;

  private:
    double secondsPerPath_ = 0.0;
};

/// The preview's size: at least one pixel each way.
inline int previewSize(int full, int scale) { return (full + scale - 1) / scale; }

}  // namespace glint
