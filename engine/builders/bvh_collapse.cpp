// From a binary tree to wide nodes: each wide node opens its largest inner children until it is full (Wald,
// Benthin and Boulos 2008, "Getting Rid of Packets").
#include <algorithm>

#include "engine/base/check.h"
#include "engine/builders/bvh_builder.h"

namespace glint {
namespace {

class Collapser {
  public:
    explicit Collapser(const BinaryTree& tree) : tree_(tree) {}

    HugeVector<WideNode> run(const PackLeaves& packLeaves) {
        nodes_.reserve(tree_.count / 6 + 1);
        leaves_.reserve(tree_.count / 2 + 1);
        collapse(0);
        referTo(packLeaves(leaves_));
        return std::move(nodes_);
    }

  private:
    uint32_t collapse(uint32_t root) {
        uint32_t children[kNodeWidth] = {root};
        int count = 1;
        while (count < kNodeWidth) {
            const int opened = largestInner(children, count);
            if (opened < 0) { break; }
            const uint32_t parent = children[opened];
            children[opened] = tree_.nodes[parent].children;
            children[count++] = tree_.nodes[parent].children + 1;
        }
        const uint32_t index = static_cast<uint32_t>(nodes_.size());
        nodes_.push_back(emptyNode());
        for (int i = 0; i < count; ++i) {
            const BinaryNode& child = tree_.nodes[children[i]];
            const uint32_t reference = child.leaf() ? addLeaf(child) : collapse(children[i]);
            setChild(&nodes_[index], i, child.bounds(), reference);
        }
        return index;
    }

    /// A leaf for now refers to its place in leaves_.
    uint32_t addLeaf(const BinaryNode& leaf) {
        leaves_.push_back({leaf.begin, leaf.end});
        return kLeafBit | static_cast<uint32_t>(leaves_.size() - 1);
    }

    void referTo(const std::vector<LeafRange>& items) {
        for (WideNode& node : nodes_) {
            for (uint32_t& child : node.child) {
                if (!isLeaf(child)) { continue; }
                const LeafRange& range = items[child & ~kLeafBit];
                GLINT_CHECK_OP(range.end - range.begin, <=, kMaxLeafItems);
                GLINT_CHECK_OP(range.end - 1, <=, kMaxLeafFirst);
                child = makeLeaf(range.begin, range.end - range.begin);
            }
        }
    }

    int largestInner(const uint32_t* children, int count) const {
        int best = -1;
        float bestArea = -1.0f;
        for (int i = 0; i < count; ++i) {
            const BinaryNode& node = tree_.nodes[children[i]];
            const float area = node.bounds().halfArea();
            if (!node.leaf() && area > bestArea) {
                best = i;
                bestArea = area;
            }
        }
        return best;
    }

    static WideNode emptyNode() {
        WideNode node{};
        for (int axis = 0; axis < 3; ++axis) {
            std::fill_n(node.bounds[lowerRow(axis)], kNodeWidth, kInfinity);
            std::fill_n(node.bounds[lowerRow(axis) + 1], kNodeWidth, -kInfinity);
        }
        return node;
    }

    static void setChild(WideNode* node, int slot, const Bounds& bounds, uint32_t reference) {
        for (int axis = 0; axis < 3; ++axis) {
            node->bounds[lowerRow(axis)][slot] = bounds.lo[axis];
            node->bounds[lowerRow(axis) + 1][slot] = bounds.hi[axis];
        }
        node->child[slot] = reference;
    }

    const BinaryTree& tree_;
    HugeVector<WideNode> nodes_;
    std::vector<LeafRange> leaves_;
};

}  // namespace

HugeVector<WideNode> collapseTree(const BinaryTree& tree, const PackLeaves& packLeaves) {
    return Collapser(tree).run(packLeaves);
}

uint32_t traversalStackNeed(const HugeVector<WideNode>& nodes) {
    // Parents come before their children, so one sweep from the back has every child's need at hand.
    std::vector<uint32_t> need(nodes.size(), 0);
    for (size_t n = nodes.size(); n-- > 0;) {
        uint32_t children = 0;
        uint32_t deepest = 0;
        for (int i = 0; i < kNodeWidth; ++i) {
            if (!hasChild(nodes[n], i)) { continue; }
            ++children;
            if (!isLeaf(nodes[n].child[i])) { deepest = std::max(deepest, need[nodes[n].child[i]]); }
        }
        need[n] = children + deepest;
    }
    return need.empty() ? 0 : need[0];
}

}  // namespace glint
