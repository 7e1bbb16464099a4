// What the top level of the acceleration structure is built over: objects, and parts of those meshes that
// overlap others (Benthin, Woop, Wald and Afra 2017, "Improved Two-Level BVHs using Partial Re-Braiding",
// HPG). The meshes of one building, a file of it for each material, all have the building's box: without
// their parts, each ray would walk every one of them.
#pragma once

#include <vector>

#include "engine/builders/build_primitive.h"
#include "engine/kernels/geometry_view.h"
#include "engine/scene/scene.h"

namespace glint {

/// A finite object, or a part of it, and its box in world space.
struct TopEntry {
    Bounds box;
    Vec3 pad;  ///< what the object's whole box was widened by
    TopItem item;
};

/// Replaces meshes in `entries`, at first one entry an object, by the children of their nodes as long as they
/// overlap an entry of another object that is no larger. At most kOpenedEntries more become of them; scenes
/// of more than kOpenedObjects objects stay as they are. Hierarchies of boxes only. The same for any number
/// of threads.
void openOverlappingMeshes(const std::vector<Object>& objects, const std::vector<MeshView>& meshes,
                           std::vector<TopEntry>* entries);

constexpr size_t kOpenedEntries = 2048;
constexpr size_t kOpenedObjects = 4096;

}  // namespace glint
