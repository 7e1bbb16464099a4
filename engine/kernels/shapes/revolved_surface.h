// Surfaces of revolution: a profile of Bézier curves in the half plane (radius, height), turned about the y
// axis. What rays meet, and the surface there; revolved.h adds what light sampling needs.
//
// A ray is tested against rings around short pieces of the profile, eight at once (profile_ray.h), then
// against the pieces that it may meet (profile_roots.h), nearest first.
//
// Texture coordinates: u = a / 2 pi, v = 1 - s over the whole profile (s counts from the image's top row);
// caps continue v beyond it. The front is outside: the side away from the volume between the curve and the
// axis, whichever way the curve runs.
#pragma once

#include "engine/base/bits.h"
#include "engine/base/inlining.h"
#include "engine/kernels/features.h"
#include "engine/kernels/hit.h"
#include "engine/kernels/ray_tests.h"
#include "engine/kernels/shapes/clamped_search.h"
#include "engine/kernels/shapes/object_point.h"
#include "engine/kernels/shapes/profile_roots.h"

namespace glint {
namespace detail {

/// The profile at s, turned to where a point lies.
struct TurnedProfile {
    double x, y, dx, dy;  ///< and derivatives by s
    double cosine = 1.0, sine = 0.0;
    double side;  ///< -1 where x is negative, where the front is on the curve's other side

    GLINT_HD TurnedProfile(const ProfileCurve& curve, float s, const Vec3& p) {
        const PolynomialValue vx =
            evaluateBernstein<kMaxProfileDegree>(curve.x, curve.degree, static_cast<double>(s));
        const PolynomialValue vy =
            evaluateBernstein<kMaxProfileDegree>(curve.y, curve.degree, static_cast<double>(s));
        x = vx.value;
        dx = vx.derivative;
        y = vy.value;
        dy = vy.derivative;
        side = x < 0.0 ? -1.0 : 1.0;
        const double px = static_cast<double>(p.x), pz = static_cast<double>(p.z);
        const double ring = std::sqrt(px * px + pz * pz);
        if (!(ring > 0.0)) { return; }
        cosine = side * px / ring;
        sine = -side * pz / ring;
    }
};

}  // namespace detail

struct RevolvedSurface {
    /// A ray in object space against a profile. On a hit nearer than ray.tMax stores it: its primitive is the
    /// curve's number in the profile, barycentric.x the curve's parameter.
    template <bool kAnyHit, bool kFrontOnly, class Tests = NoTests>
    GLINT_HD static bool intersect(const ProfileView& profile, const Ray& ray, Hit* hit, Tests tests = {}) {
        return meet(profile, ray, kAnyHit, kFrontOnly, hit, tests);
    }

    /// The same. By far the largest function of those that look for hits: there is one of it, not four, since
    /// the two conditions are looked at where a root was found only.
    template <class Tests>
    GLINT_ONE_PIECE_APART GLINT_HD static bool meet(const ProfileView& profile, const Ray& ray, bool anyHit,
                                                    bool frontOnly, Hit* hit, Tests tests) {
        const ProfileRay local(ray, *profile.data);
        Nearest nearest{static_cast<double>(ray.tMin) - local.shift,
                        static_cast<double>(ray.tMax) - local.shift};
        if (profile.data->clampsSearch) {
            const ClampedRoot root = searchClamped(profile, local, nearest.tMin);
            tests.countNewtonSteps(root.steps);
            if (root.curve != kNone) {
                takeRoot(profile, frontOnly, root.curve, local, root.s, root.t, &nearest);
            }
        } else {
            const RingRay ringRay(local);
            for (uint32_t first = 0; first < profile.data->pieceCount; first += kGroupPieces) {
                meetGroup(profile, local, ringRay, anyHit, frontOnly, first, &nearest, tests);
                if (anyHit && nearest.curve != kNone) { break; }
            }
        }
        if (nearest.curve == kNone) { return false; }
        hit->t = static_cast<float>(nearest.t + local.shift);
        hit->primitive = nearest.curve;
        hit->barycentric = Vec2(static_cast<float>(nearest.s), 0.0f);
        return true;
    }

    /// The surface at a hit, about the direction from the axis in which the ray's point lies.
    template <FeatureMask kMask>
    GLINT_HD static ObjectPoint surface(const ProfileView& profile, const Hit& hit, const Vec3& pRough) {
        const ProfileCurve& curve = profile.curves[hit.primitive];
        const detail::TurnedProfile at(curve, hit.barycentric.x, pRough);
        ObjectPoint point;
        point.p = Vec3(at.x * at.cosine, at.y, -at.x * at.sine);
        // The next ray meets the surface as far off as its roots are, however near to the axis that is.
        const float size = static_cast<float>(profile.data->radius + profile.data->halfHeight);
        point.error = errorGamma(4) * absVec(point.p) + Vec3(kRootError * size);
        point.ng = profile.data->front * static_cast<float>(at.side) *
                   Vec3(at.dy * at.cosine, -at.dx, -at.dy * at.sine);
        if (isZero(point.ng)) { point.ng = Vec3(0.0f, at.y < 0.0 ? -1.0f : 1.0f, 0.0f); }
        if constexpr (hasFeature<kMask>(kFeatureTextures)) {
            const float turn =
                std::atan2(static_cast<float>(at.sine), static_cast<float>(at.cosine)) / kTwoPi;
            point.uv = Vec2(turn < 0.0f ? turn + 1.0f : turn, curve.vBegin + hit.barycentric.x * curve.vStep);
        }
        return point;
    }

    GLINT_HD static Tangents tangents(const ProfileView& profile, const Hit& hit, const Vec3& p) {
        const ProfileCurve& curve = profile.curves[hit.primitive];
        const detail::TurnedProfile at(curve, hit.barycentric.x, p);
        const double perTurn = 2.0 * 3.14159265358979323846 * at.x;
        const double perV = 1.0 / static_cast<double>(curve.vStep);
        return {Vec3(-perTurn * at.sine, 0.0, -perTurn * at.cosine),
                Vec3(perV * at.dx * at.cosine, perV * at.dy, -perV * at.dx * at.sine)};
    }

  private:
    /// Of the profile's size: how far along a ray a root may be off. Of a piece's height it is this much by
    /// ProfileRay::closeRoot(), and pieces that bend are far shorter than the profile.
    static constexpr float kRootError = 1e-7f;

    /// The nearest root so far; t counts from the ProfileRay's origin.
    struct Nearest {
        double tMin, t;
        double s = 0.0;  ///< the curve's parameter
        uint32_t curve = kNone;
    };

    /// The pieces from number `begin` on that are in one group, nearest first.
    template <class Tests>
    GLINT_HD static void meetGroup(const ProfileView& profile, const ProfileRay& ray, const RingRay& ringRay,
                                   bool anyHit, bool frontOnly, uint32_t begin, Nearest* nearest,
                                   Tests tests) {
        const PieceGroup& group = profile.groups[begin / kGroupPieces];
        alignas(32) float first[kGroupPieces];
        const float tMin = static_cast<float>(nearest->tMin), tMax = static_cast<float>(nearest->t);
        uint64_t pieces = 0;
        uint32_t eights = ringHits<false>(group.around, ringRay, tMin, tMax, nullptr);
        tests.countBoxes(kPieceLanes);
        for (; eights != 0; eights &= eights - 1) {
            const uint32_t i = lowestBit(eights);
            const uint32_t hits =
                ringHits<true>(group.rings[i], ringRay, tMin, tMax, first + kPieceLanes * i);
            pieces |= uint64_t{hits} << (kPieceLanes * i);
            tests.countBoxes(kPieceLanes);
        }
        while (pieces != 0) {
            uint32_t next = lowestBit(pieces);
            for (uint64_t rest = pieces & (pieces - 1); rest != 0; rest &= rest - 1) {
                const uint32_t other = lowestBit(rest);
                next = first[other] < first[next] ? other : next;
            }
            if (static_cast<double>(first[next]) > nearest->t) { return; }
            pieces &= ~(uint64_t{1} << next);
            const ProfilePiece& piece = profile.pieces[begin + next];
            tests.countPrimitives(1);
            tests.countNewtonSteps(meetPiece(piece, ray, [&](double s, double t) {
                return takeRoot(profile, frontOnly, piece.curve, ray, piece.begin + s * piece.width, t,
                                nearest);
            }));
            if (anyHit && nearest->curve != kNone) { return; }
        }
    }

    /// Keeps the root at s of the curve and t where it is the nearest so far, and says whether.
    GLINT_HD static bool takeRoot(const ProfileView& profile, bool frontOnly, uint32_t curve,
                                  const ProfileRay& ray, double s, double t, Nearest* nearest) {
        if (!(t > nearest->tMin && t < nearest->t)) { return false; }
        if (frontOnly) {
            const Vec3 p(ray.ox + t * ray.dx, ray.oy + t * ray.dy, ray.oz + t * ray.dz);
            const detail::TurnedProfile at(profile.curves[curve], static_cast<float>(s), p);
            const double facing =
                at.side * (at.dy * at.cosine * ray.dx - at.dx * ray.dy - at.dy * at.sine * ray.dz);
            if (static_cast<double>(profile.data->front) * facing >= 0.0) { return false; }
        }
        nearest->t = t;
        nearest->s = s;
        nearest->curve = curve;
        return true;
    }
};

// In render/cpu_intersect.cpp.
GLINT_ONCE_ON_HOST(template bool RevolvedSurface::meet(const ProfileView&, const Ray&, bool, bool, Hit*,
                                                       NoTests));

}  // namespace glint
