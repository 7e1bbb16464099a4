// An area of the picture in numbers.
#pragma once

#include "engine/math/vec.h"
#include "engine/render/film_region.h"
#include "engine/render/film_snapshot.h"

namespace glint {

struct AreaStatistics {
    uint64_t pixels = 0;  ///< of the snapshot, which may be a preview; those that are not finite do not count
    Vec3 mean{0.0f};      ///< linear radiance
    Vec3 deviation{
        0.0f};  ///< standard deviation from pixel to pixel, unbiased variance's root; 0 of one pixel
};

/// `area` counts in full resolution and is cut to the picture.
AreaStatistics statisticsOf(const FilmSnapshot& snapshot, const FilmRegion& area);

}  // namespace glint
