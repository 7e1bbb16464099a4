// One SPPM pass on the CPU: camera paths, photons, sorting, gathering, update. Owned by the CPU backend.
//
// Each stage is a parallel loop whose result does not depend on the number of threads. The statistics change
// in the last stage only, so that a pass that is stopped before leaves them as they were.
#pragma once

#include <atomic>
#include <vector>

#include "engine/base/result.h"
#include "engine/render/photon_store.h"
#include "engine/render/sppm_kernel.h"
#include "engine/render/sppm_state.h"

namespace glint {

/// Seconds and counts of one pass, for the panel and for benchmarks.
struct SppmPassStats {
    double cameraSeconds = 0.0;
    double photonSeconds = 0.0;
    double sortSeconds = 0.0;
    double gatherSeconds = 0.0;
    uint64_t storedPhotons = 0;
    size_t photonBytes = 0;  ///< what the store has allocated
    PhotonTotals photons;
};

class CpuSppm {
  public:
    explicit CpuSppm(int threads) : threads_(threads) {}

    /// Renders params.pass.pass. `direct` gets what camera paths found by themselves, one sample a pixel;
    /// `state` must have the pass's resolution and params.pass.pass passes. False: stopped, and nothing but
    /// `direct` has changed. Error: not enough memory, or more photons than a store holds.
    Result<bool> renderPass(const SceneView& view, FeatureMask features, const PowerDistributionView& power,
                            const SppmParams& params, const std::atomic<bool>& stop, SppmState* state,
                            std::vector<PixelSample>* direct);

    const SppmPassStats& stats() const { return stats_; }
    size_t visiblePointBytes() const { return pixels_.capacity() * sizeof(PassPixel); }
    size_t photonBytes() const { return photons_.bytes(); }

  private:
    struct Job;

    bool traceCamera(const Job& job, std::vector<PixelSample>* direct);
    GridSpace findSpace(const Job& job, uint32_t* levelsInUse) const;
    Result<bool> tracePhotons(const Job& job, const GridSpace& space);
    bool gather(const Job& job);
    void update(const Job& job);

    int threads_;
    std::vector<PassPixel> pixels_;
    PhotonStore photons_;
    size_t photonRoom_ = 0;
    SppmPassStats stats_;
};

}  // namespace glint
