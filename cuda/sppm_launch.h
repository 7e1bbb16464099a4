// The launches of an SPPM pass, in their order. Plain data, host and device; all pointers are the device's.
//
// The threads of the camera and gather kernels do pixels in tiles (launch.h); a photon, a slot or a pixel is
// one thread elsewhere. sppm_launch.cuh and photon_steps.cu say what they do.
#pragma once

#include "cuda/launch.h"
#include "engine/kernels/photon_emission.h"
#include "engine/kernels/photon_grid.h"
#include "engine/kernels/sppm_view.h"

namespace glint {

/// Camera paths: their own light and their visible points.
struct CameraLaunch {
    SceneView view;
    SppmParams params;
    PixelSample* direct = nullptr;
    PassPixel* pixels = nullptr;
    uint32_t first = 0;
    uint32_t count = 0;
};

/// Where the visible points are, and which cell sizes they ask for: each thread takes every
/// `slices`-th pixel.
struct SpaceLaunch {
    SppmParams params;
    GridSpace space;  ///< for the levels
    const SppmPixel* statistics = nullptr;
    const PassPixel* pixels = nullptr;
    uint64_t pixelCount = 0;
    uint32_t slices = 0;
    Bounds* bounds = nullptr;    ///< one a slice
    uint32_t* levels = nullptr;  ///< one a slice
    uint32_t first = 0;
    uint32_t count = 0;
};

/// Room for the photons of a pass. Threads claim slots in no particular order; each photon's place in the
/// order of tracing is noted beside it.
struct PhotonSlots {
    Photon* photons = nullptr;
    uint64_t* places = nullptr;   ///< number in the pass << 32 | how many it had stored before
    uint32_t* stored = nullptr;   ///< how many each emitted photon stored
    uint64_t* claimed = nullptr;  ///< one counter; more than `capacity`: the pass has to be traced again
    uint32_t capacity = 0;
};

/// Emitted photons, by their number in the pass.
struct PhotonLaunch {
    SceneView view;
    PowerDistributionView power;
    SppmParams params;
    GridSpace space;
    PhotonSlots slots;
    uint32_t first = 0;
    uint32_t count = 0;
};

/// Enters the sort key of each stored photon at its place in the order of tracing.
struct KeyLaunch {
    GridSpace space;
    PhotonSlots slots;
    const uint32_t* storedBefore = nullptr;  ///< by all photons before, for each emitted one
    uint64_t* keys = nullptr;
    uint32_t first = 0;
    uint32_t count = 0;
};

/// Photons are put in order in place, 8 bytes of each at a time, through an array of 8 bytes a photon.
struct MoveLaunch {
    const uint64_t* keys = nullptr;
    Photon* photons = nullptr;
    uint64_t* parts = nullptr;
    uint32_t part = 0;
    uint32_t first = 0;
    uint32_t count = 0;
};
constexpr uint32_t kPhotonParts = sizeof(Photon) / sizeof(uint64_t);

/// The tables of the grid, from the sorted keys.
struct TableLaunch {
    const uint64_t* keys = nullptr;
    uint32_t photonCount = 0;
    uint32_t levelsInUse = 0;            ///< bit l: level l
    uint32_t* cellCounts = nullptr;      ///< one a level
    GridSlot* tables[kGridLevels] = {};  ///< of the levels in use
    uint32_t capacities[kGridLevels] = {};
    uint32_t first = 0;
    uint32_t count = 0;
};

struct GatherLaunch {
    SceneView view;
    SppmParams params;
    PhotonGridView photons;
    const SppmPixel* statistics = nullptr;
    PassPixel* pixels = nullptr;
    uint32_t first = 0;
    uint32_t count = 0;
};

/// Pixels, row-major.
struct UpdateLaunch {
    SppmParams params;
    const PassPixel* pixels = nullptr;
    SppmPixel* statistics = nullptr;
    uint32_t first = 0;
    uint32_t count = 0;
};

}  // namespace glint
