// Binned SAH (Wald 2007, "On fast Construction of SAH-based Bounding Volume Hierarchies"), in parallel over
// subtrees.
#include "engine/build/bvh_builder.h"

#include <algorithm>
#include <array>

#include "engine/base/parallel.h"

namespace glint {
namespace {

constexpr int kBins = 32;
constexpr uint32_t kTaskPrimitives = 4096;  // smaller subtrees are not worth a task

struct Bin {
    Bounds bounds;
    uint32_t count = 0;
};

struct Split {
    float cost = kInfinity;  // sum of half area times primitives over both sides
    int axis = -1;
    int bin = 0;  // the left side takes bins below this one
};

/// Maps a box to a bin by its centre, the same way when binning and when partitioning.
struct BinMap {
    Vec3 origin;
    Vec3 scale;

    explicit BinMap(const Bounds& doubledCenters) : origin(doubledCenters.lo) {
        const Vec3 extent = doubledCenters.extent();
        for (int axis = 0; axis < 3; ++axis) {
            const float s = 0.9999f * kBins / extent[axis];
            scale[axis] = extent[axis] > 0.0f && s < kInfinity ? s : 0.0f;
        }
    }
    int bin(const Bounds& b, int axis) const {
        const float center = b.lo[axis] + b.hi[axis];
        return std::clamp(static_cast<int>((center - origin[axis]) * scale[axis]), 0, kBins - 1);
    }
};

class Builder {
  public:
    Builder(std::vector<BuildPrimitive>* primitives, const BvhOptions& options,
            std::vector<BinaryNode>* nodes)
        : primitives_(primitives->data()), options_(options), nodes_(nodes->data()) {}

    /// Subtree over [begin, end) with its root in `slot`; it uses at most 2 * count - 1 slots from there on.
    void build(uint32_t slot, uint32_t begin, uint32_t end) {
        BinaryNode& node = nodes_[slot];
        node.begin = begin;
        node.end = end;
        Bounds doubledCenters;
        for (uint32_t i = begin; i < end; ++i) {
            const Bounds& b = primitives_[i].bounds;
            node.bounds.grow(b);
            doubledCenters.grow(b.lo + b.hi);
        }
        const uint32_t middle = split(node, doubledCenters);
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
        const BinMap map(doubledCenters);
        if (options_.balanced || map.scale == Vec3(0.0f)) {
            const bool leaf = count <= options_.maxLeafPrimitives;
            if (!leaf && options_.balanced) sortAround(node, middle, doubledCenters);
            return leaf ? node.begin : middle;
        }
        const Split best = findSplit(node, map);
        const float leafCost = node.bounds.halfArea() * static_cast<float>(count);
        const float splitCost = best.cost + 2.0f * options_.traversalCost * node.bounds.halfArea();
        if (count <= options_.maxLeafPrimitives && !(splitCost < leafCost)) return node.begin;
        if (best.axis < 0) return middle;
        const BuildPrimitive* right =
            std::partition(primitives_ + node.begin, primitives_ + node.end,
                           [&](const BuildPrimitive& p) { return map.bin(p.bounds, best.axis) < best.bin; });
        return static_cast<uint32_t>(right - primitives_);
    }

    void sortAround(const BinaryNode& node, uint32_t middle, const Bounds& doubledCenters) {
        const Vec3 extent = doubledCenters.extent();
        const int axis = extent.x > extent.y ? (extent.x > extent.z ? 0 : 2) : (extent.y > extent.z ? 1 : 2);
        std::nth_element(primitives_ + node.begin, primitives_ + middle, primitives_ + node.end,
                         [axis](const BuildPrimitive& a, const BuildPrimitive& b) {
                             const float ca = a.bounds.lo[axis] + a.bounds.hi[axis];
                             const float cb = b.bounds.lo[axis] + b.bounds.hi[axis];
                             return ca < cb || (ca == cb && a.index < b.index);
                         });
    }

    Split findSplit(const BinaryNode& node, const BinMap& map) const {
        std::array<std::array<Bin, kBins>, 3> bins;
        for (uint32_t i = node.begin; i < node.end; ++i) {
            const Bounds& b = primitives_[i].bounds;
            for (int axis = 0; axis < 3; ++axis) {
                Bin& bin = bins[axis][map.bin(b, axis)];
                bin.bounds.grow(b);
                ++bin.count;
            }
        }
        Split best;
        for (int axis = 0; axis < 3; ++axis) {
            if (map.scale[axis] > 0.0f) sweep(bins[axis], axis, &best);
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

BinaryTree buildBinaryTree(std::vector<BuildPrimitive>* primitives, const BvhOptions& options) {
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
