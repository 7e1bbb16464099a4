#include "viewer/model/region_tool.h"

#include <algorithm>

namespace glint {

FilmRegion regionBetween(Vec2i a, Vec2i b) {
    return {std::min(a.x, b.x), std::min(a.y, b.y), std::max(a.x, b.x) + 1, std::max(a.y, b.y) + 1};
}

FilmRegion spotAround(Vec2i pixel, int imageHeight) {
    const int side = std::max(imageHeight / 6, 16);
    const int step = std::max(side / 4, 4);
    const Vec2i middle = (pixel + step / 2) / step * step;
    const Vec2i corner = middle - side / 2;
    return {corner.x, corner.y, corner.x + side, corner.y + side};
}

}  // namespace glint
