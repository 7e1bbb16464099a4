// Binned SAH (Wald 2007, "On fast Construction of SAH-based Bounding Volume Hierarchies"), in parallel over
// subtrees.
#include "engine/build/bvh_builder.h"

#include <algorithm>
#include <array>

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
    uint32_t count = 0;
};

struct Split {
    float cost = kInfinity;  // sum of half area times primitives over both sides
    int axis = -1;
    int bin = 0;  // the left side takes bins below this one
};

/// Maps a box to a bin by its centre, the same way when binning and when partitioning.
struct BinMap {
    Lanes4 origin;
    Lanes4 scale;

    BinMap(const Vec3& lowestDoubledCenter, const Vec3& highestDoubledCenter) {
        const Vec3 extent = highestDoubledCenter - lowestDoubledCenter;
        Vec3 s(0.0f);
        for (int axis = 0; axis < 3; ++axis) {
            const float perBin = 0.9999f * kBins / extent[axis];
            if (extent[axis] > 0.0f && perBin < kInfinity) s[axis] = perBin;
        }
        origin = Lanes4::of(lowestDoubledCenter);
        scale = Lanes4::of(s);
    }
    /// Bins along x, y and z; the fourth number means nothing.
    void bins(const BuildPrimitive& p, int32_t bin[4]) const {
        const Lanes4 center = Lanes4::load(&p.lo.x) + Lanes4::load(&p.hi.x);
        ((center - origin) * scale).storeClampedInts(0, kBins - 1, bin);
    }
    bool splits(int axis) const { return scale.xyz()[axis] > 0.0f; }
    bool empty() const { return isZero(scale.xyz()); }
};

class Builder {
  public:
    Builder(HugeVector<BuildPrimitive>* primitives, const BvhOptions& options, HugeVector<BinaryNode>* nodes)
        : primitives_(primitives->data()), options_(options), nodes_(nodes->data()) {}

    /// Subtree over [begin, end) with its root in `slot`; it uses at most 2 * count - 1 slots from there on.
    void build(uint32_t slot, uint32_t begin, uint32_t end) {
        BinaryNode& node = nodes_[slot];
        node.begin = begin;
        node.end = end;
        Box4 bounds;
        Box4 doubledCenters;
        for (uint32_t i = begin; i < end; ++i) {
            const BuildPrimitive& p = primitives_[i];
            bounds.grow(p);
            const Lanes4 center = Lanes4::load(&p.lo.x) + Lanes4::load(&p.hi.x);
            doubledCenters.grow(Box4{center, center});
        }
        node.lo = bounds.lo.xyz();
        node.hi = bounds.hi.xyz();
        node.right = 0;
        const uint32_t middle = split(node, {doubledCenters.lo.xyz(), doubledCenters.hi.xyz()});
        if (middle == begin) return;
        node.right = slot + 2 * (middle - begin);
        const uint32_t right = node.right;
        if (end - begin >= 2 * kTaskPrimitives) {
#pragma omp task default(none) firstprivate(slot, begin, middle)
            build(slot + 1, begin, middle);
            build(right, middle, end);
        } else {
            build(slot + 1, begin, middle);
            build(right, middle, end);
        }
    }

  private:
    /// Partitions the node's primitives and returns where the right side begins, or begin for a leaf.
    uint32_t split(const BinaryNode& node, const Bounds& doubledCenters) {
        const uint32_t count = node.end - node.begin;
        if (count == 1) return node.begin;
        const uint32_t middle = node.begin + count / 2;
        const BinMap map(doubledCenters.lo, doubledCenters.hi);
        if (options_.balanced || map.empty()) {
            const bool leaf = count <= options_.maxLeafPrimitives;
            if (!leaf && options_.balanced) sortAround(node, middle, doubledCenters);
            return leaf ? node.begin : middle;
        }
        const Split best = findSplit(node, map);
        const float leafCost = node.bounds().halfArea() * static_cast<float>(count);
        const float splitCost = best.cost + 2.0f * options_.traversalCost * node.bounds().halfArea();
        if (count <= options_.maxLeafPrimitives && !(splitCost < leafCost)) return node.begin;
        if (best.axis < 0) return middle;
        const BuildPrimitive* right =
            std::partition(primitives_ + node.begin, primitives_ + node.end, [&](const BuildPrimitive& p) {
                int32_t bin[4];
                map.bins(p, bin);
                return bin[best.axis] < best.bin;
            });
        return static_cast<uint32_t>(right - primitives_);
    }

    void sortAround(const BinaryNode& node, uint32_t middle, const Bounds& doubledCenters) {
        const Vec3 extent = doubledCenters.extent();
        const int axis = extent.x > extent.y ? (extent.x > extent.z ? 0 : 2) : (extent.y > extent.z ? 1 : 2);
        std::nth_element(primitives_ + node.begin, primitives_ + middle, primitives_ + node.end,
                         [axis](const BuildPrimitive& a, const BuildPrimitive& b) {
                             const float ca = a.lo[axis] + a.hi[axis];
                             const float cb = b.lo[axis] + b.hi[axis];
                             return ca < cb || (ca == cb && a.index < b.index);
                         });
    }

    Split findSplit(const BinaryNode& node, const BinMap& map) const {
        std::array<std::array<Bin, kBins>, 3> bins;
        for (uint32_t i = node.begin; i < node.end; ++i) {
            const BuildPrimitive& p = primitives_[i];
            int32_t bin[4];
            map.bins(p, bin);
            for (size_t axis = 0; axis < 3; ++axis) {
                Bin& target = bins[axis][static_cast<size_t>(bin[axis])];
                target.bounds.grow(p);
                ++target.count;
            }
        }
        Split best;
        for (int axis = 0; axis < 3; ++axis) {
            if (map.splits(axis)) sweep(bins[static_cast<size_t>(axis)], axis, &best);
        }
        return best;
    }

    static void sweep(const std::array<Bin, kBins>& bins, int axis, Split* best) {
        std::array<float, kBins> rightCost;
        Bin side;
        for (int i = kBins - 1; i > 0; --i) {
            side.bounds.grow(bins[i].bounds);
            side.count += bins[i].count;
            rightCost[i] = side.count ? side.bounds.halfArea() * static_cast<float>(side.count) : kInfinity;
        }
        side = Bin{};
        for (int i = 1; i < kBins; ++i) {
            side.bounds.grow(bins[i - 1].bounds);
            side.count += bins[i - 1].count;
            if (side.count == 0) continue;
            const float cost = side.bounds.halfArea() * static_cast<float>(side.count) + rightCost[i];
            if (cost < best->cost) *best = {cost, axis, i};
        }
    }

    BuildPrimitive* primitives_;
    BvhOptions options_;
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
    builder.build(0, 0, count);
    return tree;
}

}  // namespace glint
