// How much of the disc around a visible point its surface covers: near edges and in corners photons can lie
// on a part of it only. Host and device; called while photons are gathered.
//
// Every pass does two things, independently of each other. It looks for walls that stand in the disc, by rays
// along the surface; what lies behind the plane of one is left out of the disc, photons and all, since other
// light falls there, or none. And it asks for one point of the disc whether there is surface that could hold
// a photon. The mean of the answers is the part of the disc that the mean of the passes' photons came from
// (coverageFactor()), however many of the walls were found.
#pragma once

#include "engine/kernels/intersect.h"
#include "engine/kernels/photon_surface.h"
#include "engine/kernels/sampler.h"
#include "engine/kernels/surface.h"

namespace glint {

/// Passes that look at every pixel; later ones look only where an earlier one found part of a disc missing.
constexpr uint32_t kProbingPasses = 8;
/// Rays along the surface of a pass, before and after it is known that part of the disc is missing.
constexpr int kFirstWallRays = 1;
constexpr int kWallRays = 3;

/// What photons must lie on: the surface of a visible point.
struct GatherSurface {
    Vec3 ng, ns, vertexColor;
    Vec2 uv;
    uint32_t material;
    uint32_t number;  ///< surfaceNumber()
    float uvWidth;    ///< what a pixel covers of u and v; 0 where no texture asks for it
    Vec3 facetAxis;   ///< bsdf/facet_frame.h; set where the material needs it
};

/// The half spaces before the walls in a disc.
struct DiscClip {
    Vec3 normals[kWallRays];  ///< towards the centre
    float offsets[kWallRays];
    int count = 0;

    GLINT_HD void add(const Vec3& normal, const Vec3& onWall) {
        normals[count] = normal;
        offsets[count++] = glm::dot(normal, onWall);
    }
    /// Points relative to the disc's centre.
    GLINT_HD bool contains(const Vec3& fromCentre) const {
        for (int i = 0; i < count; ++i) {
            if (glm::dot(normals[i], fromCentre) < offsets[i]) { return false; }
        }
        return true;
    }
};

namespace detail {

/// A surface has bent away from another when their front normals differ by more than 45 degrees.
constexpr float kLeastNormalCosine = 0.70710678f;
/// Photons lie no farther from the tangent plane, in radii.
constexpr float kGreatestHeight = 0.5f;
/// How far above the surface rays run along it, in radii: what is lower is no wall.
constexpr float kWallRayHeight = 1.0f / 32.0f;

/// The disc around a visible point as rays see it.
template <FeatureMask kMask>
struct Disc {
    /// What is half there holds photons for all of it.
    static constexpr FeatureMask kWhole = kMask & ~kFeatureCutouts;

    const SceneView& view;
    const SppmParams& params;
    const GatherSurface& surface;
    Vec3 centre;
    Frame frame;  ///< n: the normal on the side that is seen
    float radius;

    /// Whether its front is on the side on which the disc's back is.
    GLINT_HD bool isTurned(const SurfacePoint& found) const { return glm::dot(found.ng, surface.ng) < 0.0f; }

    /// Whether photons at such a place of another surface could count.
    GLINT_HD bool goesOnAs(const SurfacePoint& found) const {
        const Vec3 ng = isTurned(found) ? -found.ng : found.ng;
        if (!(glm::dot(ng, surface.ng) > kLeastNormalCosine)) { return false; }
        const float height = 0.5f * glm::dot(found.p - centre, ng + surface.ng);
        if (!sharePhotons(view, surfaceNumber<kMask>(view, params, found.instance), surface.number,
                          isTurned(found), height, radius * radius)) {
            return false;
        }
        return found.material == surface.material ||
               visiblePointLobes(makeBsdf<kMask>(view, found, found.ng), params.storeAlpha).probability() >
                   0.0f;
    }

    /// Whether nothing is there: a hole that is cut out.
    GLINT_HD bool isHole(const SurfacePoint& found) const {
        return hasFeature<kMask>(kFeatureCutouts) &&
               !(opacityAt<kMask>(view, view.materials[found.material], found.uv) > 0.0f);
    }

    GLINT_HD DiscClip findWalls(float uAngle, int rays) const {
        DiscClip clip;
        const Vec3 lift = kWallRayHeight * radius * frame.n;
        for (int i = 0; i < rays; ++i) {
            const float angle = kTwoPi * (uAngle + static_cast<float>(i) / static_cast<float>(rays));
            const Vec3 direction = std::cos(angle) * frame.s + std::sin(angle) * frame.t;
            const Ray ray{centre + lift, direction, 0.0f, radius};
            Hit hit;
            if (!intersect<kWhole>(view, ray, &hit)) { continue; }
            const SurfacePoint found = surfaceAt<kMask>(view, ray, hit);
            // The underside of a ball on a floor is a wall, seen from without and from within.
            if (isHole(found) || (!isTurned(found) && goesOnAs(found))) { continue; }
            clip.add(glm::dot(found.ng, direction) < 0.0f ? found.ng : -found.ng, lift + hit.t * direction);
        }
        return clip;
    }

    /// Whether nothing stands between the centre and a place at its height.
    GLINT_HD bool isOpenTo(const Vec3& fromCentre) const {
        const float distance = glm::length(fromCentre);
        if (!(distance > 0.0f)) { return true; }
        Hit hit;
        const Ray ray{centre + kWallRayHeight * radius * frame.n, fromCentre * (1.0f / distance), 0.0f,
                      distance};
        return !intersect<kWhole>(view, ray, &hit);
    }

    /// Looks down from where photons can be highest, through what cannot hold them: the underside of what
    /// lies there.
    GLINT_HD bool isCoveredAt(const Vec3& fromCentre) const {
        constexpr int kMostLayers = 4;
        const float height = kGreatestHeight * radius;
        Ray ray{centre + fromCentre + height * frame.n, -frame.n, 0.0f, 2.0f * height};
        Hit hit;
        for (int layer = 0; layer < kMostLayers && intersect<kWhole>(view, ray, &hit); ++layer) {
            const SurfacePoint found = surfaceAt<kMask>(view, ray, hit);
            // The bottom of a box on a floor is no floor wound the other way.
            if (!isHole(found) && goesOnAs(found) && (!isTurned(found) || isOpenTo(fromCentre))) {
                return true;
            }
            ray.tMin = hit.t;
        }
        return false;
    }
};

}  // namespace detail

/// Whether the pass looks: in the first ones, and where something is missing; not where the radius is lost
/// in the rounding of the place.
GLINT_HD inline bool wantsProbe(const SppmParams& params, const SppmPixel& statistics, const Vec3& p,
                                float radius) {
    const Vec3 size = absVec(p);
    return (params.pass.pass < kProbingPasses || statistics.covered < statistics.probes) &&
           detail::kWallRayHeight * radius > errorGamma(32) * maxComponent(size);
}

namespace detail {

/// Finds *clip and tries one point of the disc, if the pass looks at all.
template <FeatureMask kMask>
GLINT_HD DiscProbe probeDisc(const SceneView& view, const SppmParams& params, const SppmPixel& statistics,
                             const Sampler& sampler, const VisiblePoint& point, const GatherSurface& surface,
                             float radius, DiscClip* clip) {
    if (!wantsProbe(params, statistics, point.p, radius)) { return {}; }
    const Vec3 up = glm::dot(surface.ng, point.woWorld) < 0.0f ? -surface.ng : surface.ng;
    const Disc<kMask> disc{view, params, surface, point.p, Frame::fromNormal(up), radius};
    const int rays = statistics.covered < statistics.probes ? kWallRays : kFirstWallRays;
    *clip = disc.findWalls(get1D<kMask>(sampler, dimension(GatherDimension::WallAngle)), rays);
    const Vec2 d = sampleDisc(get2D<kMask>(sampler, dimension(GatherDimension::DiscPoint)));
    const Vec3 fromCentre = radius * (d.x * disc.frame.s + d.y * disc.frame.t);
    return {true, clip->contains(fromCentre) && disc.isCoveredAt(fromCentre), glm::dot(d, d)};
}

}  // namespace detail

/// By how much the mean of the passes' photons is too dark, since they lay on part of the discs only: exactly
/// 1 where none was missing. One more point, covered, is a prior; narrower corners than 1 / 8 of a disc stay
/// dark.
GLINT_HD inline double coverageFactor(const SppmPixel& pixel) {
    constexpr double kGreatest = 8.0;
    const auto probes = static_cast<double>(pixel.probes);
    const auto covered = static_cast<double>(pixel.covered);
    if (!(covered < probes)) { return 1.0; }
    const double factor = (probes + 1.0) / (covered + 1.0);
    return factor < kGreatest ? factor : kGreatest;
}

}  // namespace glint
