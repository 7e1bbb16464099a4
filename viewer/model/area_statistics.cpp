#include "viewer/model/area_statistics.h"

#include <algorithm>
#include <cmath>

namespace glint {

/// Welford 1962.
AreaStatistics statisticsOf(const FilmSnapshot& snapshot, const FilmRegion& area) {
    AreaStatistics out;
    glm::dvec3 mean(0.0), squares(0.0);
    const int scale = snapshot.previewScale;
    const int right = std::min(snapshot.width, (area.x1 + scale - 1) / scale);
    const int bottom = std::min(snapshot.height, (area.y1 + scale - 1) / scale);
    for (int y = std::max(0, area.y0 / scale); y < bottom; ++y) {
        for (int x = std::max(0, area.x0 / scale); x < right; ++x) {
            const size_t i =
                3 * (static_cast<size_t>(y) * static_cast<size_t>(snapshot.width) + static_cast<size_t>(x));
            const glm::dvec3 value(snapshot.radiance[i], snapshot.radiance[i + 1], snapshot.radiance[i + 2]);
            if (!std::isfinite(value.x + value.y + value.z)) { continue; }
            const glm::dvec3 before = value - mean;
            mean += before / static_cast<double>(++out.pixels);
            squares += before * (value - mean);
        }
    }
    out.mean = Vec3(mean);
    if (out.pixels > 1) { out.deviation = Vec3(glm::sqrt(squares / static_cast<double>(out.pixels - 1))); }
    return out;
}

}  // namespace glint
