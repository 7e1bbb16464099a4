// How many threads of a pass go into one launch: enough to fill the GPU, few enough that a stop flag is
// seen soon.
//
// Owned by the CUDA back end, which waits for one launch while the next one runs: a stop takes up to two
// of them.
#pragma once

#include <algorithm>
#include <cstdint>

namespace glint {

class ChunkPacer {
  public:
    uint32_t threads() const { return threads_; }

    /// Takes how long a launch of `threads` took, and aims at kTargetSeconds for the next one. A launch cut
    /// short by the end of the pass says little, unless even that took too long.
    void measured(uint32_t threads, double seconds) {
        if (threads < threads_ && seconds < kTargetSeconds) { return; }
        const double factor = std::clamp(kTargetSeconds / std::max(seconds, 1e-9), 0.25, 2.0);
        const double next = std::clamp(factor * threads, double{kLeast}, double{kMost});
        threads_ = static_cast<uint32_t>(next) / kLeast * kLeast;
    }

    static constexpr double kTargetSeconds = 0.003;
    static constexpr uint32_t kLeast = 1024;
    static constexpr uint32_t kMost = 1u << 24;

  private:
    uint32_t threads_ = 16 * kLeast;
};

}  // namespace glint
