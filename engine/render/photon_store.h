// The photons of one pass and the structures that find them: filled, sorted and read once a pass, its
// memory kept.
//
// Tracing threads claim blocks of slots and write into them alone; sorting puts the photons into an order
// that depends on their numbers only, never on the threads. 48 bytes a photon at the most: 32 for itself, 16
// while sorting.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <vector>

#include "engine/base/result.h"
#include "engine/kernels/photon_grid.h"
#include "engine/kernels/photon_tree.h"

namespace glint {

class PhotonStore {
  public:
    static constexpr uint32_t kBlockPhotons = 64;
    static constexpr uint32_t kMaxPhotons = kMaxStoredPhotons;
    static constexpr size_t kBytesPerPhoton = sizeof(Photon) + 2 * sizeof(uint64_t);

    /// Writes the photons of one chunk of traced ones; used by one thread. Photons beyond the store's room
    /// are counted and dropped: see overflowed().
    class Writer {
      public:
        void add(const Photon& photon);

      private:
        friend class PhotonStore;
        PhotonStore* store_ = nullptr;
        std::vector<uint32_t> blocks_;
        uint32_t usedInLast_ = kBlockPhotons;
    };

    /// Error: more photons than any store holds.
    static Status checkRoom(uint64_t photons);
    /// Places for so many photons, the blocks that `chunks` writers begin included.
    static uint64_t roomFor(size_t photons, size_t chunks) {
        return (photons + kBlockPhotons - 1) / kBlockPhotons * kBlockPhotons + chunks * kBlockPhotons;
    }

    /// Makes room for `photons` (whole blocks for each of `chunks` added) and forgets the last pass. All of
    /// it must pass checkRoom().
    void reset(size_t photons, size_t chunks);
    Writer& writer(size_t chunk) { return writers_[chunk]; }

    /// True when the pass stored more than there was room for; wanted() says how many, and the pass must be
    /// traced again.
    bool overflowed() const { return claimedBlocks_.load() > blockCapacity_; }
    size_t wanted() const { return static_cast<size_t>(claimedBlocks_.load()) * kBlockPhotons; }

    /// Sorts the photons along the Z-order curve of `space` and builds the tables of the levels in
    /// `levelsInUse` (bit l: level l). Photons outside `space` must not have been stored.
    void buildGrid(const GridSpace& space, uint32_t levelsInUse, int threads);
    /// Arranges the photons as a kd-tree.
    void buildTree(int threads);

    PhotonGridView grid() const;
    PhotonTreeView tree() const;
    size_t photonCount() const { return count_; }
    size_t bytes() const;

  private:
    /// Fills keys_ with the slots in use, in the order in which their photons were traced.
    void collectSlots();
    void addCellsToKeys(int threads);
    void sortKeys(int threads);
    void permutePhotons();
    void buildTable(int level);

    std::vector<Writer> writers_;
    std::vector<Photon> photons_;
    std::vector<uint64_t> keys_;  ///< Z-order index above the slot's 25 bits
    std::vector<uint64_t> keyScratch_;
    std::vector<uint8_t> axes_;
    std::array<std::vector<GridSlot>, kGridLevels> tables_;
    GridSpace space_;
    std::atomic<uint32_t> claimedBlocks_{0};
    uint32_t blockCapacity_ = 0;
    uint32_t count_ = 0;
};

}  // namespace glint
