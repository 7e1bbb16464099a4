// Materials of Wavefront MTL files, and what they mean here.
#pragma once

#include <string>

#include "engine/base/result.h"
#include "engine/io/mtl_reader.h"
#include "engine/scene/scene.h"

namespace glint {

/// An image that is not read.
struct MtlMap {
    std::string file;  ///< as written, relative to the MTL file; empty: none
    Texture shown;     ///< how, without the image
    int line = 0;      ///< of the MTL file
};

struct MtlMaterial {
    Material material;        ///< without textures
    MtlMap color;             ///< map_Kd
    MtlMap emission;          ///< map_Ke
    MtlMap roughness;         ///< map_Pr
    MtlMap crossRoughness{};  ///< the same, across its direction; where the material has such a roughness
    MtlMap metallic;          ///< map_Pm
    MtlMap height;            ///< map_Bump, bump
    float bumpFactor = 1.0f;  ///< -bm: multiplies what a height is for the model (obj_materials.h)
    MtlMap normal;            ///< norm
    MtlMap opacity;           ///< map_d, where it is another image than map_Kd, whose alpha counts by itself
    std::string glass;        ///< why it is read as glass: "d 0.1"; empty: it is not
    std::string doubt;        ///< what speaks for glass though it is read as opaque: "illum 4"; or empty
};

struct MtlLibrary {
    std::string path;
    MtlFile file;
    bool trIsOpacity = false;  ///< mtl_glass.h
};

/// Reads an MTL file; lines that cannot be read are left out with a remark. Error: the file cannot be read.
Result<MtlLibrary> loadMtl(const std::string& path);

/// What an entry becomes, with remarks on what Glint does not draw of it. The first that applies gives
/// the kind:
///   - Glass, a smooth dielectric with ior Ni, thin with ior 1.5 where Ni <= 1: by glassOf() in mtl_glass.h.
///   - Pm, Pr, Pc or Ps above 0 (the PBR extension): with Pm below 1, map_Pm, Pc or Ps a principled material
///   with a
///     coat of alpha Pcr squared; else with Pm a conductor whose reflectance at normal incidence is Kd, with
///     Pr plastic of Kd. GGX alpha is Pr squared; aniso divides it by an aspect of sqrt(1 - 0.9 aniso) along
///     the direction that anisor turns, in whole turns from u, and multiplies it across (Burley 2012).
///   - Kd black, Ks not, illum 3 or 5: mirror of Ks. Kd black, Ks not: GGX conductor whose reflectance at
///     normal incidence is Ks, by eta = (1 - r)/(1 + r), k = 2 sqrt(r)/(1 + r) per channel (Gulbrandsen 2014,
///     "Artist Friendly Metallic Fresnel", with edge tint 1).
///   - Kd and Ks not black, illum not 0 or 1: plastic of Kd, ior Ni where that is above 1, else 1.5; smooth
///     with illum 3, 5.
///   - else diffuse of Kd, 0.5 grey when there is no Kd.
/// Ns becomes the GGX alpha sqrt(2 / (Ns + 2)) (Walter et al. 2007, section 5.2, for Phong exponents).
/// Ke becomes emission, on both sides until emitter_sides.h knows better. map_Kd replaces Kd, and map_Ke Ke
/// but for its largest part, a factor where it is not 0 (a remark tells of a colour that is lost). map_Pr
/// replaces Pr and is squared. map_d cuts out, as does d from 0.5 to 1. Of the options of maps, -s, -o, -mm,
/// -clamp, -bm and -imfchan count. Ka and all other maps are left out, maps with a remark.
MtlMaterial materialOf(const MtlEntry& entry, MtlLibrary* library);

}  // namespace glint
