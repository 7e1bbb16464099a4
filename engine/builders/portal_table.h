// The rectangle through which alone an environment shines, and its image's light by directions out of it.
// Made by light_table.
#pragma once

#include <memory>
#include <vector>

#include "engine/kernels/light_view.h"
#include "engine/scene/light.h"

namespace glint {

/// The light of an image over the square of directions that PortalView describes.
struct PortalSums {
    SceneImage source;  ///< with these three compared to share the sums between builds
    Mat3 frame{1.0f};   ///< unit: along both edges, and where the portal's light goes
    float rotationRad = 0.0f;
    std::vector<double> sums;  ///< see PortalView
    int size = 0;
    float irradiance = 0.0f;  ///< luminance: what falls on the portal

    size_t bytes() const { return sums.size() * sizeof(double); }
};

/// The emitter that PortalView::opening is; its edges are made perpendicular. The corners must be those of a
/// rectangle (scene/light.h).
EmitterData portalOpening(const Environment& environment);

/// Sums `image`, an environment with its rotation set, over the directions out of the opening. Each cell has
/// a thousandth of the mean more than its light, so that none that a lookup can find is without probability.
/// `previous` (may be null) is returned itself where it is the same.
std::shared_ptr<const PortalSums> buildPortalSums(const SceneImage& source, const EnvironmentView& image,
                                                  float rotationRad, const EmitterData& opening,
                                                  const std::shared_ptr<const PortalSums>& previous,
                                                  int threads);

}  // namespace glint
