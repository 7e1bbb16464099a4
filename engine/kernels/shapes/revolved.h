// Surfaces of revolution: a profile of Bézier curves in the half plane (radius, height), turned about the y
// axis.
//
// A point of the curve at parameter s turned by the angle a is (x cos a, y, -x sin a). Eliminating the ray's
// t from the equations of the ray and of the surface leaves, for a curve of degree n, one polynomial of
// degree 2n in s:
//   d.y^2 x(s)^2 = |o.xz d.y + (y(s) - o.y) d.xz|^2,   t = (y(s) - o.y) / d.y.
// All its roots are found (bernstein.h). A ray that is nearly horizontal leaves y(s) = y alone, of degree n;
// there t follows from the distance to the axis. Newton's method for both unknowns then removes the rounding
// of the coefficients.
//
// Texture coordinates: u = a / 2 pi, v = 1 - s over the whole profile (s counts from the image's top row).
// The front is outside: the side away from the volume between the curve and the axis, whichever way the curve
// runs.
#pragma once

#include "engine/base/inlining.h"
#include "engine/kernels/features.h"
#include "engine/kernels/hit.h"
#include "engine/kernels/shapes/emitter_point.h"
#include "engine/kernels/shapes/object_point.h"
#include "engine/math/bernstein.h"
#include "engine/math/rng.h"

namespace glint {

struct RevolvedShape {
    static constexpr FeatureMask kFeature = kFeatureRevolved;
    static constexpr bool kIsFinite = true;
    static constexpr bool kIsSampled = true;

    /// A ray in object space against a profile, given by the first of its curves. On a hit nearer than
    /// ray.tMax stores it: its primitive is the curve's number in the profile, barycentric.x the curve's
    /// parameter.
    template <bool kAnyHit, bool kFrontOnly>
    GLINT_ONE_PIECE_APART GLINT_HD static bool intersect(const ProfileCurve* curves, const Ray& ray,
                                                         Hit* hit) {
        const LocalRay local(ray, *curves);
        Nearest nearest{static_cast<double>(ray.tMin), static_cast<double>(ray.tMax)};
        for (uint32_t i = 0; i < curves->count; ++i) {
            const ProfileCurve& curve = curves[i];
            if (!local.mayMeet(curve)) { continue; }
            const auto consider = [&](double s, double t) {
                if (takeRoot<kFrontOnly>(curve, local, s, t, &nearest)) { nearest.curve = i; }
            };
            meetAny(curve, local, consider);
            if (kAnyHit && nearest.curve != kNone) { break; }
        }
        if (nearest.curve == kNone) { return false; }
        hit->t = static_cast<float>(nearest.t);
        hit->primitive = nearest.curve;
        hit->barycentric = Vec2(static_cast<float>(nearest.s), 0.0f);
        return true;
    }

    /// What finding every root along a ray takes.
    struct RootCost {
        uint32_t roots = 0;
        uint32_t newtonSteps = 0;
    };
    GLINT_HD static RootCost rootCost(const ProfileCurve* curves, const Ray& ray) {
        const LocalRay local(ray, *curves);
        RootCost cost;
        for (uint32_t i = 0; i < curves->count; ++i) {
            if (!local.mayMeet(curves[i])) { continue; }
            const auto count = [&](double, double) { ++cost.roots; };
            cost.newtonSteps += meetAny(curves[i], local, count);
        }
        return cost;
    }

    /// The surface at a hit, about the direction from the axis in which the ray's point lies.
    template <FeatureMask kMask>
    GLINT_HD static ObjectPoint surface(const ProfileCurve* curves, const Hit& hit, const Vec3& pRough) {
        const ProfileCurve& curve = curves[hit.primitive];
        const Turned at(curve, hit.barycentric.x, pRough);
        ObjectPoint point;
        point.p = Vec3(at.x * at.cosine, at.y, -at.x * at.sine);
        point.error = errorGamma(4) * absVec(point.p);
        point.ng = curve.front * Vec3(at.dy * at.cosine, -at.dx, -at.dy * at.sine);
        if (isZero(point.ng)) { point.ng = Vec3(0.0f, at.y < 0.0 ? -1.0f : 1.0f, 0.0f); }
        if constexpr (hasFeature<kMask>(kFeatureTextures)) {
            const float turn =
                std::atan2(static_cast<float>(at.sine), static_cast<float>(at.cosine)) / kTwoPi;
            const float s =
                (static_cast<float>(hit.primitive) + hit.barycentric.x) / static_cast<float>(curves->count);
            point.uv = Vec2(turn < 0.0f ? turn + 1.0f : turn, 1.0f - s);
        }
        return point;
    }

    GLINT_HD static Tangents tangents(const ProfileCurve* curves, const Hit& hit, const Vec3& p) {
        const Turned at(curves[hit.primitive], hit.barycentric.x, p);
        const double perTurn = 2.0 * 3.14159265358979323846 * at.x;
        const double perProfile = -static_cast<double>(curves->count);
        return {Vec3(-perTurn * at.sine, 0.0, -perTurn * at.cosine),
                Vec3(perProfile * at.dx * at.cosine, perProfile * at.dy, -perProfile * at.dx * at.sine)};
    }

    /// `box`: the profile's, in object space.
    static EmitterData makeEmitter(const Affine& objectToWorld, const Bounds& box) {
        const Bounds placed = transformBounds(objectToWorld, box);
        EmitterData e;
        e.position = placed.center();
        e.radiusWorld = 0.5f * glm::length(placed.extent());
        return e;
    }

    static void boundEmitter(const EmitterData& e, LightNode* node) {
        node->radius = e.radiusWorld;
        node->intensity *= kPi * square(e.radiusWorld);
    }

    /// Exact where the transform keeps angles; good enough to choose by elsewhere.
    static float power(const GeometryView& geometry, const EmitterData& e, float exitance) {
        const float volume = std::fabs(geometry.instances[e.instance].objectToWorld.determinant());
        return exitance * curvesOf(geometry, e)->area * std::pow(volume, 2.0f / 3.0f);
    }

    /// Uniform over each of the profile's steps, which are chosen by their area.
    GLINT_HD static EmitterPoint sampleArea(const GeometryView& geometry, const EmitterData& e,
                                            const Vec2& u) {
        const ProfileCurve* curves = curvesOf(geometry, e);
        constexpr int kSteps = ProfileCurve::kAreaSteps;
        Hit hit;
        hit.primitive = 0;
        while (hit.primitive + 1 < curves->count && u.x >= curves[hit.primitive].areaBefore[kSteps]) {
            ++hit.primitive;
        }
        const float* before = curves[hit.primitive].areaBefore;
        int step = 0;
        while (step + 1 < kSteps && u.x >= before[step + 1]) {
            ++step;
        }
        const float share = before[step + 1] - before[step];
        if (!(share > 0.0f)) { return {}; }
        const float within = clampf((u.x - before[step]) / share, 0.0f, kOneMinusEpsilon);
        hit.barycentric.x = (static_cast<float>(step) + within) / kSteps;
        const float angle = kTwoPi * u.y;
        return emitterPoint(geometry.instances[e.instance], curves, hit,
                            Vec3(std::cos(angle), 0.0f, -std::sin(angle)));
    }

    GLINT_HD static EmitterPoint sampleFrom(const GeometryView& geometry, const EmitterData& e,
                                            const Vec3& from, const Vec2& u) {
        EmitterPoint point = sampleArea(geometry, e, u);
        point.pdf = areaToSolidAngle(point.pdf, from, point.p, point.normal);
        return point;
    }

    GLINT_HD static float pdfFrom(const GeometryView& geometry, const EmitterData& e, const Vec3& from,
                                  const Vec3& p) {
        const InstanceData& instance = geometry.instances[e.instance];
        const Vec3 local = instance.worldToObject.point(p);
        Hit hit;
        if (!locate(curvesOf(geometry, e), local, &hit)) { return 0.0f; }
        const EmitterPoint point = emitterPoint(instance, curvesOf(geometry, e), hit, local);
        return areaToSolidAngle(point.pdf, from, p, point.normal);
    }

    /// The texture coordinates at a point of the surface in object space.
    template <FeatureMask kMask>
    GLINT_HD static Vec2 emitterUv(const ProfileCurve* curves, const Vec3& p) {
        Hit hit;
        return locate(curves, p, &hit) ? surface<kMask>(curves, hit, p).uv : Vec2(0.0f);
    }

  private:
    GLINT_HD static const ProfileCurve* curvesOf(const GeometryView& geometry, const EmitterData& e) {
        return geometry.curves.data + geometry.instances[e.instance].mesh;
    }

    /// The hit at a point of the surface in object space: by short rays through it along the radius and along
    /// the axis, one of which crosses the profile. False: it is none.
    GLINT_HD static bool locate(const ProfileCurve* curves, const Vec3& p, Hit* hit) {
        constexpr float kReach = 1e-3f;  // of the profile's size
        const float reach = kReach * static_cast<float>(curves->size);
        const Vec3 outwards = normalizeOr(Vec3(p.x, 0.0f, p.z), Vec3(1.0f, 0.0f, 0.0f));
        float best = kReach * reach;
        bool found = false;
        for (int axis = 0; axis < 2; ++axis) {
            const Vec3 direction = axis == 0 ? outwards : Vec3(0.0f, 1.0f, 0.0f);
            Hit candidate;
            Ray ray{p - reach * direction, direction, 0.0f, 2.0f * reach};
            // The first surface along the ray may be another one close by.
            for (int layer = 0; layer < 4 && intersect<false, false>(curves, ray, &candidate); ++layer) {
                const float off = std::fabs(candidate.t - reach);
                if (off < best) {
                    best = off;
                    *hit = candidate;
                    found = true;
                }
                ray.tMin = candidate.t;
            }
        }
        return found;
    }

    /// The point in world space with its density per area.
    GLINT_HD static EmitterPoint emitterPoint(const InstanceData& instance, const ProfileCurve* curves,
                                              const Hit& hit, const Vec3& towards) {
        const ObjectPoint local = surface<0>(curves, hit, towards);
        const Affine& m = instance.objectToWorld;
        EmitterPoint point;
        point.p = m.point(local.p);
        point.pError = errorGamma(8) * (absMultiply(m.linear, absVec(local.p)) + absVec(m.translation));
        const Vec3 normal = transformNormal(instance.worldToObject.linear, local.ng);
        point.normal = normalizeOr(normal, Vec3(0.0f, 1.0f, 0.0f));
        constexpr int kSteps = ProfileCurve::kAreaSteps;
        const float* before = curves[hit.primitive].areaBefore;
        const int step = static_cast<int>(minf(hit.barycentric.x * kSteps, kSteps - 1.0f));
        // Area by the parameter and the angle: the radius times the curve's speed, stretched by |det M| |M^-T
        // n|.
        const float ring = std::sqrt(local.p.x * local.p.x + local.p.z * local.p.z);
        const float areaByBoth = ring * std::fabs(m.determinant()) * glm::length(normal);
        if (areaByBoth > 0.0f) {
            point.pdf = (before[step + 1] - before[step]) * kSteps / (kTwoPi * areaByBoth);
        }
        return point;
    }

    static constexpr double kHorizontalSlope = 1e-5;

    struct Nearest {
        double tMin, t;
        double s = 0.0;
        uint32_t curve = kNone;
    };

    /// The ray from next to the shape, so that rays from far away lose no digits.
    struct LocalRay {
        double ox, oy, oz, dx, dy, dz;
        double shift;          ///< t of the origin
        double flat2, across;  ///< |d.xz|^2, and o.xz x d.xz
        double inverseDy;
        bool isHorizontal;

        GLINT_HD LocalRay(const Ray& ray, const ProfileCurve& first)
            : ox(static_cast<double>(ray.origin.x)),
              oy(static_cast<double>(ray.origin.y)),
              oz(static_cast<double>(ray.origin.z)),
              dx(static_cast<double>(ray.direction.x)),
              dy(static_cast<double>(ray.direction.y)),
              dz(static_cast<double>(ray.direction.z)) {
            flat2 = dx * dx + dz * dz;
            shift = -(ox * dx + (oy - first.centerY) * dy + oz * dz) / (flat2 + dy * dy);
            ox += shift * dx;
            oy += shift * dy;
            oz += shift * dz;
            across = ox * dz - oz * dx;
            inverseDy = 1.0 / dy;
            isHorizontal = dy * dy <= kHorizontalSlope * kHorizontalSlope * flat2;
        }

        /// Whether it comes into the cylinder around the curve.
        GLINT_HD bool mayMeet(const ProfileCurve& curve) const {
            const double r2 = curve.radius * curve.radius;
            if (flat2 > 0.0 && across * across > r2 * flat2) { return false; }
            // Where it is between the curve's heights, its distance from the axis is least in the middle or
            // at an end.
            if (isHorizontal || flat2 == 0.0) {
                const double reach =
                    std::fabs(dy) > 0.0 && flat2 > 0.0 ? std::fabs(dy) * 4.0 * reachOf(curve) : 0.0;
                return flat2 == 0.0 || (oy + reach >= curve.lowest && oy - reach <= curve.highest);
            }
            const double middle = -(ox * dx + oz * dz) / flat2;
            const double tLow = (curve.lowest - oy) * inverseDy, tHigh = (curve.highest - oy) * inverseDy;
            const double tFirst = tLow < tHigh ? tLow : tHigh, tLast = tLow < tHigh ? tHigh : tLow;
            const double t = middle < tFirst ? tFirst : middle > tLast ? tLast : middle;
            const double x = ox + t * dx, z = oz + t * dz;
            return x * x + z * z <= r2 * (1.0 + 1e-12);
        }
        GLINT_HD double reachOf(const ProfileCurve& curve) const { return curve.radius / std::sqrt(flat2); }
    };

    /// The profile at s, turned to where a point lies.
    struct Turned {
        double x, y, dx, dy;  ///< and derivatives by s
        double cosine = 1.0, sine = 0.0;

        GLINT_HD Turned(const ProfileCurve& curve, float s, const Vec3& p) {
            const PolynomialValue vx =
                evaluateBernstein<kMaxProfileDegree>(curve.x, curve.degree, static_cast<double>(s));
            const PolynomialValue vy =
                evaluateBernstein<kMaxProfileDegree>(curve.y, curve.degree, static_cast<double>(s));
            x = vx.value;
            dx = vx.derivative;
            y = vy.value;
            dy = vy.derivative;
            const double px = static_cast<double>(p.x), pz = static_cast<double>(p.z);
            const double ring = std::sqrt(px * px + pz * pz);
            if (!(ring > 0.0)) { return; }
            const double side = x < 0.0 ? -1.0 : 1.0;
            cosine = side * px / ring;
            sine = -side * pz / ring;
        }
    };

    /// The profile's polynomials, evaluated from powers where their degree is low.
    template <int kDegree>
    GLINT_HD static PolynomialValue evaluate(const double* bernstein, const double* powers, int degree,
                                             double s) {
        if constexpr (kDegree > 0) {
            PolynomialValue at{powers[kDegree], 0.0};
            for (int i = kDegree - 1; i >= 0; --i) {
                at.derivative = at.derivative * s + at.value;
                at.value = at.value * s + powers[i];
            }
            return at;
        } else {
            return evaluateBernstein<kMaxProfileDegree>(bernstein, degree, s);
        }
    }

    /// kDegree: the curve's, or 0 for any.
    template <int kDegree, class Consider>
    GLINT_HD static uint32_t meet(const ProfileCurve& curve, const LocalRay& ray, const Consider& consider) {
        constexpr int kMost = 2 * (kDegree > 0 ? kDegree : kMaxProfileDegree);
        const double a = ray.ox * ray.dy - ray.oy * ray.dx;
        const double b = ray.oz * ray.dy - ray.oy * ray.dz;
        const double linear = 2.0 * (a * ray.dx + b * ray.dz);
        const double constant = a * a + b * b;
        const double dy2 = ray.dy * ray.dy;
        const int degree = kDegree > 0 ? kMost : 2 * curve.degree;
        double f[kMost + 1];
        int negative = 0;
        for (int i = 0; i <= degree; ++i) {
            f[i] = dy2 * curve.xSquared[i] - ray.flat2 * curve.ySquared[i] - linear * curve.yRaised[i] -
                   constant;
            negative += static_cast<int>(f[i] < 0.0);
        }
        const auto heightAt = [&](double s) {
            return evaluate<kDegree>(curve.y, curve.yPowers, curve.degree, s);
        };
        const auto found = [&](double s) { consider(s, (heightAt(s).value - ray.oy) * ray.inverseDy); };
        // The polynomial's value from the curve itself, without the rounding of its coefficients.
        const auto missAt = [&](double s) {
            const PolynomialValue x = evaluate<kDegree>(curve.x, curve.xPowers, curve.degree, s);
            const PolynomialValue y = heightAt(s);
            const double px = a + y.value * ray.dx, pz = b + y.value * ray.dz;
            const double ring = ray.dy * x.value;
            return PolynomialValue{
                ring * ring - px * px - pz * pz,
                2.0 * (ring * ray.dy * x.derivative - (px * ray.dx + pz * ray.dz) * y.derivative)};
        };
        uint32_t steps = 0;
        if (negative > 0 && negative <= degree) {
            forEachBernsteinBracket<kMost>(
                f, degree, [&](double begin, double end, bool startsNegative, double guess) {
                    found(begin < end ? bracketedRoot(missAt, begin, end, startsNegative, guess, &steps)
                                      : guess);
                });
        }
        // Along the axis itself a pole is where the polynomial touches zero, and changes no sign.
        if (f[0] == 0.0 && curve.x[0] == 0.0) { found(0.0); }
        if (f[degree] == 0.0 && curve.x[curve.degree] == 0.0) { found(1.0); }
        return steps;
    }

    template <class Consider>
    GLINT_HD static uint32_t meetAny(const ProfileCurve& curve, const LocalRay& ray,
                                     const Consider& consider) {
        if (ray.isHorizontal) { return meetHorizontally(curve, ray, consider); }
        switch (curve.degree) {
            case 1:
                return meet<1>(curve, ray, consider);
            case 2:
                return meet<2>(curve, ray, consider);
            case 3:
                return meet<3>(curve, ray, consider);
            default:
                return meet<0>(curve, ray, consider);
        }
    }

    template <class Consider>
    GLINT_HD static uint32_t meetHorizontally(const ProfileCurve& curve, const LocalRay& ray,
                                              const Consider& consider) {
        const double middle = -(ray.ox * ray.dx + ray.oz * ray.dz) / ray.flat2;
        const double level = ray.oy + middle * ray.dy;
        double f[kMaxProfileDegree + 1];
        for (int i = 0; i <= curve.degree; ++i) {
            f[i] = curve.y[i] - level;
        }
        const double nearest2 = ray.across * ray.across / ray.flat2;
        return forEachBernsteinRoot<kMaxProfileDegree>(f, curve.degree, [&](double s) {
            const double x = evaluateBernstein<kMaxProfileDegree>(curve.x, curve.degree, s).value;
            if (x * x < nearest2) { return; }
            const double half = std::sqrt((x * x - nearest2) / ray.flat2);
            consider(s, middle - half);
            consider(s, middle + half);
        });
    }

    /// Newton's method for s and t. False: the root leaves the curve, so that its neighbour has it.
    GLINT_HD static bool polish(const ProfileCurve& curve, const LocalRay& ray, double* s, double* t) {
        for (int step = 0; step < 2; ++step) {
            const PolynomialValue x = evaluateBernstein<kMaxProfileDegree>(curve.x, curve.degree, *s);
            const PolynomialValue y = evaluateBernstein<kMaxProfileDegree>(curve.y, curve.degree, *s);
            const double px = ray.ox + *t * ray.dx, pz = ray.oz + *t * ray.dz;
            const double height = y.value - ray.oy - *t * ray.dy;
            const double ring = x.value * x.value - px * px - pz * pz;
            const double ringByS = 2.0 * x.value * x.derivative;
            const double ringByT = -2.0 * (px * ray.dx + pz * ray.dz);
            const double determinant = y.derivative * ringByT + ray.dy * ringByS;
            const double ds = (height * ringByT + ray.dy * ring) / determinant;
            const double dt = (y.derivative * ring - ringByS * height) / determinant;
            // Where the ray grazes the surface, the root is as good as it gets.
            if (!(std::fabs(ds) < 1e-3) || !std::isfinite(dt)) { break; }
            *s -= ds;
            *t -= dt;
        }
        constexpr double kSlack = 1e-9;  // neighbours share their ends: better twice than never
        const bool isInside = *s >= -kSlack && *s <= 1.0 + kSlack;
        *s = *s < 0.0 ? 0.0 : *s > 1.0 ? 1.0 : *s;
        return isInside;
    }

    /// Whether the root at s and t is the nearest so far.
    template <bool kFrontOnly>
    GLINT_HD static bool takeRoot(const ProfileCurve& curve, const LocalRay& ray, double s, double t,
                                  Nearest* nearest) {
        if (ray.isHorizontal && !polish(curve, ray, &s, &t)) { return false; }
        const double tWorld = t + ray.shift;
        if (!(tWorld > nearest->tMin && tWorld < nearest->t)) { return false; }
        if (kFrontOnly) {
            const Vec3 p(ray.ox + t * ray.dx, ray.oy + t * ray.dy, ray.oz + t * ray.dz);
            const Turned at(curve, static_cast<float>(s), p);
            const double facing = at.dy * at.cosine * ray.dx - at.dx * ray.dy - at.dy * at.sine * ray.dz;
            if (static_cast<double>(curve.front) * facing >= 0.0) { return false; }
        }
        nearest->t = tWorld;
        nearest->s = s;
        return true;
    }
};

}  // namespace glint
