// Rectangles and triangles projected onto the unit sphere: their solid angle, and uniform directions
// inside them.
//
// The sums of angles keep about six digits after the point: below some hundredths of a steradian there are
// better ways.
#pragma once

#include "engine/math/vec.h"

namespace glint {

// ---- Ureña, Fajardo and King 2013, "An Area-Preserving Parametrization for Spherical Rectangles" ----

/// A rectangle in coordinates around the point it is seen from: x and y along its edges, its plane at z = z0
/// <= 0.
struct SphericalRectangle {
    float x0, x1, y0, y1, z0;
    float b0, b1, k;
    float solidAngle;
};

GLINT_HD inline float acosClamped(float x) { return std::acos(clampf(x, -1.0f, 1.0f)); }

/// `corner`, the perpendicular edges from it and the unit normal of either side describe the rectangle; all
/// world space.
GLINT_HD inline SphericalRectangle makeSphericalRectangle(const Vec3& corner, const Vec3& edgeX,
                                                          const Vec3& edgeY, const Vec3& normal,
                                                          const Vec3& from) {
    const float lengthX = std::sqrt(lengthSquared(edgeX));
    const float lengthY = std::sqrt(lengthSquared(edgeY));
    const Vec3 d = corner - from;
    SphericalRectangle q;
    q.x0 = glm::dot(d, edgeX) / lengthX;
    q.y0 = glm::dot(d, edgeY) / lengthY;
    q.x1 = q.x0 + lengthX;
    q.y1 = q.y0 + lengthY;
    q.z0 = -absDot(d, normal);
    // z components of the unit normals of the four planes through the edges; their x and y components
    // never meet.
    const float z2 = q.z0 * q.z0;
    const float n0 = -q.y0 / std::sqrt(z2 + q.y0 * q.y0);
    const float n1 = q.x1 / std::sqrt(z2 + q.x1 * q.x1);
    const float n2 = q.y1 / std::sqrt(z2 + q.y1 * q.y1);
    const float n3 = -q.x0 / std::sqrt(z2 + q.x0 * q.x0);
    const float g0 = acosClamped(-n0 * n1);
    const float g1 = acosClamped(-n1 * n2);
    const float g2 = acosClamped(-n2 * n3);
    const float g3 = acosClamped(-n3 * n0);
    q.b0 = n0;
    q.b1 = n2;
    q.k = kTwoPi - g2 - g3;
    q.solidAngle = g0 + g1 - q.k;
    return q;
}

/// A point of the rectangle, uniform over its solid angle, as coordinates in [0, 1] along its two edges.
GLINT_HD inline Vec2 sampleSphericalRectangle(const SphericalRectangle& q, const Vec2& u) {
    const float au = u.x * q.solidAngle + q.k;
    const float fu = (std::cos(au) * q.b0 - q.b1) / std::sin(au);
    const float cu = clampf(std::copysign(1.0f, fu) / std::sqrt(fu * fu + q.b0 * q.b0), -1.0f, 1.0f);
    const float xu = clampf(-(cu * q.z0) / std::sqrt(maxf(1.0f - cu * cu, 1e-12f)), q.x0, q.x1);
    const float d2 = xu * xu + q.z0 * q.z0;
    const float h0 = q.y0 / std::sqrt(d2 + q.y0 * q.y0);
    const float h1 = q.y1 / std::sqrt(d2 + q.y1 * q.y1);
    const float hv = h0 + u.y * (h1 - h0);
    const float cos2 = 1.0f - hv * hv;
    const float yv = cos2 > 1e-6f ? clampf(hv * std::sqrt(d2 / cos2), q.y0, q.y1) : q.y1;
    return {(xu - q.x0) / (q.x1 - q.x0), (yv - q.y0) / (q.y1 - q.y0)};
}

// ---- Arvo 1995, "Stratified Sampling of Spherical Triangles" ----

struct SphericalTriangle {
    Vec3 a, b, c;                      ///< unit directions of the vertices
    float cosAlpha = 0, sinAlpha = 0;  ///< inner angle at a
    float alpha = 0;
    float cosAb = 0;  ///< of the arc from a to b
    float solidAngle = 0;
};

/// Vertices relative to the point they are seen from. A vertex at that point gives solidAngle 0.
GLINT_HD inline SphericalTriangle makeSphericalTriangle(const Vec3& v0, const Vec3& v1, const Vec3& v2) {
    SphericalTriangle q;
    const float l0 = lengthSquared(v0), l1 = lengthSquared(v1), l2 = lengthSquared(v2);
    if (!(l0 > 0.0f && l1 > 0.0f && l2 > 0.0f)) { return q; }
    q.a = v0 * (1.0f / std::sqrt(l0));
    q.b = v1 * (1.0f / std::sqrt(l1));
    q.c = v2 * (1.0f / std::sqrt(l2));
    q.cosAb = glm::dot(q.a, q.b);
    // Van Oosterom and Strackee 1983, "The Solid Angle of a Plane Triangle".
    const float triple = std::fabs(glm::dot(q.a, glm::cross(q.b, q.c)));
    q.solidAngle = 2.0f * std::atan2(triple, 1.0f + q.cosAb + glm::dot(q.b, q.c) + glm::dot(q.c, q.a));
    if (q.solidAngle < 0.0f) { q.solidAngle += kTwoPi; }
    const Vec3 ab = glm::cross(q.a, q.b);
    const Vec3 ac = glm::cross(q.a, q.c);
    q.alpha = std::atan2(triple, glm::dot(ab, ac));
    q.cosAlpha = std::cos(q.alpha);
    q.sinAlpha = std::sin(q.alpha);
    return q;
}

/// The unit vector at right angles to the unit vector `b` in the plane of a and b, on a's side; b when they
/// are parallel.
GLINT_HD inline Vec3 orthogonalPart(const Vec3& a, const Vec3& b) {
    const Vec3 v = a - glm::dot(a, b) * b;
    const float l = lengthSquared(v);
    return l > 0.0f ? v * (1.0f / std::sqrt(l)) : b;
}

/// A unit direction, uniform over the triangle's solid angle.
GLINT_HD inline Vec3 sampleSphericalTriangle(const SphericalTriangle& q, const Vec2& u) {
    const float phi = u.x * q.solidAngle - q.alpha;
    const float s = std::sin(phi), t = std::cos(phi);
    const float uu = t - q.cosAlpha;
    const float vv = s + q.sinAlpha * q.cosAb;
    const float denominator = (vv * s + uu * t) * q.sinAlpha;
    const float numerator = (vv * t - uu * s) * q.cosAlpha - vv;
    const float cosAc = denominator != 0.0f ? clampf(numerator / denominator, -1.0f, 1.0f) : 1.0f;
    const Vec3 cHat = cosAc * q.a + safeSqrt(1.0f - cosAc * cosAc) * orthogonalPart(q.c, q.a);
    const float z = 1.0f - u.y * (1.0f - glm::dot(cHat, q.b));
    return glm::normalize(z * q.b + safeSqrt(1.0f - z * z) * orthogonalPart(cHat, q.b));
}

/// Barycentric coordinates of vertices 1 and 2 where `direction` from the origin meets the plane of the
/// triangle (v0, v0 + e1, v0 + e2), drawn back inside when rounding put them out. False: parallel (Moller and
/// Trumbore 1997).
GLINT_HD inline bool intersectTrianglePlane(const Vec3& v0, const Vec3& e1, const Vec3& e2,
                                            const Vec3& direction, Vec2* barycentric) {
    const Vec3 h = glm::cross(direction, e2);
    const float determinant = glm::dot(e1, h);
    if (determinant == 0.0f || !std::isfinite(1.0f / determinant)) { return false; }
    const float f = 1.0f / determinant;
    const float a = maxf(-f * glm::dot(v0, h), 0.0f);
    const float b = maxf(-f * glm::dot(direction, glm::cross(v0, e1)), 0.0f);
    const float outside = maxf(a + b, 1.0f);
    *barycentric = {a / outside, b / outside};
    return true;
}

}  // namespace glint
