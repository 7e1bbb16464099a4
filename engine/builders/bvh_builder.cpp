// Binned SAH (Wald 2007, "On fast Construction of SAH-based Bounding Volume Hierarchies"), in parallel
// over subtrees.
#include "engine/builders/bvh_builder.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "engine/base/check.h"
#include "engine/base/thread_limit.h"
#include "engine/builders/box_lanes.h"

namespace glint {
namespace {

constexpr int kBvhBins = 32;
constexpr uint32_t kTaskPrimitives = 4096;  // smaller subtrees are not worth a task

struct Bin {
    BoxLanes box;
    uint32_t count = 0;
};

struct BvhSplit {
    float cost = kInfinity;  // sum over both sides of half area times leaves
    int axis = -1;
    int bin = 0;  // the left side takes bins below this one
};

/// The boxes of some primitives and of their centres, doubled.
struct Extent {
    BoxLanes box;
    BoxLanes doubledCenters;

    void grow(const BuildPrimitive& p) {
        box.grow(BoxLanes::of(p));
        doubledCenters.grow(BoxLanes::doubledCenter(p));
    }
};

/// Few primitives do not need many bins.
int binCount(uint32_t primitives) {
    return static_cast<int>(std::min<uint32_t>(kBvhBins, 6 + primitives / 16));
}

class BvhBuilder {
  public:
    BvhBuilder(HugeVector<BuildPrimitive>* primitives, const BvhOptions& options,
               HugeVector<BinaryNode>* nodes)
        : primitives_(primitives->data()),
          options_(options),
          leavesPerPrimitive_(1.0f / static_cast<float>(options.leafPrimitives)),
          nodes_(nodes->data()) {}

    Extent extentOf(uint32_t begin, uint32_t end) const {
        Extent extent;
        for (uint32_t i = begin; i < end; ++i) {
            extent.grow(primitives_[i]);
        }
        return extent;
    }

    uint32_t nodeCount() const { return nextNode_.load(); }

    /// The subtree over [begin, end), its root in nodes[slot].
    void build(uint32_t slot, uint32_t begin, uint32_t end, const Extent& extent) {
        BinaryNode& node = nodes_[slot];
        const Bounds bounds = extent.box.bounds();
        node = {bounds.lo, bounds.hi, begin, end, 0};
        if (end - begin <= options_.leafPrimitives) { return; }
        Extent left, right;
        const uint32_t middle = split(node, extent.doubledCenters.bounds(), &left, &right);
        const uint32_t children = nextNode_.fetch_add(2, std::memory_order_relaxed);
        node.children = children;
        if (end - begin >= 2 * kTaskPrimitives) {
#pragma omp task default(none) firstprivate(children, begin, middle, left)
            build(children, begin, middle, left);
        } else {
            build(children, begin, middle, left);
        }
        build(children + 1, middle, end, right);
    }

  private:
    /// Partitions the node's primitives and returns where the right side begins; both sides get some.
    uint32_t split(const BinaryNode& node, const Bounds& doubledCenters, Extent* left, Extent* right) {
        const BinMap map(doubledCenters, binCount(node.end - node.begin));
        BvhSplit best;
        if (!options_.balanced && !map.empty()) { best = findSplit(node, map); }
        if (best.axis >= 0) { return partition(node, map, best, left, right); }
        const uint32_t middle = node.begin + (node.end - node.begin) / 2;
        if (options_.balanced) { sortAround(node, middle, doubledCenters); }
        *left = extentOf(node.begin, middle);
        *right = extentOf(middle, node.end);
        return middle;
    }

    uint32_t partition(const BinaryNode& node, const BinMap& map, const BvhSplit& best, Extent* left,
                       Extent* right) {
        uint32_t low = node.begin;
        uint32_t high = node.end;
        const auto belongsLeft = [&](uint32_t i) { return map.bin(primitives_[i], best.axis) < best.bin; };
        while (true) {
            while (low < high && belongsLeft(low)) {
                left->grow(primitives_[low++]);
            }
            while (low < high && !belongsLeft(high - 1)) {
                right->grow(primitives_[--high]);
            }
            if (low == high) { return low; }
            std::swap(primitives_[low], primitives_[high - 1]);
        }
    }

    void sortAround(const BinaryNode& node, uint32_t middle, const Bounds& doubledCenters) {
        const Vec3 extent = doubledCenters.extent();
        const int axis = extent.x > extent.y ? (extent.x > extent.z ? 0 : 2) : (extent.y > extent.z ? 1 : 2);
        std::nth_element(primitives_ + node.begin, primitives_ + middle, primitives_ + node.end,
                         [axis](const BuildPrimitive& a, const BuildPrimitive& b) {
                             const float ca = a.lo[axis] - a.negatedHi[axis];
                             const float cb = b.lo[axis] - b.negatedHi[axis];
                             return ca < cb || (ca == cb && a.index < b.index);
                         });
    }

    BvhSplit findSplit(const BinaryNode& node, const BinMap& map) const {
        Bin bins[3][kBvhBins];
        const int count = binCount(node.end - node.begin);
        for (uint32_t i = node.begin; i < node.end; ++i) {
            const BuildPrimitive& p = primitives_[i];
            const BoxLanes box = BoxLanes::of(p);
            uint32_t bin[3];
            map.bins(p, bin);
            for (int axis = 0; axis < 3; ++axis) {
                Bin& target = bins[axis][bin[axis]];
                target.box.grow(box);
                ++target.count;
            }
        }
        BvhSplit best;
        for (int axis = 0; axis < 3; ++axis) {
            if (map.splits(axis)) { sweep(bins[axis], count, axis, &best); }
        }
        return best;
    }

    float sideCost(const Bin& side) const {
        return side.box.halfArea() * std::ceil(static_cast<float>(side.count) * leavesPerPrimitive_);
    }

    void sweep(const Bin* bins, int count, int axis, BvhSplit* best) const {
        float rightCost[kBvhBins];
        Bin side;
        for (int i = count - 1; i > 0; --i) {
            side.box.grow(bins[i].box);
            side.count += bins[i].count;
            rightCost[i] = side.count ? sideCost(side) : kInfinity;
        }
        side = Bin{};
        for (int i = 1; i < count; ++i) {
            side.box.grow(bins[i - 1].box);
            side.count += bins[i - 1].count;
            if (side.count == 0) { continue; }
            const float cost = sideCost(side) + rightCost[i];
            if (cost < best->cost) { *best = {cost, axis, i}; }
        }
    }

    BuildPrimitive* primitives_;
    BvhOptions options_;
    float leavesPerPrimitive_;
    BinaryNode* nodes_;
    std::atomic<uint32_t> nextNode_{1};
};

}  // namespace

BinaryTree buildBinaryTree(HugeVector<BuildPrimitive>* primitives, const BvhOptions& options) {
    BinaryTree tree;
    const uint32_t count = static_cast<uint32_t>(primitives->size());
    tree.nodes.resize(2 * static_cast<size_t>(count));
    BvhBuilder builder(primitives, options, &tree.nodes);
    const int threads = count >= 2 * kTaskPrimitives ? startableThreads(options.threads) : 1;
    if (threads == 1) {
        builder.build(0, 0, count, builder.extentOf(0, count));
    } else {
#pragma omp parallel num_threads(threads)
#pragma omp single
        builder.build(0, 0, count, builder.extentOf(0, count));
    }
    tree.count = builder.nodeCount();
    return tree;
}

HugeVector<WideNode> buildBvh(HugeVector<BuildPrimitive>* primitives, const LeafOptions& leafOptions,
                              const PackLeaves& packLeaves) {
    BvhOptions options{leafOptions};
    HugeVector<WideNode> nodes = collapseTree(buildBinaryTree(primitives, options), packLeaves);
    if (traversalStackNeed(nodes) > kTraversalStackSize) {
        options.balanced = true;
        nodes = collapseTree(buildBinaryTree(primitives, options), packLeaves);
    }
    GLINT_CHECK_OP(traversalStackNeed(nodes), <=, uint32_t{kTraversalStackSize});
    return nodes;
}

}  // namespace glint
