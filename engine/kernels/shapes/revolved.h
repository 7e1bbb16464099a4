// Surfaces of revolution as a shape: what rays meet (revolved_surface.h), and points on emissive ones.
#pragma once

#include "engine/kernels/shapes/emitter_point.h"
#include "engine/kernels/shapes/revolved_surface.h"
#include "engine/kernels/shapes/shape_description.h"
#include "engine/math/rng.h"

namespace glint {

struct RevolvedShape : RevolvedSurface {
    static constexpr FeatureMask kFeature = kFeatureRevolved;
    static constexpr bool kIsFinite = true;
    static constexpr bool kIsSampled = true;

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
        return exitance * profileOf(geometry, e).data->area * std::pow(volume, 2.0f / 3.0f);
    }

    /// Uniform over each of the profile's steps, which are chosen by their area.
    GLINT_HD static EmitterPoint sampleArea(const GeometryView& geometry, const EmitterData& e,
                                            const Vec2& u) {
        const ProfileView profile = profileOf(geometry, e);
        constexpr int kSteps = ProfileCurve::kAreaSteps;
        Hit hit;
        hit.primitive = 0;
        while (hit.primitive + 1 < profile.data->curveCount &&
               u.x >= profile.curves[hit.primitive].areaBefore[kSteps]) {
            ++hit.primitive;
        }
        const float* before = profile.curves[hit.primitive].areaBefore;
        int step = 0;
        while (step + 1 < kSteps && u.x >= before[step + 1]) {
            ++step;
        }
        const float share = before[step + 1] - before[step];
        if (!(share > 0.0f)) { return {}; }
        const float within = clampf((u.x - before[step]) / share, 0.0f, kOneMinusEpsilon);
        hit.barycentric.x = (static_cast<float>(step) + within) / kSteps;
        const float angle = kTwoPi * u.y;
        return emitterPoint(geometry.instances[e.instance], profile, hit,
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
        const ProfileView profile = profileOf(geometry, e);
        Hit hit;
        if (!locate(profile, local, &hit)) { return 0.0f; }
        const EmitterPoint point = emitterPoint(instance, profile, hit, local);
        return areaToSolidAngle(point.pdf, from, p, point.normal);
    }

    /// The texture coordinates at a point of the surface in object space.
    template <FeatureMask kMask>
    GLINT_HD static Vec2 emitterUv(const ProfileView& profile, const Vec3& p) {
        Hit hit;
        return locate(profile, p, &hit) ? surface<kMask>(profile, hit, p).uv : Vec2(0.0f);
    }

    static ShapeDescription description() {
        return {
            .name = "revolved",
            .help =
                "A profile turned about the y axis. Its front is outside, whichever way the profile runs."};
    }

  private:
    GLINT_HD static ProfileView profileOf(const GeometryView& geometry, const EmitterData& e) {
        return profileAt(geometry, geometry.instances[e.instance].mesh);
    }

    /// The hit at a point of the surface in object space: by short rays through it along the radius and along
    /// the axis, one of which crosses the profile. False: it is none.
    GLINT_HD static bool locate(const ProfileView& profile, const Vec3& p, Hit* hit) {
        constexpr float kReach = 1e-3f;  // of the profile's size
        const float reach = kReach * static_cast<float>(profile.data->size());
        const Vec3 outwards = normalizeOr(Vec3(p.x, 0.0f, p.z), Vec3(1.0f, 0.0f, 0.0f));
        float best = kReach * reach;
        bool found = false;
        for (int axis = 0; axis < 2; ++axis) {
            const Vec3 direction = axis == 0 ? outwards : Vec3(0.0f, 1.0f, 0.0f);
            Hit candidate;
            Ray ray{p - reach * direction, direction, 0.0f, 2.0f * reach};
            // The first surface along the ray may be another one close by.
            for (int layer = 0; layer < 4 && intersect<false, false>(profile, ray, &candidate); ++layer) {
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
    GLINT_HD static EmitterPoint emitterPoint(const InstanceData& instance, const ProfileView& profile,
                                              const Hit& hit, const Vec3& towards) {
        const ObjectPoint local = surface<0>(profile, hit, towards);
        const Affine& m = instance.objectToWorld;
        EmitterPoint point;
        point.p = m.point(local.p);
        point.pError = absMultiply(m.linear, local.error) +
                       errorGamma(8) * (absMultiply(m.linear, absVec(local.p)) + absVec(m.translation));
        const Vec3 normal = transformNormal(instance.worldToObject.linear, local.ng);
        point.normal = normalizeOr(normal, Vec3(0.0f, 1.0f, 0.0f));
        constexpr int kSteps = ProfileCurve::kAreaSteps;
        const float* before = profile.curves[hit.primitive].areaBefore;
        const int step = static_cast<int>(minf(hit.barycentric.x * kSteps, kSteps - 1.0f));
        // Area by the parameter and the angle: the radius times the curve's speed, stretched by |det M|
        // |M^-T n|.
        const float ring = std::sqrt(local.p.x * local.p.x + local.p.z * local.p.z);
        const float areaByBoth = ring * std::fabs(m.determinant()) * glm::length(normal);
        if (areaByBoth > 0.0f) {
            point.pdf = (before[step + 1] - before[step]) * kSteps / (kTwoPi * areaByBoth);
        }
        return point;
    }
};

}  // namespace glint
