// Where the nodes of a glTF file are, and the lights and joints among them.
#pragma once

#include <optional>
#include <vector>

#include "engine/io/gltf_file.h"
#include "engine/math/transform.h"
#include "engine/scene/light.h"

namespace glint {

/// Lumens at 555 nm, as exporters of watts count.
constexpr double kLumensPerWatt = 683.0;

/// Within its parent.
Affine placementOf(const tinygltf::Node& node);

/// EXT_mesh_gpu_instancing: where within the node its mesh is; once at the node itself without it. Error: as
/// the accessors'; there are very many.
Result<std::vector<Affine>> instancesOf(const GltfFile& file, const tinygltf::Node& node);

/// Of the scene that the file shows; of all nodes where it has none.
std::vector<int> rootsOf(const tinygltf::Model& model);

/// From the mesh's space to the world, for each joint of a skin. Error: there is no such skin or node.
Result<std::vector<Affine>> jointsOf(const GltfFile& file, int skin, const std::vector<Affine>& nodesToWorld);

/// Candela and lux are counted as watts per steradian and square metre, 683 lm each. Nothing: it has
/// no direction.
std::optional<Light> lightOf(const tinygltf::Light& from, const Affine& toWorld);

}  // namespace glint
