// The photons of one pass in device memory and the grid that finds them: what render/photon_store.h is on
// the CPU.
//
// Owned by the CUDA back end's SPPM. 48 bytes a stored photon, as on the CPU, 4 for each emitted one, and the
// tables of the cell sizes in use. The order of the photons depends on their numbers only: slots are claimed
// in any order, then ranked by their place in the order of tracing, then sorted stably by cell.
#pragma once

#include <array>

#include "cuda/device_buffer.h"
#include "cuda/sppm_launch.h"
#include "engine/base/result.h"

namespace glint {

class DevicePhotons {
  public:
    /// The device must outlive the photons.
    explicit DevicePhotons(Device& device) : device_(&device) {}

    /// What it holds once there is room for so many emitted and stored photons, tables aside.
    Result<size_t> bytesWith(uint32_t emitted, uint32_t room) const;
    /// Makes the room; never less than there is. Error: the device has not enough memory.
    Status reserve(uint32_t emitted, uint32_t room);
    uint32_t room() const { return static_cast<uint32_t>(photons_.bytes() / sizeof(Photon)); }

    /// Forgets the last pass and answers where the next one stores.
    Result<PhotonSlots> reset();
    /// How many photons the pass wanted to store: more than the room when it has to be traced again.
    Result<uint64_t> wanted();

    /// Sorts the `count` photons that `emitted` ones stored along the Z-order curve of `space` and builds the
    /// tables of the levels in `levelsInUse` (bit l: level l). Error: not enough memory for the tables.
    Status build(const GridSpace& space, uint32_t levelsInUse, uint32_t emitted, uint32_t count);
    /// Device pointers, valid until the next change.
    const PhotonGridView& grid() const { return grid_; }

    size_t bytes() const;

  private:
    struct Sorted {
        const uint64_t* keys;
        uint64_t* free;  ///< as many places, not needed any more
    };

    Result<Sorted> sortKeys(const GridSpace& space, uint32_t emitted, uint32_t count);
    Status movePhotons(const Sorted& sorted, uint32_t count);
    Status buildTables(const uint64_t* keys, uint32_t levelsInUse, uint32_t count);
    Status layOutTables(TableLaunch* launch);
    PhotonSlots slots() const;

    Device* device_;
    DeviceBuffer photons_;
    std::array<DeviceBuffer, 2> keys_;  ///< while photons are traced, the first holds their places
    DeviceBuffer stored_;               ///< per emitted photon
    DeviceBuffer counters_;             ///< claimed slots, then cells per level
    DeviceBuffer scratch_;
    DeviceBuffer tables_;
    PhotonGridView grid_;
};

}  // namespace glint
