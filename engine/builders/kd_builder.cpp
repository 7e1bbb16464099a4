// The surface area heuristic with a bonus for empty cells, and primitives clipped to their cells (Wald and
// Havran 2006, "On building fast kd-trees for ray tracing, and on doing that in O(N log N)"). Many primitives
// are sorted into bins instead of by their boxes' sides (Shevtsov, Soupikov and Kapustin 2007, "Highly
// Parallel Fast KD-tree Construction for Interactive Ray Tracing of Dynamic Scenes").
#include "engine/builders/kd_builder.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "engine/base/check.h"
#include "engine/base/thread_limit.h"
#include "engine/kernels/kd_tree.h"

namespace glint {
namespace {

constexpr int kKdBins = 64;
constexpr uint32_t kFew = 32;               // up to so many, every side of a box is tried
constexpr uint32_t kTaskPrimitives = 4096;  // smaller subtrees are not worth a task
constexpr float kStepCost = 1.0f;
constexpr float kLeafCost = 2.0f;  // of as many primitives as are tested at the cost of one
constexpr float kEmptyBonus = 0.2f;
constexpr int kMaxBadSplits = 3;  // splits in a row that promise no gain: the next may bring it

/// A primitive's part of a cell.
struct Part {
    Bounds box;
    uint32_t index;
};

struct KdSplit {
    float cost = kInfinity;
    int axis = -1;
    float plane = 0.0f;
};

/// Nodes in depth-first order; a leaf's data is its number in `leaves`.
struct Tree {
    std::vector<KdNode> nodes;
    std::vector<uint32_t> items;
    std::vector<LeafRange> leaves;

    void append(const Tree& tree) {
        const auto nodeOffset = static_cast<uint32_t>(nodes.size());
        const auto leafOffset = static_cast<uint32_t>(leaves.size());
        const auto itemOffset = static_cast<uint32_t>(items.size());
        for (KdNode node : tree.nodes) {
            if (node.isLeaf()) {
                node.data += leafOffset;
            } else {
                node.link += nodeOffset << 2;
            }
            nodes.push_back(node);
        }
        for (const LeafRange& leaf : tree.leaves) {
            leaves.push_back({leaf.begin + itemOffset, leaf.end + itemOffset});
        }
        items.insert(items.end(), tree.items.begin(), tree.items.end());
    }
};

class KdBuilder {
  public:
    KdBuilder(const LeafOptions& options, const HugeVector<BuildPrimitive>& primitives)
        : options_(options),
          maxDepth_(std::min(kKdStackSize - 1,
                             8 + static_cast<int>(1.3f * std::log2(static_cast<float>(primitives.size()))))) {
        for (const BuildPrimitive& p : primitives) {
            bounds_.grow({p.lo, -p.negatedHi});
        }
    }

    const Bounds& bounds() const { return bounds_; }

    /// Appends the subtree over the parts in a cell. Takes the parts' memory.
    void build(const Bounds& cell, std::vector<Part>& parts, int depth, int badSplits, Tree* tree) const {
        const float leafCost = itemCost(parts.size());
        const KdSplit split = depth < maxDepth_ && leafCost > kLeafCost ? findSplit(cell, parts) : KdSplit{};
        badSplits = split.cost < leafCost ? 0 : badSplits + 1;
        if (split.axis < 0 || badSplits > kMaxBadSplits) { return addLeaf(parts, tree); }
        Bounds lowerCell = cell, upperCell = cell;
        lowerCell.hi[split.axis] = upperCell.lo[split.axis] = split.plane;
        std::vector<Part> lower, upper;
        distribute(parts, split, lowerCell, upperCell, &lower, &upper);
        const bool isLarge = parts.size() >= kTaskPrimitives;
        std::vector<Part>().swap(parts);
        const size_t node = tree->nodes.size();
        tree->nodes.push_back({std::bit_cast<uint32_t>(split.plane), static_cast<uint32_t>(split.axis)});
        if (!isLarge) {
            build(lowerCell, lower, depth + 1, badSplits, tree);
            linkUpper(node, tree);
            build(upperCell, upper, depth + 1, badSplits, tree);
            return;
        }
        Tree lowerTree, upperTree;
#pragma omp task default(none) shared(lowerTree, lower) firstprivate(lowerCell, depth, badSplits)
        build(lowerCell, lower, depth + 1, badSplits, &lowerTree);
        build(upperCell, upper, depth + 1, badSplits, &upperTree);
#pragma omp taskwait
        tree->append(lowerTree);
        linkUpper(node, tree);
        tree->append(upperTree);
    }

  private:
    static void linkUpper(size_t node, Tree* tree) {
        tree->nodes[node].link |= static_cast<uint32_t>(tree->nodes.size()) << 2;
    }

    static void addLeaf(const std::vector<Part>& parts, Tree* tree) {
        const auto begin = static_cast<uint32_t>(tree->items.size());
        for (const Part& part : parts) {
            tree->items.push_back(part.index);
        }
        tree->nodes.push_back({static_cast<uint32_t>(tree->leaves.size()), KdNode::kLeaf});
        tree->leaves.push_back({begin, static_cast<uint32_t>(tree->items.size())});
    }

    float itemCost(size_t primitives) const {
        const size_t together = options_.leafPrimitives;
        const size_t groups = (primitives + together - 1) / together;
        return kLeafCost * static_cast<float>(groups);
    }

    void consider(const Bounds& cell, int axis, float plane, size_t lower, size_t upper,
                  KdSplit* best) const {
        if (!(plane > cell.lo[axis] && plane < cell.hi[axis])) { return; }
        Bounds lowerCell = cell, upperCell = cell;
        lowerCell.hi[axis] = upperCell.lo[axis] = plane;
        const float share = itemCost(lower) * lowerCell.halfArea() + itemCost(upper) * upperCell.halfArea();
        const float bonus = lower == 0 || upper == 0 ? 1.0f - kEmptyBonus : 1.0f;
        const float cost = kStepCost + bonus * share / cell.halfArea();
        if (cost < best->cost) { *best = {cost, axis, plane}; }
    }

    KdSplit findSplit(const Bounds& cell, const std::vector<Part>& parts) const {
        KdSplit best;
        for (int axis = 0; axis < 3; ++axis) {
            if (parts.size() <= kFew) {
                trySides(cell, parts, axis, &best);
            } else {
                tryBins(cell, parts, axis, &best);
            }
        }
        return best;
    }

    void trySides(const Bounds& cell, const std::vector<Part>& parts, int axis, KdSplit* best) const {
        float lo[kFew], hi[kFew];
        const size_t count = parts.size();
        for (size_t i = 0; i < count; ++i) {
            lo[i] = parts[i].box.lo[axis];
            hi[i] = parts[i].box.hi[axis];
        }
        for (size_t side = 0; side < 2 * count; ++side) {
            const float plane = side < count ? lo[side] : hi[side - count];
            uint32_t lower = 0, upper = 0;
            for (size_t i = 0; i < count; ++i) {
                lower += lo[i] < plane ? 1 : 0;
                upper += hi[i] > plane ? 1 : 0;
            }
            consider(cell, axis, plane, lower, upper, best);
        }
    }

    void tryBins(const Bounds& cell, const std::vector<Part>& parts, int axis, KdSplit* best) const {
        const float perBin = (cell.hi[axis] - cell.lo[axis]) / kKdBins;
        const float scale = 1.0f / perBin;
        if (!std::isfinite(scale) || !(scale > 0.0f)) { return; }
        const auto binOf = [&](float x) {
            return static_cast<int>(std::clamp((x - cell.lo[axis]) * scale, 0.0f, kKdBins - 1.0f));
        };
        size_t begins[kKdBins] = {}, ends[kKdBins] = {};
        for (const Part& part : parts) {
            ++begins[binOf(part.box.lo[axis])];
            ++ends[binOf(part.box.hi[axis])];
        }
        size_t lower = 0, upper = parts.size();
        for (int bin = 1; bin < kKdBins; ++bin) {
            lower += begins[bin - 1];
            upper -= ends[bin - 1];
            consider(cell, axis, cell.lo[axis] + perBin * static_cast<float>(bin), lower, upper, best);
        }
    }

    void distribute(const std::vector<Part>& parts, const KdSplit& split, const Bounds& lowerCell,
                    const Bounds& upperCell, std::vector<Part>* lower, std::vector<Part>* upper) const {
        for (const Part& part : parts) {
            const bool isLower = part.box.lo[split.axis] < split.plane;
            const bool isUpper = part.box.hi[split.axis] > split.plane;
            if (isLower && isUpper) {
                addClipped(part, lowerCell, lower);
                addClipped(part, upperCell, upper);
            } else {
                (isUpper ? upper : lower)->push_back(part);
            }
        }
    }

    void addClipped(const Part& part, const Bounds& cell, std::vector<Part>* parts) const {
        Bounds box = part.box;
        if (options_.clip) {
            const Bounds clipped = options_.clip(part.index, cell);
            box = {glm::max(box.lo, clipped.lo), glm::min(box.hi, clipped.hi)};
        }
        box = {glm::max(box.lo, cell.lo), glm::min(box.hi, cell.hi)};
        if (!box.empty()) { parts->push_back({box, part.index}); }
    }

    const LeafOptions& options_;
    int maxDepth_;
    Bounds bounds_;
};

HugeVector<std::byte> memoryOf(const Bounds& bounds, Tree* tree, const std::vector<LeafRange>& items) {
    GLINT_CHECK_OP(tree->nodes.size(), <, size_t{1} << 30);
    for (KdNode& node : tree->nodes) {
        if (!node.isLeaf()) { continue; }
        const LeafRange& range = items[node.data];
        GLINT_CHECK_OP(range.end - range.begin, <, 1u << 30);
        node = {range.begin, KdNode::kLeaf | (range.end - range.begin) << 2};
    }
    HugeVector<std::byte> memory(sizeof(KdHeader) + tree->nodes.size() * sizeof(KdNode));
    std::fill_n(memory.begin(), sizeof(KdHeader), std::byte{0});  // what follows the bounds is padding
    std::memcpy(memory.data(), &bounds, sizeof(bounds));
    std::memcpy(memory.data() + sizeof(KdHeader), tree->nodes.data(), tree->nodes.size() * sizeof(KdNode));
    return memory;
}

}  // namespace

HugeVector<std::byte> buildKdTree(HugeVector<BuildPrimitive>* primitives, const LeafOptions& options,
                                  const PackLeaves& packLeaves) {
    const KdBuilder builder(options, *primitives);
    std::vector<Part> parts;
    parts.reserve(primitives->size());
    for (const BuildPrimitive& p : *primitives) {
        parts.push_back({{p.lo, -p.negatedHi}, p.index});
    }
    Tree tree;
    const int threads = parts.size() >= kTaskPrimitives ? startableThreads(options.threads) : 1;
    if (threads == 1) {
        builder.build(builder.bounds(), parts, 0, 0, &tree);
    } else {
#pragma omp parallel num_threads(threads)
#pragma omp single
        builder.build(builder.bounds(), parts, 0, 0, &tree);
    }
    primitives->clear();
    for (const uint32_t index : tree.items) {
        primitives->push_back(makeBuildPrimitive({Vec3(0.0f), Vec3(0.0f)}, index));
    }
    return memoryOf(builder.bounds(), &tree, packLeaves(tree.leaves));
}

}  // namespace glint
