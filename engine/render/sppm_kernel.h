// The SPPM loops that the CPU compiles, and the table of masks they are compiled for.
//
// Like cpu_kernel.h: each sppm_kernel_<name>.cpp holds the code of one mask. Only those
// include sppm_kernel_loops.h.
#pragma once

#include "engine/kernels/features.h"
#include "engine/kernels/photon_emission.h"
#include "engine/kernels/photon_grid.h"
#include "engine/kernels/photon_tree.h"
#include "engine/kernels/sppm_view.h"
#include "engine/render/cpu_variants.h"
#include "engine/render/photon_store.h"

namespace glint {

/// What a range of photons did; sums in luminance.
struct PhotonTotals {
    double emitted = 0.0;
    double escaped = 0.0;
    uint64_t rays = 0;
    uint64_t faulty = 0;
};

/// Which photons are worth storing: those in the box around all visible points.
struct PhotonRange {
    uint64_t first = 0;  ///< numbers over all passes
    uint64_t end = 0;
};

/// Camera paths of one tile: direct light into `image`, visible points into `pixels`; both row-major.
using TraceVisiblePoints = void (*)(const SceneView&, const SppmParams&, const PixelRect&, PixelSample* image,
                                    PassPixel* pixels);
/// Photons of one range: those inside `space` go to the writer.
using TracePhotons = PhotonTotals (*)(const SceneView&, const PowerDistributionView&, const SppmParams&,
                                      const PhotonRange&, const GridSpace& space,
                                      PhotonStore::Writer* writer);
/// Gathers for pixels [begin, end): replaces each visible point by what was found around it.
template <class PhotonMap>
using GatherPixels = void (*)(const SceneView&, const PhotonMap&, const SppmParams&,
                              const SppmPixel* statistics, size_t begin, size_t end, PassPixel* pixels);

struct SppmVariant {
    const char* name;
    FeatureMask mask;
    TraceVisiblePoints traceVisiblePoints;
    TracePhotons tracePhotons;
    GatherPixels<PhotonGridView> gatherFromGrid;
    GatherPixels<PhotonTreeView> gatherFromTree;
};

/// The loops compiled for kMask.
template <FeatureMask kMask>
SppmVariant sppmVariant(const char* name);

/// All variants from the smallest to the full one.
std::span<const SppmVariant> sppmVariants();

}  // namespace glint
