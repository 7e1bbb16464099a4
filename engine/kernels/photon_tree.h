// The other way to look for photons near a point: a balanced kd-tree over them. Host and device.
//
// It finds what photon_grid.h finds, in another order; it is kept so that the two can be compared. The tree
// is implicit: the photon in the middle of a range splits it, those before it are on the low side of the
// split plane.
#pragma once

#include "engine/base/view.h"
#include "engine/kernels/sppm_view.h"

namespace glint {

struct PhotonTreeView {
    View<Photon> photons;           ///< in tree order
    const uint8_t* axes = nullptr;  ///< split axis of the photon in the middle of each range, by photon

    /// Calls visit(photon) for every photon within `radius` of `center` along the split axes: a superset of
    /// the ball.
    template <class Visit>
    GLINT_HD void visitNear(const Vec3& center, float radiusWorld, Visit&& visit) const {
        constexpr int kMaxDepth = 34;
        const float radius = radiusWorld * 1.0001f;
        uint32_t stack[kMaxDepth][2];
        int size = 0;
        uint32_t begin = 0;
        uint32_t end = photons.count;
        while (true) {
            if (begin >= end) {
                if (size == 0) { return; }
                --size;
                begin = stack[size][0];
                end = stack[size][1];
                continue;
            }
            const uint32_t middle = begin + (end - begin) / 2;
            const int axis = axes[middle];
            const float distance = center[axis] - photons[middle].p[axis];
            if (std::fabs(distance) <= radius) {
                visit(photons[middle]);
                stack[size][0] = middle + 1;
                stack[size][1] = end;
                ++size;
                end = middle;
            } else if (distance < 0.0f) {
                end = middle;
            } else {
                begin = middle + 1;
            }
        }
    }
};

}  // namespace glint
