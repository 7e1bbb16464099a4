// Roughness of two directions as KHR_materials_anisotropy has it: along a direction alpha is mix(alpha, 1,
// strength^2), across it stays.
#pragma once

#include "engine/io/gltf_writer.h"
#include "engine/scene/material.h"

namespace glint {

/// Whether the material is anisotropic, and without images of its two alphas.
bool isEvenlyAnisotropic(const Material& material);
/// The alpha that glTF's roughness stands for: the smaller one of two.
float leastAlpha(const Material& material);
/// The extension of a material that is evenly anisotropic. isFlipped: glTF's v runs against the material's.
GltfJson gltfAnisotropy(const Material& material, bool isFlipped);

}  // namespace glint
