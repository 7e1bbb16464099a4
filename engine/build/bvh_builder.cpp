// Binned SAH (Wald 2007, "On fast Construction of SAH-based Bounding Volume Hierarchies"), in parallel over
// subtrees.
#include "engine/build/bvh_builder.h"

#include <algorithm>
#include <cmath>

#include "engine/base/parallel.h"
#include "engine/build/lanes4.h"

namespace glint {
namespace {

constexpr int kBins = 32;
constexpr uint32_t kTaskPrimitives = 4096;  // smaller subtrees are not worth a task

/// A box as two vectors of four floats; the fourth lanes are never read. Half the work of a binning builder
/// is here.
struct Box4 {
    Lanes4 lo = Lanes4::all(kInfinity);
    Lanes4 hi = Lanes4::all(-kInfinity);

    void grow(const BuildPrimitive& p) {
        lo = min(lo, Lanes4::load(&p.lo.x));
        hi = max(hi, Lanes4::load(&p.hi.x));
    }
    void grow(const Box4& b) {
        lo = min(lo, b.lo);
        hi = max(hi, b.hi);
    }
    float halfArea() const { return Bounds{lo.xyz(), hi.xyz()}.halfArea(); }
};

struct Bin {
    Box4 bounds;
    uint32_t count;
};

struct Split {
    float cost = kInfinity;  // sum over both sides of half area times leaves
    int axis = -1;
    int bin = 0;  // the left side takes bins below this one
};

/// The boxes of some primitives and of their centres, doubled.
struct Extent {
    Box4 bounds;
    Box4 doubledCenters;

    void grow(const BuildPrimitive& p) {
        bounds.grow(p);
        const Lanes4 center = Lanes4::load(&p.lo.x) + Lanes4::load(&p.hi.x);
        doubledCenters.grow(Box4{center, center});
    }
};

/// Maps a box to a bin by its centre, the same way when binning and when partitioning.
struct BinMap {
    Lanes4 origin;
    Lanes4 scale;
    int count;  ///< of bins: few primitives do not need many

    BinMap(const Box4& doubledCenters, uint32_t primitives) {
        count = static_cast<int>(std::min<uint32_t>(kBins, 6 + primitives / 16));
        const Vec3 extent = doubledCenters.hi.xyz() - doubledCenters.lo.xyz();
        Vec3 s(0.0f);
        for (int axis = 0; axis < 3; ++axis) {
            const float perBin = 0.9999f * static_cast<float>(count) / extent[axis];
            if (extent[axis] > 0.0f && perBin < kInfinity) s[axis] = perBin;
        }
        origin = doubledCenters.lo;
        scale = Lanes4::of(s);
    }
    /// Bins along x, y and z; the fourth number means nothing.
    void bins(const BuildPrimitive& p, int32_t bin[4]) const {
        const Lanes4 center = Lanes4::load(&p.lo.x) + Lanes4::load(&p.hi.x);
        ((center - origin) * scale).storeClampedInts(0, count - 1, bin);
    }
    bool splits(int axis) const { return scale.xyz()[axis] > 0.0f; }
    bool empty() const { return isZero(scale.xyz()); }
};

class Builder {
  public:
    Builder(HugeVector<BuildPrimitive>* primitives, const BvhOptions& options, HugeVector<BinaryNode>* nodes)
        : primitives_(primitives->data()),
          options_(options),
          leavesPerPrimitive_(1.0f / static_cast<float>(options.leafPrimitives)),
          nodes_(nodes->data()) {}

    Extent extentOf(uint32_t begin, uint32_t end) const {
        Extent extent;
        for (uint32_t i = begin; i < end; ++i) extent.grow(primitives_[i]);
        return extent;
    }

    /// Subtree over [begin, end) with its root in `slot`; it uses at most 2 * count - 1 slots from there on.
    void build(uint32_t slot, uint32_t begin, uint32_t end, const Extent& extent) {
        BinaryNode& node = nodes_[slot];
        node = {extent.bounds.lo.xyz(), extent.bounds.hi.xyz(), begin, end, 0};
        if (end - begin <= options_.leafPrimitives) return;
        Extent left, right;
        const uint32_t middle = split(node, extent.doubledCenters, &left, &right);
        const uint32_t rightSlot = slot + 2 * (middle - begin);
        node.right = rightSlot;
        if (end - begin >= 2 * kTaskPrimitives) {
#pragma omp task default(none) firstprivate(slot, begin, middle, left)
            build(slot + 1, begin, middle, left);
        } else {
            build(slot + 1, begin, middle, left);
        }
        build(rightSlot, middle, end, right);
    }

  private:
    /// Partitions the node's primitives and returns where the right side begins; both sides get some.
    uint32_t split(const BinaryNode& node, const Box4& doubledCenters, Extent* left, Extent* right) {
        const BinMap map(doubledCenters, node.end - node.begin);
        Split best;
        if (!options_.balanced && !map.empty()) best = findSplit(node, map);
        if (best.axis >= 0) return partition(node, map, best, left, right);
        const uint32_t middle = node.begin + (node.end - node.begin) / 2;
        if (options_.balanced) sortAround(node, middle, doubledCenters);
        *left = extentOf(node.begin, middle);
        *right = extentOf(middle, node.end);
        return middle;
    }

    uint32_t partition(const BinaryNode& node, const BinMap& map, const Split& best, Extent* left,
                       Extent* right) {
        uint32_t low = node.begin;
        uint32_t high = node.end;
        const auto belongsLeft = [&](uint32_t i) {
            int32_t bin[4];
            map.bins(primitives_[i], bin);
            return bin[best.axis] < best.bin;
        };
        while (true) {
            while (low < high && belongsLeft(low)) left->grow(primitives_[low++]);
            while (low < high && !belongsLeft(high - 1)) right->grow(primitives_[--high]);
            if (low == high) return low;
            std::swap(primitives_[low], primitives_[high - 1]);
        }
    }

    void sortAround(const BinaryNode& node, uint32_t middle, const Box4& doubledCenters) {
        const Vec3 extent = doubledCenters.hi.xyz() - doubledCenters.lo.xyz();
        const int axis = extent.x > extent.y ? (extent.x > extent.z ? 0 : 2) : (extent.y > extent.z ? 1 : 2);
        std::nth_element(primitives_ + node.begin, primitives_ + middle, primitives_ + node.end,
                         [axis](const BuildPrimitive& a, const BuildPrimitive& b) {
                             const float ca = a.lo[axis] + a.hi[axis];
                             const float cb = b.lo[axis] + b.hi[axis];
                             return ca < cb || (ca == cb && a.index < b.index);
                         });
    }

    Split findSplit(const BinaryNode& node, const BinMap& map) const {
        Bin bins[3][kBins];  // only the first map.count of each are used
        for (auto& axis : bins) std::fill_n(axis, map.count, Bin{Box4{}, 0});
        for (uint32_t i = node.begin; i < node.end; ++i) {
            const BuildPrimitive& p = primitives_[i];
            int32_t bin[4];
            map.bins(p, bin);
            for (int axis = 0; axis < 3; ++axis) {
                Bin& target = bins[axis][bin[axis]];
                target.bounds.grow(p);
                ++target.count;
            }
        }
        Split best;
        for (int axis = 0; axis < 3; ++axis) {
            if (map.splits(axis)) sweep(bins[axis], map.count, axis, &best);
        }
        return best;
    }

    float sideCost(const Bin& side) const {
        return side.bounds.halfArea() * std::ceil(static_cast<float>(side.count) * leavesPerPrimitive_);
    }

    void sweep(const Bin* bins, int count, int axis, Split* best) const {
        float rightCost[kBins];
        Bin side{Box4{}, 0};
        for (int i = count - 1; i > 0; --i) {
            side.bounds.grow(bins[i].bounds);
            side.count += bins[i].count;
            rightCost[i] = side.count ? sideCost(side) : kInfinity;
        }
        side = {Box4{}, 0};
        for (int i = 1; i < count; ++i) {
            side.bounds.grow(bins[i - 1].bounds);
            side.count += bins[i - 1].count;
            if (side.count == 0) continue;
            const float cost = sideCost(side) + rightCost[i];
            if (cost < best->cost) *best = {cost, axis, i};
        }
    }

    BuildPrimitive* primitives_;
    BvhOptions options_;
    float leavesPerPrimitive_;
    BinaryNode* nodes_;
};

}  // namespace

BinaryTree buildBinaryTree(HugeVector<BuildPrimitive>* primitives, const BvhOptions& options) {
    BinaryTree tree;
    const uint32_t count = static_cast<uint32_t>(primitives->size());
    tree.nodes.resize(2 * static_cast<size_t>(count));
    Builder builder(primitives, options, &tree.nodes);
    const int threads = options.threads > 0 ? options.threads : defaultThreadCount();
#pragma omp parallel num_threads(threads) if (count >= 2 * kTaskPrimitives && threads > 1)
#pragma omp single
    builder.build(0, 0, count, builder.extentOf(0, count));
    return tree;
}

}  // namespace glint
