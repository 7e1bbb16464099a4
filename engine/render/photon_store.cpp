// Deterministic sorting of photons in place, cell tables and the implicit kd-tree.
#include "engine/render/photon_store.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "engine/base/check.h"
#include "engine/base/parallel.h"

namespace glint {
namespace {

constexpr int kDigitBits = 10;
constexpr int kDigits = 1 << kDigitBits;

/// One stable counting sort by the digit above `shift`, in `parts` parts: the result does not depend on
/// their number.
void sortByDigit(const std::vector<uint64_t>& from, std::vector<uint64_t>* to, int shift, int parts) {
    const auto count = static_cast<int64_t>(from.size());
    const auto digitOf = [shift](uint64_t key) { return (key >> shift) & (kDigits - 1); };
    const auto beginOf = [&](int part) { return count * part / parts; };
    std::vector<std::array<uint32_t, kDigits>> offsets(static_cast<size_t>(parts));
    parallelChunks(parts, 1, parts, [&](int64_t first, int64_t last) {
        for (int64_t part = first; part < last; ++part) {
            auto& histogram = offsets[static_cast<size_t>(part)];
            histogram.fill(0);
            for (int64_t i = beginOf(static_cast<int>(part)); i < beginOf(static_cast<int>(part) + 1); ++i) {
                ++histogram[digitOf(from[static_cast<size_t>(i)])];
            }
        }
    });
    uint32_t total = 0;
    for (size_t digit = 0; digit < kDigits; ++digit) {
        for (auto& histogram : offsets) {
            total += std::exchange(histogram[digit], total);
        }
    }
    parallelChunks(parts, 1, parts, [&](int64_t first, int64_t last) {
        for (int64_t part = first; part < last; ++part) {
            auto& offset = offsets[static_cast<size_t>(part)];
            for (int64_t i = beginOf(static_cast<int>(part)); i < beginOf(static_cast<int>(part) + 1); ++i) {
                const uint64_t key = from[static_cast<size_t>(i)];
                (*to)[offset[digitOf(key)]++] = key;
            }
        }
    });
}

}  // namespace

void PhotonStore::Writer::add(const Photon& photon) {
    if (usedInLast_ == kBlockPhotons) {
        blocks_.push_back(store_->claimedBlocks_.fetch_add(1, std::memory_order_relaxed));
        usedInLast_ = 0;
    }
    const uint32_t block = blocks_.back();
    if (block < store_->blockCapacity_) {
        store_->photons_[static_cast<size_t>(block) * kBlockPhotons + usedInLast_] = photon;
    }
    ++usedInLast_;
}

Status PhotonStore::checkRoom(uint64_t photons) {
    if (photons <= kMaxPhotons) { return {}; }
    return Error{
        fmt::format("the photons of one pass are kept at {} places, but there is room for no more than {}; "
                    "trace fewer photons a pass",
                    photons, kMaxPhotons),
        {}};
}

void PhotonStore::reset(size_t photons, size_t chunks) {
    const uint64_t room = roomFor(photons, chunks);
    GLINT_CHECK_OP(room, <=, uint64_t{kMaxPhotons});
    const size_t blocks = room / kBlockPhotons;
    blockCapacity_ = static_cast<uint32_t>(blocks);
    photons_.resize(blocks * kBlockPhotons);
    writers_.resize(chunks);
    for (Writer& writer : writers_) {
        writer.store_ = this;
        writer.blocks_.clear();
        writer.usedInLast_ = kBlockPhotons;
    }
    claimedBlocks_ = 0;
    count_ = 0;
}

void PhotonStore::collectSlots() {
    GLINT_CHECK(!overflowed());
    keys_.clear();
    for (const Writer& writer : writers_) {
        for (size_t i = 0; i < writer.blocks_.size(); ++i) {
            const bool last = i + 1 == writer.blocks_.size();
            const uint32_t first = writer.blocks_[i] * kBlockPhotons;
            for (uint32_t slot = first; slot < first + (last ? writer.usedInLast_ : kBlockPhotons); ++slot) {
                keys_.push_back(slot);
            }
        }
    }
    count_ = static_cast<uint32_t>(keys_.size());
}

void PhotonStore::addCellsToKeys(int threads) {
    constexpr int64_t kChunk = 65536;
    parallelChunks(count_, kChunk, threads, [&](int64_t begin, int64_t end) {
        for (auto i = static_cast<size_t>(begin); i < static_cast<size_t>(end); ++i) {
            const uint32_t slot = slotOfKey(keys_[i]);
            keys_[i] = photonSortKey(space_, photons_[slot], slot);
        }
    });
}

void PhotonStore::sortKeys(int threads) {
    keyScratch_.resize(keys_.size());
    const int parts = threads > 0 ? threads : defaultThreadCount();
    for (int shift = kPhotonSlotBits; shift < kPhotonKeyBits; shift += kDigitBits) {
        sortByDigit(keys_, &keyScratch_, shift, parts);
        keys_.swap(keyScratch_);
    }
}

/// Moves the photon of slot keys_[i] to place i for all i. Slots that hold no photon are overwritten first;
/// what then remains are cycles.
void PhotonStore::permutePhotons() {
    std::vector<bool> occupied(photons_.size(), false);
    for (const uint64_t key : keys_) {
        occupied[slotOfKey(key)] = true;
    }
    const auto settle = [&](uint32_t place) {
        keys_[place] = keys_[place] - slotOfKey(keys_[place]) + place;
    };
    for (uint32_t start = 0; start < count_; ++start) {
        uint32_t hole = start;
        while (hole < count_ && !occupied[hole]) {
            const uint32_t source = slotOfKey(keys_[hole]);
            photons_[hole] = photons_[source];
            occupied[hole] = true;
            occupied[source] = false;
            settle(hole);
            hole = source;
        }
    }
    for (uint32_t start = 0; start < count_; ++start) {
        if (slotOfKey(keys_[start]) == start) { continue; }
        const Photon displaced = photons_[start];
        uint32_t place = start;
        while (true) {
            const uint32_t source = slotOfKey(keys_[place]);
            settle(place);
            if (source == start) {
                photons_[place] = displaced;
                break;
            }
            photons_[place] = photons_[source];
            place = source;
        }
    }
}

void PhotonStore::buildTable(int level) {
    const auto cellOf = [&](uint32_t i) { return cellOfKey(keys_[i], level); };
    uint32_t cells = 0;
    for (uint32_t i = 0; i < count_; ++i) {
        cells += i == 0 || cellOf(i) != cellOf(i - 1) ? 1 : 0;
    }
    std::vector<GridSlot>& table = tables_[static_cast<size_t>(level)];
    table.assign(gridTableCapacity(cells), GridSlot{});
    const auto capacity = static_cast<uint32_t>(table.size());
    for (uint32_t begin = 0; begin < count_;) {
        const uint64_t cell = cellOf(begin);
        uint32_t end = begin + 1;
        while (end < count_ && cellOf(end) == cell) {
            ++end;
        }
        const uint32_t slot =
            probeGridTable(capacity, cell, [&](uint32_t candidate) { return table[candidate].end == 0; });
        table[slot] = {cell, begin, end};
        begin = end;
    }
}

void PhotonStore::buildGrid(const GridSpace& space, uint32_t levelsInUse, int threads) {
    space_ = space;
    collectSlots();
    addCellsToKeys(threads);
    sortKeys(threads);
    permutePhotons();
    parallelChunks(kGridLevels, 1, threads, [&](int64_t first, int64_t last) {
        for (int64_t level = first; level < last; ++level) {
            if ((levelsInUse >> level) & 1u) {
                buildTable(static_cast<int>(level));
            } else {
                tables_[static_cast<size_t>(level)].clear();
            }
        }
    });
}

PhotonGridView PhotonStore::grid() const {
    PhotonGridView view;
    view.space = space_;
    view.photons = {photons_.data(), count_};
    for (size_t level = 0; level < kGridLevels; ++level) {
        view.tables[level] = {tables_[level].data(), static_cast<uint32_t>(tables_[level].size())};
    }
    return view;
}

PhotonTreeView PhotonStore::tree() const { return {{photons_.data(), count_}, axes_.data()}; }

size_t PhotonStore::bytes() const {
    size_t total = photons_.capacity() * sizeof(Photon) + axes_.capacity() +
                   (keys_.capacity() + keyScratch_.capacity()) * sizeof(uint64_t);
    for (const auto& table : tables_) {
        total += table.capacity() * sizeof(GridSlot);
    }
    return total;
}

}  // namespace glint
