// The placed shapes of a scene and the top-level acceleration structure over them.
#pragma once

#include <memory>
#include <vector>

#include "engine/builders/mesh_builder.h"
#include "engine/builders/profile_builder.h"
#include "engine/builders/tangent_builder.h"
#include "engine/scene/scene.h"

namespace glint {

struct InstanceTable {
    std::vector<InstanceData> instances;  ///< same indices as SceneDescription::objects
    std::vector<MeshView> meshes;         ///< same indices as SceneDescription::meshes
    ProfileTable profiles;                ///< of the surfaces of revolution
    Accelerator topLevel;                 ///< over all finite instances that are not empty
    std::vector<TopItem> topItems;
    std::vector<uint32_t> planes;
    Bounds bounds;  ///< of the finite instances; a single point at 0 when there are none

    /// Host pointers into this object.
    GeometryView view() const;
    size_t bytes() const;
};

/// `firstEmitter` has one entry per object (LightTable::firstEmitter), or is empty when nothing emits.
/// The description must be valid: indices in range, transforms invertible. The meshes and their tangents,
/// which may be empty, must outlive the table's users.
std::shared_ptr<const InstanceTable> buildInstances(
    const SceneDescription& scene, const std::vector<std::shared_ptr<const BuiltMesh>>& meshes,
    const std::vector<uint32_t>& firstEmitter,
    const std::vector<std::shared_ptr<const MeshTangents>>& tangents = {});

}  // namespace glint
