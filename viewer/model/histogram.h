// How often each display value occurs in a picture.
#pragma once

#include <array>

#include "engine/render/film_snapshot.h"
#include "engine/render/tonemap.h"

namespace glint {

struct Histogram {
    static constexpr size_t kBins = 64;
    /// Shares of the pixels, for red, green and blue, from black to white.
    std::array<std::array<float, kBins>, 3> bins{};
    float black = 0.0f;  ///< share of the pixels that have 0 in all channels
    float white = 0.0f;  ///< share of the pixels that have 255 in any of them
};

/// Of the radiance as it is shown; of large pictures some of the pixels, evenly spread.
Histogram histogramOf(const FilmSnapshot& snapshot, const DisplayLook& look);

}  // namespace glint
