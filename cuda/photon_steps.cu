// The SPPM kernels that only move and count, the same for every feature mask.

#include <cstring>

#include "cuda/kernel_launch.cuh"
#include "cuda/shared_counter.cuh"
#include "cuda/sppm_variant.h"
#include "engine/kernels/sppm_pass_steps.h"

namespace glint {
namespace cuda_kernels {

struct FindBounds {
    static GLINT_HD void run(const SpaceLaunch& launch, uint32_t slice) {
        launch.bounds[slice] = searchBounds(launch.params, launch.statistics, launch.pixels,
                                            {slice, launch.pixelCount, launch.slices});
    }
};

struct FindLevels {
    static GLINT_HD void run(const SpaceLaunch& launch, uint32_t slice) {
        launch.levels[slice] = searchLevels(launch.params, launch.space, launch.statistics, launch.pixels,
                                            {slice, launch.pixelCount, launch.slices});
    }
};

struct MakeKeys {
    static GLINT_HD void run(const KeyLaunch& launch, uint32_t slot) {
        const uint64_t place = launch.slots.places[slot];
        const uint32_t rank = launch.storedBefore[place >> 32] + static_cast<uint32_t>(place & 0xffffffffu);
        launch.keys[rank] = photonSortKey(launch.space, launch.slots.photons[slot], slot);
    }
};

/// Part `part` of a photon in any array of them. Photons are read as bytes, which no type rule forbids.
GLINT_HD inline char* partOf(Photon* photons, uint32_t photon, uint32_t part) {
    return reinterpret_cast<char*>(photons + photon) + part * sizeof(uint64_t);
}

struct TakeParts {
    static GLINT_HD void run(const MoveLaunch& launch, uint32_t place) {
        const uint32_t slot = slotOfKey(launch.keys[place]);
        memcpy(&launch.parts[place], partOf(launch.photons, slot, launch.part), sizeof(uint64_t));
    }
};

struct PlaceParts {
    static GLINT_HD void run(const MoveLaunch& launch, uint32_t place) {
        memcpy(partOf(launch.photons, place, launch.part), &launch.parts[place], sizeof(uint64_t));
    }
};

/// Calls visit(level, cell) for each level in use at which photon `i` is the first of its cell, or the last.
template <class Visit>
GLINT_HD void forEachCellChange(const TableLaunch& launch, uint32_t i, bool first, Visit&& visit) {
    const bool border = first ? i == 0 : i + 1 == launch.photonCount;
    const uint64_t key = launch.keys[i];
    const uint64_t neighbour = border ? 0 : launch.keys[first ? i - 1 : i + 1];
    for (int level = 0; level < kGridLevels; ++level) {
        const uint64_t cell = cellOfKey(key, level);
        if ((launch.levelsInUse >> level & 1u) == 0) { continue; }
        if (!border && cellOfKey(neighbour, level) == cell) {
            return;  // and so at all coarser levels
        }
        visit(level, cell);
    }
}

struct CountCells {
    static GLINT_HD void run(const TableLaunch& launch, uint32_t i) {
        forEachCellChange(launch, i, true,
                          [&](int level, uint64_t) { takeNumber(&launch.cellCounts[level]); });
    }
};

struct EnterCells {
    static GLINT_HD void run(const TableLaunch& launch, uint32_t i) {
        forEachCellChange(launch, i, true, [&](int level, uint64_t cell) {
            GridSlot* table = launch.tables[level];
            const uint32_t slot = probeGridTable(launch.capacities[level], cell, [&](uint32_t candidate) {
                return claimZero(&table[candidate].end, i + 1);
            });
            table[slot].cell = cell;
            table[slot].begin = i;
        });
    }
};

struct CloseCells {
    static GLINT_HD void run(const TableLaunch& launch, uint32_t i) {
        forEachCellChange(launch, i, false, [&](int level, uint64_t cell) {
            GridSlot* table = launch.tables[level];
            const uint32_t slot = probeGridTable(launch.capacities[level], cell, [&](uint32_t candidate) {
                return table[candidate].cell == cell;
            });
            table[slot].end = i + 1;
        });
    }
};

struct Update {
    static GLINT_HD void run(const UpdateLaunch& launch, uint32_t pixel) {
        commitPixel(launch.params, launch.pixels[pixel].gathered, &launch.statistics[pixel]);
    }
};

}  // namespace cuda_kernels

using namespace cuda_kernels;

const PhotonSteps kPhotonSteps = {
    makeKernel<FindBounds, SpaceLaunch>("bounds"),
    makeKernel<FindLevels, SpaceLaunch>("levels"),
    makeKernel<MakeKeys, KeyLaunch>("keys"),
    makeKernel<TakeParts, MoveLaunch>("take"),
    makeKernel<PlaceParts, MoveLaunch>("place"),
    makeKernel<CountCells, TableLaunch>("count cells"),
    makeKernel<EnterCells, TableLaunch>("enter cells"),
    makeKernel<CloseCells, TableLaunch>("close cells"),
    makeKernel<Update, UpdateLaunch>("update"),
};

}  // namespace glint
