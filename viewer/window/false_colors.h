// Numbers of a snapshot as colours for the screen: depths, normals, ids, errors, photons.
//
// Called by picture_source, on the UI thread for small pictures and by a job for others; how a number becomes
// a colour is engine/report/heat_map's. Nothing here knows of OpenGL.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/report/heat_map.h"
#include "viewer/window/viewer_model.h"

namespace glint {

/// Whether false colours stand for numbers on a scale, and its ends; {0, 0} when they do not. Signed: from
/// -largest to largest, black at 0.
struct MapScale {
    HeatScale heat;
    bool isSigned = false;
    bool isThere() const { return heat.largest > 0.0f; }
};

/// What is shown of this snapshot: its radiance where it has not what is wanted, as path tracing has no
/// photons, or where the reference is missing or of another size.
ShownImage imageOf(const FilmSnapshot& snapshot, ShownImage wanted, const LoadedReference* reference);

/// What a snapshot shows instead of `wanted`, and why, for the picture's corner; "" when it shows what
/// is wanted.
std::string instead(const FilmSnapshot& snapshot, ShownImage wanted, const LoadedReference* reference);

/// Mean of |t - r| over the three channels of a pixel of both pictures.
float errorAgainst(const LoadedReference& reference, const FilmSnapshot& snapshot, size_t pixel);

/// 4 bytes a pixel. Empty when the snapshot does not carry that picture (yet). `scale` goes in as the one to
/// use, or {} to find one, and comes back as the one that was used.
std::vector<uint8_t> falseColors(const FilmSnapshot& snapshot, ShownImage shown,
                                 const LoadedReference* reference, MapScale* scale);

/// The radiance as the shader shows it, 4 bytes a pixel.
std::vector<uint8_t> toneMappedColors(const FilmSnapshot& snapshot, float exposureStops, ToneMap map);

}  // namespace glint
