// A part of the picture that alone is rendered on; what is outside keeps the samples that it has.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

namespace glint {

/// Pixels [x0, x1) x [y0, y1).
struct FilmRegion {
    int x0 = 0;
    int y0 = 0;
    int x1 = 0;
    int y1 = 0;

    bool contains(int x, int y) const { return x >= x0 && x < x1 && y >= y0 && y < y1; }
    int64_t pixels() const { return static_cast<int64_t>(x1 - x0) * (y1 - y0); }
    bool operator==(const FilmRegion&) const = default;
};

/// What of it lies in a picture of this size; nothing where that has no pixel.
inline std::optional<FilmRegion> clipped(const FilmRegion& region, int width, int height) {
    const FilmRegion part{std::max(region.x0, 0), std::max(region.y0, 0), std::min(region.x1, width),
                          std::min(region.y1, height)};
    return part.x0 < part.x1 && part.y0 < part.y1 ? std::optional(part) : std::nullopt;
}

}  // namespace glint
