// The triangles in question, evaluated again in double precision.
#include "viewer/bench/ray_comparison.h"

#include <algorithm>

namespace glint {
namespace {

using Vec3d = glm::dvec3;

constexpr double kEps = 0x1p-24;

/// A ray's line against one triangle in double precision, and what float arithmetic can do to it.
struct ExactHit {
    double t = 0.0;
    double smallestWeight = 0.0;  ///< of the three barycentric weights; negative: a miss
    double weightTolerance = 0.0;
    double tTolerance = 0.0;
};

ExactHit exactHit(const MeshView& mesh, uint32_t primitive, const Ray& ray) {
    const uint32_t* corner = mesh.indices + 3 * static_cast<size_t>(primitive);
    const Vec3d origin = ray.origin;
    const Vec3d d = ray.direction;
    const Vec3d p[3] = {Vec3d(mesh.positions[corner[0]]) - origin, Vec3d(mesh.positions[corner[1]]) - origin,
                        Vec3d(mesh.positions[corner[2]]) - origin};
    const double u = glm::dot(glm::cross(p[2], p[1]), d);
    const double v = glm::dot(glm::cross(p[0], p[2]), d);
    const double w = glm::dot(glm::cross(p[1], p[0]), d);
    const Vec3d n = glm::cross(p[1] - p[0], p[2] - p[0]);
    const double det = u + v + w;
    const double reach = std::max({glm::length(p[0]), glm::length(p[1]), glm::length(p[2])});
    const double longest =
        std::max({glm::length(p[1] - p[0]), glm::length(p[2] - p[1]), glm::length(p[0] - p[2])});
    const double cosine = std::abs(glm::dot(n, d)) / (glm::length(n) * glm::length(d));
    const double height = glm::length(n) / longest;
    ExactHit exact;
    exact.t = glm::dot(n, p[0]) / glm::dot(n, d);
    exact.smallestWeight = std::min({u / det, v / det, w / det});
    // A vertex moves sideways by a few roundings of its distance; seen edge-on a triangle is lower.
    exact.weightTolerance = 32.0 * kEps * reach / (height * cosine);
    exact.tTolerance = 32.0 * kEps * (reach / glm::length(d)) / cosine;
    return exact;
}

bool nearEdge(const ExactHit& exact) { return std::abs(exact.smallestWeight) <= exact.weightTolerance; }

/// One program met `primitive` where the other saw something farther or nothing.
RayDisagreement explainExtraHit(const MeshView& mesh, uint32_t primitive, const Ray& ray) {
    const ExactHit exact = exactHit(mesh, primitive, ray);
    if (nearEdge(exact)) { return RayDisagreement::EdgeRounding; }
    const auto tMin = static_cast<double>(ray.tMin);
    const auto tMax = static_cast<double>(ray.tMax);
    if (std::abs(exact.t - tMin) <= exact.tTolerance || std::abs(exact.t - tMax) <= exact.tTolerance) {
        return RayDisagreement::EndRounding;
    }
    return RayDisagreement::Unexplained;
}

std::optional<RayDisagreement> compareNearest(const MeshView& mesh, const Ray& ray, const Hit& a,
                                              const Hit& b) {
    if (a.primitive == kNone && b.primitive == kNone) { return std::nullopt; }
    if (a.primitive == kNone) { return explainExtraHit(mesh, b.primitive, ray); }
    if (b.primitive == kNone) { return explainExtraHit(mesh, a.primitive, ray); }
    const ExactHit exactA = exactHit(mesh, a.primitive, ray);
    const double difference = std::abs(static_cast<double>(a.t) - static_cast<double>(b.t));
    if (a.primitive == b.primitive) {
        return difference <= exactA.tTolerance ? std::nullopt : std::optional(RayDisagreement::DistanceDrift);
    }
    const ExactHit exactB = exactHit(mesh, b.primitive, ray);
    const double tolerance = std::max(exactA.tTolerance, exactB.tTolerance);
    if (difference <= tolerance) { return RayDisagreement::EdgeTie; }
    return explainExtraHit(mesh, a.t < b.t ? a.primitive : b.primitive, ray);
}

}  // namespace

std::optional<RayDisagreement> compareHits(const SceneView& view, const EmbreeOracle& embree, const Ray& ray,
                                           bool anyHit, const Hit& glintHit, const Hit& embreeHit) {
    const MeshView& mesh = view.geometry.meshes[0];
    if (!anyHit) { return compareNearest(mesh, ray, glintHit, embreeHit); }
    if (glintHit.primitive == embreeHit.primitive) { return std::nullopt; }
    Hit nearest{kInfinity, kNone, kNone, Vec2(0.0f)};
    const bool embreeBlocked = embreeHit.primitive != kNone;
    const bool found =
        embreeBlocked ? embree.intersect(ray, &nearest) : intersect<kFeatureMesh>(view, ray, &nearest);
    return found ? explainExtraHit(mesh, nearest.primitive, ray) : RayDisagreement::Unexplained;
}

}  // namespace glint
