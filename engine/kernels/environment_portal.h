// Light of an environment that comes through a rectangle alone: which directions are open, and choosing one
// of them, by the image's brightness within what is seen through the portal, or else uniformly.
//
// Bitterli, Novak and Jarosz 2015, "Portal-Masked Environment Map Sampling". The sums come from
// builders/portal_table.
#pragma once

#include "engine/kernels/light_view.h"
#include "engine/kernels/shapes/rectangle.h"
#include "engine/math/frame.h"
#include "engine/math/warp.h"

namespace glint {

struct DirectionSample {
    Vec3 wiWorld{0.0f};
    float pdfSolidAngle = 0.0f;
};

GLINT_HD inline bool hasPortal(const PortalView& portal) { return portal.opening.area > 0.0f; }

/// Whether light from the unit direction `w` comes to `p` through the portal, from its back to its front.
GLINT_HD inline bool seesThroughPortal(const PortalView& portal, const Vec3& p, const Vec3& w) {
    const EmitterData& e = portal.opening;
    const float cosine = -glm::dot(w, e.direction);
    const Vec3 d = p - e.position;
    const float distance = glm::dot(d, e.direction);
    if (!(cosine > 0.0f && distance > 0.0f)) { return false; }
    const Vec3 place = d + w * (distance / cosine);
    return std::fabs(glm::dot(place, e.axisU)) <= lengthSquared(e.axisU) &&
           std::fabs(glm::dot(place, e.axisV)) <= lengthSquared(e.axisV);
}

/// A part of the square of directions, in cells.
struct PortalWindow {
    double x0 = 0.0, y0 = 0.0, x1 = 0.0, y1 = 0.0;
};

/// Where the ratio of a direction's component along an edge to that out of the portal lies in the square,
/// in cells.
GLINT_HD inline double portalCell(const PortalView& portal, float ratio) {
    return static_cast<double>(portal.size) * (0.5 + static_cast<double>(std::atan(ratio) * kInvPi));
}

/// What is seen from `p`, which lies before the front.
GLINT_HD inline PortalWindow portalWindow(const PortalView& portal, const Vec3& p) {
    const EmitterData& e = portal.opening;
    const Vec3 d = e.position - p;
    const float perDistance = 1.0f / maxf(-glm::dot(d, e.direction), 1e-30f);
    const float halfU = glm::length(e.axisU), halfV = glm::length(e.axisV);
    const float u = glm::dot(d, e.axisU) / halfU, v = glm::dot(d, e.axisV) / halfV;
    return {portalCell(portal, (u - halfU) * perDistance), portalCell(portal, (v - halfV) * perDistance),
            portalCell(portal, (u + halfU) * perDistance), portalCell(portal, (v + halfV) * perDistance)};
}

/// The sum of all that lies before x and y, in cells; each cell is even within.
GLINT_HD inline double portalSum(const PortalView& portal, double x, double y) {
    const int last = portal.size - 1;
    const int column = static_cast<int>(x) < last ? static_cast<int>(x) : last;
    const int row = static_cast<int>(y) < last ? static_cast<int>(y) : last;
    const double fx = x - column, fy = y - row;
    const size_t width = static_cast<size_t>(portal.size) + 1;
    const double* at = portal.sums + static_cast<size_t>(row) * width + static_cast<size_t>(column);
    const double* next = at + width;
    return (1.0 - fy) * ((1.0 - fx) * at[0] + fx * at[1]) + fy * ((1.0 - fx) * next[0] + fx * next[1]);
}

GLINT_HD inline double portalSum(const PortalView& portal, const PortalWindow& w) {
    return (portalSum(portal, w.x1, w.y1) - portalSum(portal, w.x0, w.y1)) -
           (portalSum(portal, w.x1, w.y0) - portalSum(portal, w.x0, w.y0));
}

/// The place between `low` and `high` at which sumTo(place), which begins at 0, has come to `wanted`; it
/// rises evenly between whole numbers. The whole numbers around it are stored in *below and *above, as far as
/// they lie between `low` and `high`.
template <class SumTo>
GLINT_HD inline double findSum(double low, double high, double wanted, const SumTo& sumTo, double* below,
                               double* above) {
    int first = static_cast<int>(low), end = static_cast<int>(high) + 1;
    while (end - first > 1) {
        const int middle = (first + end) / 2;
        if (static_cast<double>(middle) < high && sumTo(static_cast<double>(middle)) <= wanted) {
            first = middle;
        } else {
            end = middle;
        }
    }
    *below = static_cast<double>(first) > low ? static_cast<double>(first) : low;
    *above = static_cast<double>(end) < high ? static_cast<double>(end) : high;
    const double before = sumTo(*below), rise = sumTo(*above) - before;
    const double share = rise > 0.0 ? (wanted - before) / rise : 0.5;
    return *below + (share < 0.0 ? 0.0 : (share > 1.0 ? 1.0 : share)) * (*above - *below);
}

/// Density per solid angle of the cell at (x, y) among `whole`, for a direction with these cosines to the
/// portal's edges and to its normal, which is positive: d(solid angle) is (1 - u^2) (1 - v^2) / normal
/// times d(angles).
GLINT_HD inline float portalPdf(const PortalView& portal, double whole, double x, double y, float cosU,
                                float cosV, float cosNormal) {
    const double last = static_cast<double>(portal.size - 1);
    const double column = std::floor(x < last ? x : last), row = std::floor(y < last ? y : last);
    const double cell = portalSum(portal, PortalWindow{column, row, column + 1.0, row + 1.0});
    const float perAngles = square(static_cast<float>(portal.size) * kInvPi);
    // 1 - cosine^2 of the one is the sum of the squares of the others, which keeps its digits.
    const float spread = (square(cosV) + square(cosNormal)) * (square(cosU) + square(cosNormal));
    return spread > 0.0f ? static_cast<float>(cell / whole) * perAngles * cosNormal / spread : 0.0f;
}

/// Within a window of the square.
GLINT_HD inline DirectionSample samplePortalWindow(const PortalView& portal, const PortalWindow& w,
                                                   const Vec2& u) {
    const double whole = portalSum(portal, w);
    if (!(whole > 0.0)) { return {}; }
    PortalWindow column = w;
    const auto columnsTo = [&](double x) { return portalSum(portal, PortalWindow{w.x0, w.y0, x, w.y1}); };
    const double x = findSum(w.x0, w.x1, static_cast<double>(u.x) * whole, columnsTo, &column.x0, &column.x1);
    const auto rowsTo = [&](double y) {
        return portalSum(portal, PortalWindow{column.x0, w.y0, column.x1, y});
    };
    double above = 0.0, below = 0.0;
    const double wanted = static_cast<double>(u.y) * portalSum(portal, column);
    const double y = findSum(w.y0, w.y1, wanted, rowsTo, &above, &below);
    const auto ratio = [&](double cells) {
        return std::tan(kPi * static_cast<float>(cells / static_cast<double>(portal.size) - 0.5));
    };
    const Vec3 local = glm::normalize(Vec3(ratio(x), ratio(y), 1.0f));
    const EmitterData& e = portal.opening;
    DirectionSample s;
    s.wiWorld = glm::normalize(local.x * glm::normalize(e.axisU) + local.y * glm::normalize(e.axisV) -
                               local.z * e.direction);
    s.pdfSolidAngle = portalPdf(portal, whole, x, y, local.x, local.y, local.z);
    return s;
}

/// A direction through the portal as seen from `p`. The density is 0 where it is not seen.
GLINT_HD inline DirectionSample samplePortal(const PortalView& portal, const Vec3& p, const Vec2& u) {
    const EmitterData& e = portal.opening;
    if (!(glm::dot(p - e.position, e.direction) > 0.0f)) { return {}; }
    if (portal.size > 0) { return samplePortalWindow(portal, portalWindow(portal, p), u); }
    const EmitterPoint point = RectangleShape::sampleFrom(GeometryView{}, e, p, u);
    if (!(point.pdf > 0.0f)) { return {}; }
    return {glm::normalize(point.p - p), point.pdf};
}

/// Density of samplePortal() for a unit direction.
GLINT_HD inline float pdfPortal(const PortalView& portal, const Vec3& p, const Vec3& wiWorld) {
    if (!seesThroughPortal(portal, p, wiWorld)) { return 0.0f; }
    const EmitterData& e = portal.opening;
    const float cosNormal = -glm::dot(wiWorld, e.direction);
    if (portal.size == 0) {
        const float distance = glm::dot(p - e.position, e.direction) / cosNormal;
        return RectangleShape::pdfFrom(GeometryView{}, e, p, p + distance * wiWorld);
    }
    const double whole = portalSum(portal, portalWindow(portal, p));
    if (!(whole > 0.0)) { return 0.0f; }
    const float cosU = glm::dot(wiWorld, e.axisU) / glm::length(e.axisU);
    const float cosV = glm::dot(wiWorld, e.axisV) / glm::length(e.axisV);
    return portalPdf(portal, whole, portalCell(portal, cosU / cosNormal),
                     portalCell(portal, cosV / cosNormal), cosU, cosV, cosNormal);
}

/// A direction out of the portal for light that fills all of it: by the image, or by the cosine.
GLINT_HD inline DirectionSample samplePortalDirection(const PortalView& portal, const Vec2& u) {
    const double size = static_cast<double>(portal.size);
    if (portal.size > 0) { return samplePortalWindow(portal, PortalWindow{0.0, 0.0, size, size}, u); }
    const Vec3 local = sampleCosineHemisphere(u);
    return {Frame::fromNormal(-portal.opening.direction).toWorld(local), local.z * kInvPi};
}

}  // namespace glint
