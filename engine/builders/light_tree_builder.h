// Builds the binary tree over emitters that kernels/light_tree.h walks.
#pragma once

#include <vector>

#include "engine/kernels/light_view.h"

namespace glint {

/// The smallest node (with both sides, cone and sphere joined) around two; a node without intensity
/// is neutral.
LightNode joinLightNodes(const LightNode& a, const LightNode& b);

struct LightTree {
    std::vector<LightNode> nodes;        ///< root first; 2 n - 1 of them
    std::vector<uint32_t> emitterNodes;  ///< the leaf of each emitter
};

/// `leaves[i]` bounds emitter i; at least one. Splits along the axis and place that the surface area
/// orientation heuristic favours (Conty Estevez and Kulla 2018, section 4.4). Depends on nothing but
/// the leaves.
LightTree buildLightTree(const std::vector<LightNode>& leaves);

}  // namespace glint
