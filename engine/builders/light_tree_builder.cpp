#include "engine/builders/light_tree_builder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "engine/math/bounds.h"

namespace glint {
namespace {

constexpr int kLightTreeBins = 12;
/// Larger groups are split along their longest axis only: near the root directions hardly separate
/// anything yet.
constexpr size_t kAllAxesCount = 1024;

Bounds boxOf(const LightNode& node) {
    Bounds box;
    box.grow(node.center - Vec3(node.radius));
    box.grow(node.center + Vec3(node.radius));
    return box;
}

/// A node under construction, with the box that its sphere will be drawn around.
struct Group {
    LightNode node;
    Bounds box;

    void add(const Group& other) {
        node = joinLightNodes(node, other.node);
        box.grow(other.box);
    }
    bool empty() const { return box.empty(); }
};

/// The orientation measure of the surface area orientation heuristic (Conty Estevez and Kulla 2018,
/// equation 1).
double orientationMeasure(const LightNode& node) {
    const double normals = std::acos(std::clamp(static_cast<double>(node.cosNormals), -1.0, 1.0));
    const double emission = std::acos(std::clamp(static_cast<double>(node.cosEmission), -1.0, 1.0));
    const double reach = std::min(normals + emission, std::numbers::pi);
    const double measure = 2.0 * std::numbers::pi * (1.0 - std::cos(normals)) +
                           0.5 * std::numbers::pi *
                               (2.0 * reach * std::sin(normals) - std::cos(normals - 2.0 * reach) -
                                2.0 * normals * std::sin(normals) + std::cos(normals));
    return node.bothSides ? 2.0 * measure : measure;
}

double groupCost(const Group& group) {
    const Vec3 extent = group.box.extent();
    // Lights in a row have no area; their length still tells near from far.
    const double area =
        static_cast<double>(group.box.halfArea()) + 1e-3 * static_cast<double>(lengthSquared(extent));
    return static_cast<double>(group.node.intensity) * orientationMeasure(group.node) * area;
}

struct LightTreeSplit {
    double cost = std::numeric_limits<double>::infinity();
    int axis = -1;
    float lo = 0.0f;
    float scale = 0.0f;  ///< bins per world unit
    int lastLeft = 0;    ///< bins up to this one go left

    int binOf(const Vec3& center) const {
        return std::clamp(static_cast<int>((center[axis] - lo) * scale), 0, kLightTreeBins - 1);
    }
};

class LightTreeBuilder {
  public:
    explicit LightTreeBuilder(const std::vector<LightNode>& leaves) : leaves_(leaves), order_(leaves.size()) {
        for (size_t i = 0; i < order_.size(); ++i) {
            order_[i] = static_cast<uint32_t>(i);
        }
        tree_.nodes.resize(2 * leaves.size() - 1);
        tree_.emitterNodes.resize(leaves.size());
    }

    LightTree build() {
        buildNode(0, 0, 0, order_.size());
        return std::move(tree_);
    }

  private:
    /// Fills node `index` from order_[begin, end) and returns it with its box. Depth stays near log2(n):
    /// every split that the heuristic makes lopsided for long is replaced by a median one.
    Group buildNode(uint32_t index, uint32_t parent, size_t begin, size_t end, int depth = 0) {
        LightNode& node = tree_.nodes[index];
        if (end - begin == 1) {
            const uint32_t emitter = order_[begin];
            node = leaves_[emitter];
            node.child = emitter;
            node.parent = parent;
            node.isLeaf = true;
            tree_.emitterNodes[emitter] = index;
            return {node, boxOf(node)};
        }
        const size_t middle = depth < 64 ? partition(begin, end) : begin + (end - begin) / 2;
        const uint32_t child = nextNode_;
        nextNode_ += 2;
        Group group = buildNode(child, index, begin, middle, depth + 1);
        group.add(buildNode(child + 1, index, middle, end, depth + 1));
        group.node.center = group.box.center();
        group.node.radius = 0.5f * std::sqrt(lengthSquared(group.box.extent())) * (1.0f + 1e-6f);
        node = group.node;
        node.child = child;
        node.parent = parent;
        node.isLeaf = false;
        return group;
    }

    size_t partition(size_t begin, size_t end) {
        Bounds centers;
        for (size_t i = begin; i < end; ++i) {
            centers.grow(leaves_[order_[i]].center);
        }
        const Vec3 extent = centers.extent();
        const int longest = extent.x >= extent.y && extent.x >= extent.z ? 0 : (extent.y >= extent.z ? 1 : 2);
        LightTreeSplit best;
        for (int axis = 0; axis < 3; ++axis) {
            if (end - begin > kAllAxesCount && axis != longest) { continue; }
            if (extent[axis] > 0.0f) {
                tryAxis(centers, axis, extent[longest] / extent[axis], begin, end, &best);
            }
        }
        const size_t half = begin + (end - begin) / 2;
        if (best.axis < 0) { return half; }
        const auto first = order_.begin();
        const auto middle = std::stable_partition(
            first + static_cast<ptrdiff_t>(begin), first + static_cast<ptrdiff_t>(end),
            [&](uint32_t emitter) { return best.binOf(leaves_[emitter].center) <= best.lastLeft; });
        const auto split = static_cast<size_t>(middle - first);
        return split == begin || split == end ? half : split;
    }

    /// `stretch`: penalty against cutting thin boxes lengthwise (longest edge over this edge).
    void tryAxis(const Bounds& centers, int axis, float stretch, size_t begin, size_t end,
                 LightTreeSplit* best) {
        LightTreeSplit split;
        split.axis = axis;
        split.lo = centers.lo[axis];
        split.scale = static_cast<float>(kLightTreeBins) / (centers.hi[axis] - centers.lo[axis]);
        if (!std::isfinite(split.scale)) { return; }
        std::array<Group, kLightTreeBins> bins;
        for (size_t i = begin; i < end; ++i) {
            const LightNode& leaf = leaves_[order_[i]];
            bins[static_cast<size_t>(split.binOf(leaf.center))].add({leaf, boxOf(leaf)});
        }
        std::array<double, kLightTreeBins> rightCosts{};
        Group right;
        for (size_t i = kLightTreeBins - 1; i > 0; --i) {
            right.add(bins[i]);
            rightCosts[i] = right.empty() ? -1.0 : groupCost(right);
        }
        Group left;
        for (size_t i = 0; i + 1 < kLightTreeBins; ++i) {
            left.add(bins[i]);
            if (left.empty() || rightCosts[i + 1] < 0.0) { continue; }
            split.cost = static_cast<double>(stretch) * (groupCost(left) + rightCosts[i + 1]);
            split.lastLeft = static_cast<int>(i);
            if (split.cost < best->cost) { *best = split; }
        }
    }

    const std::vector<LightNode>& leaves_;
    std::vector<uint32_t> order_;
    LightTree tree_;
    uint32_t nextNode_ = 1;
};

struct Cone {
    glm::dvec3 axis;
    double angle;
};

/// The smallest cone around two (Conty Estevez and Kulla 2018, algorithm 1).
Cone joinCones(Cone a, Cone b) {
    if (b.angle > a.angle) { std::swap(a, b); }
    const double between = std::acos(std::clamp(glm::dot(a.axis, b.axis), -1.0, 1.0));
    if (between + b.angle <= a.angle) { return a; }
    const double angle = 0.5 * (a.angle + between + b.angle);
    if (angle >= std::numbers::pi) { return {a.axis, std::numbers::pi}; }
    const glm::dvec3 across = b.axis - glm::dot(a.axis, b.axis) * a.axis;
    const double length = glm::length(across);
    if (length < 1e-12) { return {a.axis, between > 1.0 ? std::numbers::pi : angle}; }
    const double turn = angle - a.angle;
    return {glm::normalize(std::cos(turn) * a.axis + std::sin(turn) * (across / length)), angle};
}

Cone coneOf(const LightNode& node) {
    return {glm::dvec3(node.axis), std::acos(std::clamp(static_cast<double>(node.cosNormals), -1.0, 1.0))};
}

}  // namespace

LightNode joinLightNodes(const LightNode& a, const LightNode& b) {
    if (a.intensity <= 0.0f) { return b; }
    if (b.intensity <= 0.0f) { return a; }
    LightNode joined = a;
    joined.intensity = a.intensity + b.intensity;
    joined.cosEmission = std::min(a.cosEmission, b.cosEmission);
    joined.bothSides = a.bothSides || b.bothSides;
    Cone coneB = coneOf(b);
    // An axis of lights that shine both ways has no sign of its own.
    if (joined.bothSides && glm::dot(a.axis, b.axis) < 0.0f) { coneB.axis = -coneB.axis; }
    const Cone cone = joinCones(coneOf(a), coneB);
    joined.axis = Vec3(cone.axis);
    // The axis is rounded to float: a little wider keeps the cone conservative.
    joined.cosNormals = static_cast<float>(std::cos(std::min(cone.angle + 1e-6, std::numbers::pi)));
    Bounds box = boxOf(a);
    box.grow(boxOf(b));
    joined.center = box.center();
    joined.radius = 0.5f * std::sqrt(lengthSquared(box.extent()));
    return joined;
}

LightTree buildLightTree(const std::vector<LightNode>& leaves) { return LightTreeBuilder(leaves).build(); }

}  // namespace glint
