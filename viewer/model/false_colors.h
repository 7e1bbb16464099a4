// Numbers of a snapshot as colours for the screen, as the table of shown images says.
//
// How a number becomes a colour is engine/report/heat_map's. Nothing here knows of OpenGL.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/report/heat_map.h"
#include "viewer/model/shown_image.h"

namespace glint {

/// Whether false colours stand for numbers on a scale, and its ends; {0, 0} when they do not. Signed: from
/// -largest to largest, black at 0.
struct MapScale {
    HeatScale heat;
    bool isSigned = false;
    bool isThere() const { return heat.largest > 0.0f; }
};

/// 4 bytes a pixel. Empty when the snapshot does not carry that picture (yet). `scale` goes in as the one to
/// use, or {} to find one, and comes back as the one that was used.
std::vector<uint8_t> falseColors(const FilmSnapshot& snapshot, ShownImage shown,
                                 const LoadedReference* reference, MapScale* scale);

/// Of a value a pixel; `scale` as above.
std::vector<uint8_t> mapColors(const std::vector<float>& values, MapColors how, MapScale* scale);

/// The radiance as the shader shows it, 4 bytes a pixel.
std::vector<uint8_t> toneMappedColors(const FilmSnapshot& snapshot, const DisplayLook& look);

}  // namespace glint
