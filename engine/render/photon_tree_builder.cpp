// The kd-tree of a PhotonStore: median splits on the widest axis, in place.
#include <algorithm>

#include "engine/base/thread_limit.h"
#include "engine/math/bounds.h"
#include "engine/render/photon_store.h"

namespace glint {
namespace {

/// Below this many photons a task costs more than it gains.
constexpr uint32_t kTaskPhotons = 16384;

class TreeBuilder {
  public:
    TreeBuilder(Photon* photons, uint8_t* axes) : photons_(photons), axes_(axes) {}

    void build(uint32_t begin, uint32_t end) const {
        if (begin >= end) { return; }
        const uint32_t middle = begin + (end - begin) / 2;
        const int axis = widestAxis(begin, end);
        // Equal coordinates may end on either side of the median, which queries allow for; nth_element itself
        // is deterministic, so the arrangement is too.
        std::nth_element(photons_ + begin, photons_ + middle, photons_ + end,
                         [axis](const Photon& a, const Photon& b) { return a.p[axis] < b.p[axis]; });
        axes_[middle] = static_cast<uint8_t>(axis);
#pragma omp task if (end - begin > kTaskPhotons)
        build(begin, middle);
        build(middle + 1, end);
#pragma omp taskwait
    }

  private:
    int widestAxis(uint32_t begin, uint32_t end) const {
        Bounds bounds;
        for (uint32_t i = begin; i < end; ++i) {
            bounds.grow(photons_[i].p);
        }
        const Vec3 extent = bounds.extent();
        return extent.x >= extent.y && extent.x >= extent.z ? 0 : (extent.y >= extent.z ? 1 : 2);
    }

    Photon* photons_;
    uint8_t* axes_;
};

}  // namespace

void PhotonStore::buildTree(int threads) {
    collectSlots();
    permutePhotons();
    axes_.resize(count_);
    const TreeBuilder builder(photons_.data(), axes_.data());
    const uint32_t count = count_;
    const int used = startableThreads(threads);
#pragma omp parallel num_threads(used)
#pragma omp single
    builder.build(0, count);
}

}  // namespace glint
