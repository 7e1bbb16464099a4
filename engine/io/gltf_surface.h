// glTF's numbers and models of surfaces as Glint's. Internal to the glTF importer.
#pragma once

#include <vector>

#include "engine/io/gltf_file.h"
#include "engine/scene/material.h"

namespace glint {

/// Within the limits; what is not finite becomes the least.
float gltfNumber(double value, double least, double most);
/// White where a factor is missing.
Vec3 gltfColor(const std::vector<double>& factor, double most = 1.0);

/// A colour of an extension, in [0, 1].
Vec3 gltfColor(const tinygltf::Value* extension, const char* key, const Vec3& otherwise = Vec3(1.0f));

/// The image of a texture that Glint reads, EXT_texture_webp's where there is one; -1: it has none.
int gltfImage(const tinygltf::Texture& texture);

/// KHR_materials_pbrSpecularGlossiness, which older files have, as a rough dielectric.
tinygltf::PbrMetallicRoughness gltfSurface(const tinygltf::Material& material);

/// KHR_materials_iridescence: the colours that the surface reflects at normal incidence, in its index and its
/// tints; images of its share and thickness count as their greatest values.
void takeIridescence(const tinygltf::Value& extension, Material* out);

/// Whether all light passes that is not reflected, untinted and without layers, as Glint's glass has it.
bool isOnlyGlass(const tinygltf::Material& material);

/// KHR_materials_volume of what light passes: without a thickness a sheet; otherwise what it absorbs inside.
/// Null: none.
void takeVolume(const tinygltf::Value* volume, Material* out);
/// KHR_materials_diffuse_transmission: the share that passes is taken from what is reflected. Images are left
/// to the caller.
void takeSheet(const tinygltf::Value& sheet, Material* out);

}  // namespace glint
