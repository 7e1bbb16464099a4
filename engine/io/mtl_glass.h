// Which materials of an MTL file are glass: decided from d, Tr, Tf, Ni and illum together, since each of them
// alone is written for opaque ones by some exporter. For mtl_loader.cpp only.
#pragma once

#include <string>
#include <vector>

#include "engine/io/mtl_reader.h"
#include "engine/math/vec.h"

namespace glint {

struct MtlGlass {
    bool isGlass = false;
    Vec3 tint{1.0f};       ///< of glass
    std::string why;       ///< what made it glass, or speaks for glass though it is none
    float opacity = 1.0f;  ///< of what is not glass
};

/// How a file's exporter writes a Tr without d: 1 means opaque, or transparent.
bool trIsOpacity(const std::vector<MtlEntry>& entries);

/// The first that applies:
///   - map_d: not glass, whatever d is. Pm from 0.5 on: metal, of the opacity that d says.
///   - d, or without it Tr strictly between 0 and 1 as the file's other materials have it: at most 0.3 is
///     glass, or at most 0.1 where Kd has a hue that glass would lose; between that and 1 is so opaque. d 0
///     beside Tr 0 contradict each other, and d 0 beside map_Kd is no glass that Glint could draw: opaque.
///   - illum 6 or 7 (refraction) with Ni above 1, without map_Kd: glass.
///   - illum 4, 6, 7 or 9 where neither d nor Tr says anything: a coloured Tf is glass of this tint; a grey
///     one is 1 minus the transparency, by the limits of d, as Maya writes illum 4 with Tf 1 1 1 and Ni 1 for
///     every opaque material; without Tf, glass where Ni is missing or above 1.
///   - else opaque. Tr 1 or 0 alone says nothing: exporters write either for opaque ones.
MtlGlass glassOf(const MtlEntry& entry, const tinyobj::material_t& values, bool trIsOpacity);

}  // namespace glint
