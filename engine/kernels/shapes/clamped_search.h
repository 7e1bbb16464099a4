// One search by Newton's method that is kept on the curve, as the first program with such surfaces had it:
// from where the ray enters the profile's box, with the parameter clamped to the curve after each step. Host
// and device.
//
// It loses what it cannot reach: stems and feet of glasses, and whatever lies behind the first hit. It is
// here to be compared with profile_roots.h, which finds everything.
#pragma once

#include "engine/kernels/shapes/profile_roots.h"

namespace glint {

/// A place where a ray meets a profile; curve: kNone where none was found.
struct ClampedRoot {
    uint32_t curve = kNone;
    double s = 0.0, t = 0.0;  ///< the curve's parameter; from the ProfileRay's origin
    uint32_t steps = 0;
};

namespace detail {

/// Where the ray enters the profile's box, not before tMin.
GLINT_HD inline double boxEntry(const ProfileData& profile, const ProfileRay& ray, double tMin) {
    const double origin[] = {ray.ox, ray.oy, ray.oz}, direction[] = {ray.dx, ray.dy, ray.dz};
    const double half[] = {profile.radius, profile.halfHeight, profile.radius};
    double entry = tMin;
    for (int axis = 0; axis < 3; ++axis) {
        const double t = (-std::copysign(half[axis], direction[axis]) - origin[axis]) / direction[axis];
        if (std::isfinite(t) && t > entry) { entry = t; }
    }
    return entry;
}

}  // namespace detail

GLINT_ONE_PIECE_APART GLINT_HD inline ClampedRoot searchClamped(const ProfileView& profile,
                                                                const ProfileRay& ray, double tMin) {
    constexpr uint32_t kMostSteps = 20;
    constexpr double kClose = 1e-6;  // of the profile's size
    const ProfileData& data = *profile.data;
    const ProfileCurve& last = profile.curves[data.curveCount - 1];
    const double count = data.curveCount;
    ClampedRoot root;
    root.t = detail::boxEntry(data, ray, tMin);
    // Heights stand for the parameter at first.
    const double height = ray.oy + root.t * ray.dy;
    const bool falls = profile.curves[0].y[0] > last.y[last.degree];
    double along = count * 0.5 * (1.0 + (falls ? -height : height) / data.halfHeight);
    while (root.steps < kMostSteps) {
        ++root.steps;
        along = along > 0.0 ? along : 0.0;
        along = along < count ? along : count;
        const double whole = along < count ? std::floor(along) : count - 1.0;
        const auto index = static_cast<uint32_t>(whole);
        const ProfileCurve& curve = profile.curves[index];
        root.s = along - whole;
        detail::ProfilePoint at{evaluateBernstein<kMaxProfileDegree>(curve.x, curve.degree, root.s),
                                evaluateBernstein<kMaxProfileDegree>(curve.y, curve.degree, root.s)};
        at.y.value -= data.middle;
        const detail::RingMiss miss(at, ray, root.t);
        const double size = data.size();
        if (std::fabs(miss.height) < kClose * size && std::fabs(miss.ring) < kClose * size * size) {
            root.curve = index;
            return root;
        }
        along -= miss.stepS();
        root.t -= miss.stepT();
        if (!std::isfinite(along) || !std::isfinite(root.t)) { return root; }
    }
    return root;
}

}  // namespace glint
