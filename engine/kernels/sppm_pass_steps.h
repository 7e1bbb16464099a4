// What an SPPM pass does with each pixel between its kernels: the space of the photons, gathering, the
// update. Host and device.
//
// The back ends call these from their loops and launches, so that a pass is written once. Bounds and levels
// are taken over slices of the picture: their union does not depend on how it is cut.
#pragma once

#include <limits>

#include "engine/kernels/photon_grid.h"
#include "engine/kernels/sppm_gather_kernel.h"

namespace glint {

/// Every `step`-th pixel of [begin, end).
struct PixelSlice {
    size_t begin = 0;
    size_t end = 0;
    size_t step = 1;
};

/// Within which distance, squared, a pixel counts photons in this pass.
GLINT_HD inline double searchRadiusSquared(const SppmParams& params, const SppmPixel& statistics,
                                           const VisiblePoint& point) {
    return statistics.radiusSquared > 0.0 ? statistics.radiusSquared
                                          : initialRadiusSquared(params, point.footprint);
}

/// The box around the slice's visible points and their radii.
GLINT_HD inline Bounds searchBounds(const SppmParams& params, const SppmPixel* statistics,
                                    const PassPixel* pixels, const PixelSlice& slice) {
    Bounds bounds;
    for (size_t i = slice.begin; i < slice.end; i += slice.step) {
        const VisiblePoint& point = pixels[i].visiblePoint;
        if (isZero(point.throughput)) { continue; }
        const Vec3 radius(static_cast<float>(std::sqrt(searchRadiusSquared(params, statistics[i], point))));
        bounds.grow(point.p - radius);
        bounds.grow(point.p + radius);
    }
    return bounds;
}

/// The grid that covers the box around all visible points. Any grid will do when there are none.
GLINT_HD inline GridSpace gridSpaceFor(const Bounds& all) {
    GridSpace space;
    if (all.empty()) { return space; }
    constexpr float kSlack = 1.0001f;  // rounding must not push a point out of its own box
    const float cell = maxComponent(all.extent()) * kSlack / static_cast<float>(1 << kGridBitsPerAxis);
    space.origin = all.lo;
    space.finestCell = maxf(cell, std::numeric_limits<float>::min());
    return space;
}

/// Bit l: gathering for the slice will ask for cells of level l.
GLINT_HD inline uint32_t searchLevels(const SppmParams& params, const GridSpace& space,
                                      const SppmPixel* statistics, const PassPixel* pixels,
                                      const PixelSlice& slice) {
    uint32_t levels = 0;
    for (size_t i = slice.begin; i < slice.end; i += slice.step) {
        const VisiblePoint& point = pixels[i].visiblePoint;
        if (isZero(point.throughput)) { continue; }
        const double radius = std::sqrt(searchRadiusSquared(params, statistics[i], point));
        levels |= 1u << space.levelFor(static_cast<float>(radius));
    }
    return levels;
}

/// Replaces the visible point of pixel (x, y) by what was found around it.
template <FeatureMask kMask, class PhotonMap>
GLINT_HD void gatherPixel(const SceneView& view, const PhotonMap& photons, const SppmParams& params, int x,
                          int y, const SppmPixel& statistics, PassPixel* pixel) {
    const VisiblePoint point = pixel->visiblePoint;
    Gathered gathered;
    if (!isZero(point.throughput)) {
        const float radiusSquared = static_cast<float>(searchRadiusSquared(params, statistics, point));
        gathered = gatherPhotons<kMask>(view, photons, params, statistics, makeSampler(params.pass, x, y),
                                        point, radiusSquared);
        gathered.initialRadiusSquared = radiusSquared;
    }
    pixel->gathered = gathered;
}

/// Enters what the pass gathered into the pixel's statistics.
GLINT_HD inline void commitPixel(const SppmParams& params, const Gathered& gathered, SppmPixel* statistics) {
    if (!(statistics->radiusSquared > 0.0)) {
        statistics->radiusSquared = static_cast<double>(gathered.initialRadiusSquared);
    }
    updatePixel(gathered, params.alpha, params.pass.pass, params.photonsPerPass, statistics);
}

}  // namespace glint
