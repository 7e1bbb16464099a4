// A small copy of a picture, for lists.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/render/film_snapshot.h"
#include "engine/render/tonemap.h"

namespace glint {

struct Thumbnail {
    int width = 0;
    int height = 0;
    std::vector<uint8_t> rgba{};  ///< as the screen shows it, row 0 at the top
    uint64_t id = 0;              ///< newThumbnailId(), for what is made of it; 0: there are no pixels
};

/// Another one each time, on any thread.
uint64_t newThumbnailId();

/// Means of the picture's pixels, in a square of that side.
Thumbnail makeThumbnail(const FilmSnapshot& image, const DisplayLook& look, int side);

}  // namespace glint
