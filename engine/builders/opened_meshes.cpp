#include "engine/builders/opened_meshes.h"

#include <algorithm>

#include "engine/builders/bvh_builder.h"
#include "engine/kernels/bvh_nodes.h"

namespace glint {
namespace {

/// Two boxes overlap where what they share is more than this part of the smaller one. Boxes that touch, as
/// those of things that stand on each other, do not.
constexpr float kOverlap = 0.05f;
/// A box that overlaps very many others is compared with the first that are found.
constexpr int kMostNodesVisited = 256;

class MeshOpener {
  public:
    MeshOpener(const std::vector<Object>& objects, const std::vector<MeshView>& meshes,
               std::vector<TopEntry>* entries)
        : objects_(objects), meshes_(meshes), entries_(*entries), most_(entries->size() + kOpenedEntries) {}

    /// Opens the entries that overlap smaller ones. False when there are none, or no room.
    bool openOnce() {
        std::vector<uint32_t> marked = overlappingEntries();
        // The largest first: those at the same place in the list are opened in its order.
        std::stable_sort(marked.begin(), marked.end(), [&](uint32_t a, uint32_t b) {
            return entries_[a].box.halfArea() > entries_[b].box.halfArea();
        });
        bool opened = false;
        for (uint32_t i : marked) {
            if (entries_.size() + kNodeWidth - 1 > most_) { return false; }
            open(i);
            opened = true;
        }
        return opened;
    }

  private:
    bool canBeOpened(const TopEntry& entry) const {
        return objects_[entry.item.instance].shape == ShapeKind::Mesh && !isLeaf(entry.item.root);
    }

    std::vector<uint32_t> overlappingEntries() const {
        HugeVector<BuildPrimitive> boxes(entries_.size());
        for (uint32_t i = 0; i < entries_.size(); ++i) {
            boxes[i] = makeBuildPrimitive(entries_[i].box, i);
        }
        const BinaryTree tree = buildBinaryTree(&boxes, {});
        std::vector<char> isMarked(entries_.size(), 0);
        for (const TopEntry& entry : entries_) {
            markLarger(tree, boxes, entry, &isMarked);
        }
        std::vector<uint32_t> marked;
        for (uint32_t i = 0; i < entries_.size(); ++i) {
            if (isMarked[i]) { marked.push_back(i); }
        }
        return marked;
    }

    /// Marks what overlaps the entry, can be opened and is at least as large.
    void markLarger(const BinaryTree& tree, const HugeVector<BuildPrimitive>& boxes, const TopEntry& entry,
                    std::vector<char>* isMarked) const {
        const float area = entry.box.halfArea();
        uint32_t stack[kMostNodesVisited + 1] = {0};  // each visit takes one and leaves two at most
        int depth = 1;
        for (int visited = 0; depth > 0 && visited < kMostNodesVisited; ++visited) {
            const BinaryNode& node = tree.nodes[stack[--depth]];
            if (!(sharedPart(entry, node.bounds()) > kOverlap)) { continue; }
            if (!node.leaf()) {
                stack[depth++] = node.children;
                stack[depth++] = node.children + 1;
                continue;
            }
            const uint32_t other = boxes[node.begin].index;
            const TopEntry& larger = entries_[other];
            if (larger.item.instance == entry.item.instance || !canBeOpened(larger)) { continue; }
            if (larger.box.halfArea() >= area) { (*isMarked)[other] = 1; }
        }
    }

    /// The part of the entry's box that lies in the other, as a share of its volume. An extent of nothing but
    /// what it was widened by counts as 1.
    static float sharedPart(const TopEntry& entry, const Bounds& other) {
        float part = 1.0f;
        for (int axis = 0; axis < 3; ++axis) {
            const float own = entry.box.hi[axis] - entry.box.lo[axis];
            const float shared =
                std::min(entry.box.hi[axis], other.hi[axis]) - std::max(entry.box.lo[axis], other.lo[axis]);
            if (shared < 0.0f) { return 0.0f; }
            if (own > 4.0f * entry.pad[axis]) { part *= shared / own; }
        }
        return part;
    }

    void open(uint32_t index) {
        const TopEntry parent = entries_[index];
        const Object& object = objects_[parent.item.instance];
        const MeshView& mesh = meshes_[static_cast<size_t>(object.mesh)];
        const WideNode& node = mesh.accelerator.as<WideNode>()[parent.item.root];
        bool isFirst = true;
        for (int slot = 0; slot < kNodeWidth; ++slot) {
            if (!hasChild(node, slot)) { continue; }
            const Bounds own = childBounds(node, slot);
            const Bounds box = transformBounds(object.objectToWorld, own);
            const TopEntry child{{box.lo - parent.pad, box.hi + parent.pad},
                                 parent.pad,
                                 {parent.item.instance, node.child[slot]}};
            if (isFirst) {
                entries_[index] = child;
            } else {
                entries_.push_back(child);
            }
            isFirst = false;
        }
    }

    const std::vector<Object>& objects_;
    const std::vector<MeshView>& meshes_;
    std::vector<TopEntry>& entries_;
    size_t most_;
};

}  // namespace

void openOverlappingMeshes(const std::vector<Object>& objects, const std::vector<MeshView>& meshes,
                           std::vector<TopEntry>* entries) {
    if (entries->size() < 2 || entries->size() > kOpenedObjects) { return; }
    MeshOpener opener(objects, meshes, entries);
    while (opener.openOnce()) {}
}

}  // namespace glint
