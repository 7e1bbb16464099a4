// The scene ready for rendering: immutable flat arrays in shared parts. An edit makes a new BuiltScene that
// shares every part the edit did not touch. Never points into a SceneDescription.
#pragma once

#include <memory>
#include <vector>

#include "engine/kernels/features.h"
#include "engine/kernels/scene_view.h"

namespace glint {

struct BuiltMesh;      // builders/mesh_builder.h: one mesh with its acceleration structure
struct Recentring;     // builders/recentring.h: where a scene far from the origin was moved to
struct MeshTangents;   // builders/tangent_builder.h
struct InstanceTable;  // builders/instance_builder.h: instances and the top-level structure
struct MaterialTable;  // builders/material_table.h
struct TextureTable;   // builders/texture_table.h
struct LightTable;     // builders/light_table.h

struct BuiltScene {
    std::vector<std::shared_ptr<const BuiltMesh>> meshes;  ///< same indices as SceneDescription::meshes
    /// Same indices; null where nothing asks for them.
    std::vector<std::shared_ptr<const MeshTangents>> tangents;
    std::shared_ptr<const InstanceTable> instances;
    std::shared_ptr<const MaterialTable> materials;
    std::shared_ptr<const TextureTable> textures;
    std::shared_ptr<const LightTable> lights;
    FeatureMask features = 0;
    CameraData camera;
    std::shared_ptr<const Recentring> recentring;  ///< null: kernels see world coordinates (nearly always)

    /// World coordinates of what the view calls (0, 0, 0): added to every place that a user gets to see.
    Vec3 origin() const;
    /// Host pointers into this object's parts: valid while it lives.
    SceneView view() const;

    /// Whether all that kernels read is the same, but for features that only one of them needs. False where
    /// parts are missing.
    bool looksLike(const BuiltScene& other) const;
};

}  // namespace glint
