// Ranks, sorts and moves the photons of a pass, and builds the tables of their grid.

#include "cuda/device_photons.h"

#include <algorithm>
#include <array>

#include "cuda/device_memory.h"
#include "cuda/paced_launches.h"
#include "cuda/sppm_variant.h"
#include "engine/render/photon_store.h"

namespace glint {
namespace {

static_assert(PhotonStore::kBytesPerPhoton == sizeof(Photon) + 2 * sizeof(uint64_t));

/// In counters_: one claimed count, then one count of cells for each level.
constexpr size_t kCellCounts = sizeof(uint64_t);
constexpr size_t kCounterBytes = kCellCounts + kGridLevels * sizeof(uint32_t);

KeySort sortOf(uint64_t* keys, uint64_t* other, uint32_t count) {
    return {keys, other, count, kPhotonSlotBits, kPhotonKeyBits};
}

}  // namespace

Result<size_t> DevicePhotons::bytesWith(uint32_t emitted, uint32_t room) const {
    const Result<size_t> scratch = device_->scratchBytes(emitted, sortOf(nullptr, nullptr, room));
    if (!scratch) { return scratch; }
    return std::max(photons_.bytes(), room * sizeof(Photon)) +
           2 * std::max(keys_[0].bytes(), room * sizeof(uint64_t)) +
           std::max(stored_.bytes(), emitted * sizeof(uint32_t)) + std::max(scratch_.bytes(), *scratch) +
           kCounterBytes + tables_.bytes();
}

Status DevicePhotons::reserve(uint32_t emitted, uint32_t room) {
    const Result<size_t> scratch = device_->scratchBytes(emitted, sortOf(nullptr, nullptr, room));
    if (!scratch) { return scratch.error(); }
    const std::pair<DeviceBuffer*, size_t> wanted[] = {
        {&photons_, room * sizeof(Photon)},
        {&keys_[0], room * sizeof(uint64_t)},
        {&keys_[1], room * sizeof(uint64_t)},
        {&stored_, emitted * sizeof(uint32_t)},
        {&scratch_, *scratch},
        {&counters_, kCounterBytes},
    };
    for (const auto& [buffer, bytes] : wanted) {
        if (Status s = buffer->reserve(*device_, bytes); !s) { return s; }
    }
    return {};
}

PhotonSlots DevicePhotons::slots() const {
    return {photons_.as<Photon>(), keys_[0].as<uint64_t>(), stored_.as<uint32_t>(), counters_.as<uint64_t>(),
            room()};
}

Result<PhotonSlots> DevicePhotons::reset() {
    if (Status s = device_->clear(counters_.data(), kCounterBytes); !s) { return s.error(); }
    return slots();
}

Result<uint64_t> DevicePhotons::wanted() {
    uint64_t claimed = 0;
    if (Status s = device_->download(&claimed, counters_.data(), sizeof claimed); !s) { return s.error(); }
    return claimed;
}

Status DevicePhotons::build(const GridSpace& space, uint32_t levelsInUse, uint32_t emitted, uint32_t count) {
    grid_ = {space, {photons_.as<Photon>(), count}, {}};
    if (count == 0) { return {}; }
    const Result<Sorted> sorted = sortKeys(space, emitted, count);
    if (!sorted) { return sorted.error(); }
    if (Status s = movePhotons(*sorted, count); !s) { return s; }
    return buildTables(sorted.value().keys, levelsInUse, count);
}

/// In the order of tracing first, then, stably, by cell.
Result<DevicePhotons::Sorted> DevicePhotons::sortKeys(const GridSpace& space, uint32_t emitted,
                                                      uint32_t count) {
    auto* const stored = stored_.as<uint32_t>();
    auto* const keys = keys_[1].as<uint64_t>();
    auto* const places = keys_[0].as<uint64_t>();
    if (Status s = device_->sumBefore(stored, emitted, scratch_.data(), scratch_.bytes()); !s) {
        return s.error();
    }
    const KeyLaunch launch{space, slots(), stored, keys};
    if (Status s = runAtOnce(*device_, kPhotonSteps.makeKeys, launch, count); !s) { return s.error(); }
    const Result<uint64_t*> sorted =
        device_->sortKeys(sortOf(keys, places, count), scratch_.data(), scratch_.bytes());
    if (!sorted) { return sorted.error(); }
    return Sorted{*sorted, *sorted == keys ? places : keys};
}

Status DevicePhotons::movePhotons(const Sorted& sorted, uint32_t count) {
    MoveLaunch launch{sorted.keys, photons_.as<Photon>(), sorted.free};
    for (launch.part = 0; launch.part < kPhotonParts; ++launch.part) {
        if (Status s = runAtOnce(*device_, kPhotonSteps.takeParts, launch, count); !s) { return s; }
        if (Status s = runAtOnce(*device_, kPhotonSteps.placeParts, launch, count); !s) { return s; }
    }
    return {};
}

Status DevicePhotons::buildTables(const uint64_t* keys, uint32_t levelsInUse, uint32_t count) {
    TableLaunch launch;
    launch.keys = keys;
    launch.photonCount = count;
    launch.levelsInUse = levelsInUse;
    launch.cellCounts = reinterpret_cast<uint32_t*>(counters_.data() + kCellCounts);
    if (Status s = runAtOnce(*device_, kPhotonSteps.countCells, launch, count); !s) { return s; }
    if (Status s = layOutTables(&launch); !s) { return s; }
    if (Status s = runAtOnce(*device_, kPhotonSteps.enterCells, launch, count); !s) { return s; }
    if (Status s = runAtOnce(*device_, kPhotonSteps.closeCells, launch, count); !s) { return s; }
    for (size_t level = 0; level < kGridLevels; ++level) {
        grid_.tables[level] = {launch.tables[level], launch.capacities[level]};
    }
    return {};
}

/// Empty tables of the right sizes, one after the other in one block.
Status DevicePhotons::layOutTables(TableLaunch* launch) {
    std::array<uint32_t, kGridLevels> cells{};
    if (Status s = device_->download(cells.data(), counters_.data() + kCellCounts, sizeof cells); !s) {
        return s;
    }
    size_t slotCount = 0;
    for (size_t level = 0; level < kGridLevels; ++level) {
        const bool inUse = (launch->levelsInUse >> level & 1u) != 0;
        launch->capacities[level] = inUse ? gridTableCapacity(cells[level]) : 0;
        slotCount += launch->capacities[level];
    }
    const size_t bytes = slotCount * sizeof(GridSlot);
    if (bytes == 0) { return {}; }
    if (bytes > tables_.bytes()) {
        if (Status s = checkFits(*device_, "The photon grid needs", bytes, tables_.bytes()); !s) { return s; }
    }
    if (Status s = tables_.reserve(*device_, bytes); !s) { return s; }
    GridSlot* next = tables_.as<GridSlot>();
    for (size_t level = 0; level < kGridLevels; ++level) {
        launch->tables[level] = next;
        next += launch->capacities[level];
    }
    return device_->clear(tables_.data(), bytes);
}

size_t DevicePhotons::bytes() const {
    return photons_.bytes() + keys_[0].bytes() + keys_[1].bytes() + stored_.bytes() + counters_.bytes() +
           scratch_.bytes() + tables_.bytes();
}

}  // namespace glint
