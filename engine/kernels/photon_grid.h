// Where to look for photons near a point: cells of any power-of-two size over one sorted array. Host
// and device.
//
// Photons are sorted along a Z-order curve, so that the photons of a cell are contiguous at every cell size
// at once. A query picks the level whose cells are just larger than its diameter and visits at most eight
// of them: its cost does not depend on how much radii differ within a picture. One small hash table a
// level, built only for levels in use, finds a cell's range. The order of the visit is fixed, and so are
// sums over it.
#pragma once

#include "engine/base/view.h"
#include "engine/kernels/sppm_view.h"

namespace glint {

constexpr int kGridBitsPerAxis = 13;
constexpr int kGridLevels = kGridBitsPerAxis + 1;  ///< level l has cells of 2^l finest cells an axis

/// Maps the box around all visible points and their radii to cells. Photons outside cannot count for any.
struct GridSpace {
    Vec3 origin{0.0f};
    float finestCell = 1.0f;  ///< world units; > 0

    /// False outside the grid. `cell` are the finest level's coordinates.
    GLINT_HD bool locate(const Vec3& p, uint32_t cell[3]) const {
        const Vec3 q = (p - origin) / finestCell;
        constexpr float kCells = static_cast<float>(1 << kGridBitsPerAxis);
        if (!(q.x >= 0.0f && q.y >= 0.0f && q.z >= 0.0f && q.x < kCells && q.y < kCells && q.z < kCells)) {
            return false;
        }
        for (int axis = 0; axis < 3; ++axis) {
            cell[axis] = static_cast<uint32_t>(q[axis]);
        }
        return true;
    }

    /// The level that a query of this radius uses: the finest whose cells are at least its diameter wide, at
    /// most the coarsest.
    GLINT_HD int levelFor(float radiusWorld) const {
        int level = 0;
        float cell = finestCell;
        while (level < kGridLevels - 1 && cell < 2.0f * radiusWorld) {
            cell *= 2.0f;
            ++level;
        }
        return level;
    }
};

/// Spreads the low 13 bits of x to every third bit.
GLINT_HD inline uint64_t spreadBits(uint32_t x) {
    uint64_t v = x & 0x1fffu;
    v = (v | (v << 16)) & 0x0000ff0000ffULL;
    v = (v | (v << 8)) & 0x00f00f00f00fULL;
    v = (v | (v << 4)) & 0x0c30c30c30c3ULL;
    v = (v | (v << 2)) & 0x249249249249ULL;
    return v;
}

GLINT_HD inline uint64_t zOrder(uint32_t x, uint32_t y, uint32_t z) {
    return spreadBits(x) | (spreadBits(y) << 1) | (spreadBits(z) << 2);
}

/// What photons are sorted by: their finest cell's Z-order index above the 25 bits of their slot. A stable
/// sort from bit kPhotonSlotBits on leaves the photons of a cell in the order in which they came.
constexpr int kPhotonSlotBits = 25;
constexpr uint32_t kMaxStoredPhotons = 1u << kPhotonSlotBits;
constexpr int kPhotonKeyBits = kPhotonSlotBits + 3 * kGridBitsPerAxis;

/// Photons outside the grid must not have been stored: their cell is that of the origin.
GLINT_HD inline uint64_t photonSortKey(const GridSpace& space, const Photon& photon, uint32_t slot) {
    uint32_t cell[3] = {0, 0, 0};
    space.locate(photon.p, cell);
    return zOrder(cell[0], cell[1], cell[2]) << kPhotonSlotBits | slot;
}
GLINT_HD inline uint32_t slotOfKey(uint64_t key) {
    return static_cast<uint32_t>(key) & (kMaxStoredPhotons - 1);
}
/// Z-order index of the cell of `level` in which a photon lies.
GLINT_HD inline uint64_t cellOfKey(uint64_t key, int level) { return key >> kPhotonSlotBits >> (3 * level); }

/// A cell's photons are photons[begin, end). end 0: an empty slot of the table.
struct GridSlot {
    uint64_t cell = 0;  ///< Z-order index at the table's level
    uint32_t begin = 0;
    uint32_t end = 0;
};

/// Open addressing with linear probing; capacity is a power of two, or 0 for a level not in use.
struct GridTable {
    const GridSlot* slots = nullptr;
    uint32_t capacity = 0;
};

GLINT_HD inline uint32_t gridHash(uint64_t cell) {
    cell *= 0x9e3779b97f4a7c15ULL;  // Fibonacci hashing: the high bits mix best
    return static_cast<uint32_t>(cell >> 32);
}

/// Slots of a table for so many cells: less than half of them will be in use.
GLINT_HD inline uint32_t gridTableCapacity(uint32_t cells) {
    uint32_t capacity = 1;
    while (capacity < 2 * cells + 1) {
        capacity *= 2;
    }
    return capacity;
}

/// Tries one slot after the other, from the cell's own on, until accept(slot) is true: to find a cell and to
/// enter one.
template <class Accept>
GLINT_HD uint32_t probeGridTable(uint32_t capacity, uint64_t cell, Accept&& accept) {
    const uint32_t mask = capacity - 1;
    uint32_t slot = gridHash(cell) & mask;
    while (!accept(slot)) {
        slot = (slot + 1) & mask;
    }
    return slot;
}

struct PhotonGridView {
    GridSpace space;
    View<Photon> photons;  ///< in Z-order, ties in the order in which they were traced
    GridTable tables[kGridLevels];

    /// Calls visit(photon) for every photon within the cells that a sphere touches: a superset of those
    /// inside it.
    template <class Visit>
    GLINT_HD void visitNear(const Vec3& center, float radiusWorld, Visit&& visit) const {
        const float radius = radiusWorld * 1.0001f;  // rounding must not lose a photon at the rim of a cell
        const int level = space.levelFor(radiusWorld);
        const GridTable& table = tables[level];
        if (table.capacity == 0) { return; }
        const float cells = static_cast<float>(1 << (kGridBitsPerAxis - level));
        const float cellSize = std::ldexp(space.finestCell, level);
        const Vec3 lo = glm::clamp(glm::floor((center - radius - space.origin) / cellSize), Vec3(0.0f),
                                   Vec3(cells - 1.0f));
        const Vec3 hi = glm::clamp(glm::floor((center + radius - space.origin) / cellSize), Vec3(0.0f),
                                   Vec3(cells - 1.0f));
        for (uint32_t z = static_cast<uint32_t>(lo.z); z <= static_cast<uint32_t>(hi.z); ++z) {
            for (uint32_t y = static_cast<uint32_t>(lo.y); y <= static_cast<uint32_t>(hi.y); ++y) {
                for (uint32_t x = static_cast<uint32_t>(lo.x); x <= static_cast<uint32_t>(hi.x); ++x) {
                    visitCell(table, zOrder(x, y, z), visit);
                }
            }
        }
    }

  private:
    template <class Visit>
    GLINT_HD void visitCell(const GridTable& table, uint64_t cell, Visit&& visit) const {
        const GridSlot found = table.slots[probeGridTable(table.capacity, cell, [&](uint32_t slot) {
            return table.slots[slot].end == 0 || table.slots[slot].cell == cell;
        })];
        for (uint32_t i = found.begin; i < found.end; ++i) {
            visit(photons[i]);
        }
    }
};

}  // namespace glint
