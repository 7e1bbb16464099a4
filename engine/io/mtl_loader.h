// Materials of Wavefront MTL files, and what they mean here. Called by obj_loader.cpp only.
#pragma once

#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/scene/scene.h"

namespace glint {

/// A material and the image that `map_Kd` names, not loaded yet.
struct MtlMaterial {
    Material material;     ///< color.texture is -1
    std::string colorMap;  ///< as written, relative to the MTL file; empty: none
    Vec2 colorMapScale{1.0f};
    std::string colorMapWarningPlace;  ///< `file:line` of the material
};

/// Reads an MTL file with tinyobjloader after checking that each number is one. Error: with line and column.
///
/// What the entries become (the first that applies gives the kind):
///   - illum 4, 6, 7 or 9, or d <= 0.5 (Tr >= 0.5): smooth dielectric with ior Ni; thin with ior 1.5 when Ni
///   <= 1. Its
///     tint is Tf where that is not black, else white. 0.5 < d < 1 is opaque, with a warning.
///   - Kd black, Ks not, illum 3 or 5: mirror of Ks. Kd black, Ks not: GGX conductor whose reflectance at
///   normal
///     incidence is Ks, by eta = (1 - r)/(1 + r), k = 2 sqrt(r)/(1 + r) per channel (Gulbrandsen 2014,
///     "Artist Friendly Metallic Fresnel", with edge tint 1).
///   - Kd and Ks not black, illum not 0 or 1: plastic of Kd, ior Ni where that is above 1, else 1.5; smooth
///   with illum 3, 5.
///   - else diffuse of Kd, 0.5 grey when there is no Kd.
/// Ns becomes the GGX alpha sqrt(2 / (Ns + 2)) (Walter et al. 2007, section 5.2, for Phong exponents).
/// Ke becomes emission, on both sides since windings in the wild cannot be trusted. map_Kd replaces Kd; only
/// its -s option counts. Ka and all other maps are left out, maps with a warning.
Result<std::vector<MtlMaterial>> loadMtl(const std::string& path, std::vector<std::string>* warnings);

}  // namespace glint
