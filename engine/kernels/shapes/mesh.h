// Meshes: triangles with vertices that they share, front side counter-clockwise in object space. As an
// emitter, each triangle is one.
//
// Texture coordinates: the mesh's uvs, or else the barycentric weights of the second and third vertex.
#pragma once

#include "engine/base/inlining.h"
#include "engine/kernels/accelerator.h"
#include "engine/kernels/features.h"
#include "engine/kernels/hit.h"
#include "engine/kernels/shapes/flat.h"
#include "engine/kernels/shapes/shape_description.h"
#include "engine/kernels/shapes/spherical_polygons.h"
#include "engine/kernels/shapes/triangle.h"
#include "engine/math/warp.h"

namespace glint {

struct MeshShape {
    static constexpr FeatureMask kFeature = kFeatureMesh;
    static constexpr bool kIsFinite = true;
    static constexpr bool kIsSampled = true;

    /// A ray against the part of one mesh that `root` begins (TopItem), in object space. On a hit nearer than
    /// ray.tMax stores it; its primitive is the triangle number.
    template <FeatureMask kMask, bool kAnyHit, bool kFrontOnly, class Tests>
    GLINT_ONE_PIECE GLINT_HD static bool intersect(const MeshView& mesh, uint32_t root, const Ray& ray,
                                                   Hit* hit, Tests tests) {
        if (mesh.accelerator.empty()) { return false; }
        const ShearRay shear = makeShearRay(ray);
        TriangleHit nearest{ray.tMax, 0.0f, 0.0f, kNone};
        const auto visit = [&](uint32_t first, uint32_t count, float* tMax) {
            bool found = false;
            for (uint32_t i = first; i < first + count; ++i) {
                tests.countPrimitives(mesh.clusters[i].count);
                found = intersectCluster<kAnyHit, kFrontOnly>(mesh.clusters[i], shear, ray.tMin, &nearest) ||
                        found;
            }
            *tMax = nearest.t;
            return found;
        };
        traverse<kMask, kAnyHit>(mesh.accelerator, mesh.clusters, ray, tests, visit, root);
        if (nearest.primitive == kNone) { return false; }
        hit->t = nearest.t;
        hit->primitive = mesh.clusterPrimitives[nearest.primitive];
        hit->barycentric = Vec2(nearest.b1, nearest.b2);
        return true;
    }

    /// The surface at a hit of the world-space `ray`. Sets *vertexColor where the mesh has colours.
    template <FeatureMask kMask>
    GLINT_HD static ObjectPoint surface(const MeshView& mesh, const Hit& hit, const InstanceData& instance,
                                        const Ray& ray, Vec3* vertexColor) {
        const Triangle t(mesh, hit.primitive);
        const Vec3 weights(1.0f - hit.barycentric.x - hit.barycentric.y, hit.barycentric.x,
                           hit.barycentric.y);
        ObjectPoint point;
        point.p = weights.x * t.p0 + weights.y * t.p1 + weights.z * t.p2;
        point.error =
            errorGamma(8) * (absVec(weights.x * t.p0) + absVec(weights.y * t.p1) + absVec(weights.z * t.p2)) +
            errorGamma(4) * glm::max(absVec(t.p0), glm::max(absVec(t.p1), absVec(t.p2)));
        constexpr float kMuchLarger = 64.0f;
        const float largest = maxComponent(glm::max(absVec(t.p0), glm::max(absVec(t.p1), absVec(t.p2))));
        const Ray objectRay = instance.flags & kInstanceIdentity ? ray : toObjectSpace(instance, ray);
        if (largest > kMuchLarger * (maxComponent(absVec(objectRay.direction)) * hit.t +
                                     maxComponent(absVec(objectRay.origin)))) {
            refineOnLargeTriangle(t, objectRay, &point);
        }
        point.ng = normal(t);
        if (hasFeature<kMask>(kFeatureMeshNormals) && mesh.normals) {
            point.ns = interpolate(mesh.normals, t.corner, weights);
        }
        if constexpr (hasFeature<kMask>(kFeatureTextures)) {
            point.uv = mesh.uvs ? interpolate(mesh.uvs, t.corner, weights) : hit.barycentric;
        }
        if (hasFeature<kMask>(kFeatureMeshColors) && mesh.colors) {
            *vertexColor = interpolate(mesh.colors, t.corner, weights);
        }
        return point;
    }

    /// Constant over a triangle. Where its uvs span nothing, those of the barycentric weights.
    GLINT_HD static Tangents tangents(const MeshView& mesh, uint32_t primitive) {
        const Triangle t(mesh, primitive);
        const Tangents edges{t.p1 - t.p0, t.p2 - t.p0};
        if (mesh.uvs == nullptr) { return edges; }
        const Vec2 a = mesh.uvs[t.corner[1]] - mesh.uvs[t.corner[0]];
        const Vec2 b = mesh.uvs[t.corner[2]] - mesh.uvs[t.corner[0]];
        const float inverse = 1.0f / differenceOfProducts(a.x, b.y, a.y, b.x);
        if (!std::isfinite(inverse)) { return edges; }
        return {(b.y * edges.dpdu - a.y * edges.dpdv) * inverse,
                (a.x * edges.dpdv - b.x * edges.dpdu) * inverse};
    }

    /// What the mesh itself says: unit vectors along u and along v, square to each other and to the shading
    /// normal. Zero: it says nothing there.
    GLINT_HD static Tangents ownTangents(const MeshView& mesh, const Hit& hit) {
        const Tangents nothing{Vec3(0.0f), Vec3(0.0f)};
        if (mesh.ownTangents == nullptr) { return nothing; }
        const Triangle t(mesh, hit.primitive);
        const Vec3 weights(1.0f - hit.barycentric.x - hit.barycentric.y, hit.barycentric.x,
                           hit.barycentric.y);
        const Vec4 sum = interpolate(mesh.ownTangents, t.corner, weights);
        const Vec3 smooth = mesh.normals ? interpolate(mesh.normals, t.corner, weights) : Vec3(0.0f);
        const Vec3 n = normalizeOr(isZero(smooth) ? normal(t) : smooth, Vec3(0.0f));
        const Vec3 across = normalizeOr(glm::cross(n, Vec3(sum)), Vec3(0.0f));
        if (isZero(across) || sum.w == 0.0f) { return nothing; }
        return {glm::cross(across, n), sum.w < 0.0f ? -across : across};
    }

    /// The tangents of the hit's triangle turned about its normal to where the mesh's own point, if it has
    /// some: dpdu along the interpolated ones, of its own length, dpdv as far.
    GLINT_HD static Tangents smoothTangents(const MeshView& mesh, const Hit& hit, const Tangents& flat) {
        if (mesh.tangents == nullptr) { return flat; }
        const Triangle t(mesh, hit.primitive);
        const Vec3 weights(1.0f - hit.barycentric.x - hit.barycentric.y, hit.barycentric.x,
                           hit.barycentric.y);
        Vec3 sum(0.0f);
        for (int i = 0; i < 3; ++i) {
            const Vec3 along = mesh.tangents[t.corner[i]];
            sum += glm::dot(along, flat.dpdu) < 0.0f ? -weights[i] * along : weights[i] * along;
        }
        const Vec3 n = normalizeOr(normal(t), Vec3(0.0f));
        const Vec3 from = normalizeOr(flat.dpdu, Vec3(0.0f)), to = normalizeOr(sum, Vec3(0.0f));
        const Vec3 toFlat = normalizeOr(to - glm::dot(to, n) * n, Vec3(0.0f));
        if (isZero(from) || isZero(toFlat)) { return flat; }
        const float cosine = glm::dot(from, toFlat), sine = glm::dot(n, glm::cross(from, toFlat));
        return {to * glm::length(flat.dpdu), flat.dpdv * cosine + glm::cross(n, flat.dpdv) * sine};
    }

    /// The texture coordinates at the point p, in world space, of the triangle that the emitter is. An affine
    /// transform keeps barycentric weights.
    GLINT_HD static Vec2 emitterUv(const MeshView& mesh, const EmitterData& e, uint32_t primitive,
                                   const Vec3& p) {
        const Vec3 d = p - e.position;
        const float uu = glm::dot(e.axisU, e.axisU);
        const float uv = glm::dot(e.axisU, e.axisV);
        const float vv = glm::dot(e.axisV, e.axisV);
        const float inverse = 1.0f / differenceOfProducts(uu, vv, uv, uv);
        const float du = glm::dot(d, e.axisU);
        const float dv = glm::dot(d, e.axisV);
        const Vec2 b(differenceOfProducts(vv, du, uv, dv) * inverse,
                     differenceOfProducts(uu, dv, uv, du) * inverse);
        if (mesh.uvs == nullptr) { return b; }
        return interpolate(mesh.uvs, Triangle(mesh, primitive).corner, {1.0f - b.x - b.y, b.x, b.y});
    }

    /// Of one triangle; area 0 where it is degenerate. `mirrored`: the transform turns counter-clockwise
    /// into clockwise.
    static EmitterData makeEmitter(const Affine& m, const Vec3* positions, const uint32_t* corner,
                                   bool mirrored) {
        EmitterData e;
        e.position = m.point(positions[corner[0]]);
        e.axisU = m.point(positions[corner[1]]) - e.position;
        e.axisV = m.point(positions[corner[2]]) - e.position;
        e.area = 0.5f * spannedArea(e.axisU, e.axisV);
        const glm::dvec3 n = glm::cross(glm::dvec3(e.axisU), glm::dvec3(e.axisV));
        const double length = glm::length(n);
        // Under mirroring the edges turn the other way round while the front stays the front.
        if (length > 0.0) { e.direction = Vec3((mirrored ? -n : n) / length); }
        if (!(length > 0.0)) { e.area = 0.0f; }
        return e;
    }

    static void boundEmitter(const EmitterData& e, LightNode* node) {
        Bounds box;
        box.grow(e.position);
        box.grow(e.position + e.axisU);
        box.grow(e.position + e.axisV);
        node->center = box.center();
        boundFlatEmitter(e, 0.5f * glm::length(box.extent()), node);
    }

    static float power(const GeometryView&, const EmitterData& e, float exitance) {
        return exitance * e.area;
    }

    GLINT_HD static EmitterPoint sampleArea(const GeometryView&, const EmitterData& e, const Vec2& u) {
        const Vec2 b = sampleTriangle(u);
        return flatEmitterPoint(e, b.x, b.y, 1.0f / e.area);
    }

    GLINT_HD static EmitterPoint sampleFrom(const GeometryView&, const EmitterData& e, const Vec3& from,
                                            const Vec2& u) {
        if (looksLarge(e, center(e), from)) {
            const SphericalTriangle q = asSeen(e, from);
            if (q.solidAngle > kSmallSolidAngle * 0.5f) {
                const Vec3 wi = sampleSphericalTriangle(q, u);
                Vec2 ab;
                if (!intersectTrianglePlane(e.position - from, e.axisU, e.axisV, wi, &ab)) { return {}; }
                return flatEmitterPoint(e, ab.x, ab.y, 1.0f / q.solidAngle);
            }
        }
        const Vec2 ab = sampleTriangle(u);
        return flatEmitterPointFrom(e, from, ab.x, ab.y);
    }

    GLINT_HD static float pdfFrom(const GeometryView&, const EmitterData& e, const Vec3& from,
                                  const Vec3& p) {
        if (looksLarge(e, center(e), from)) {
            const float solidAngle = asSeen(e, from).solidAngle;
            if (solidAngle > kSmallSolidAngle * 0.5f) { return 1.0f / solidAngle; }
        }
        return areaToSolidAngle(1.0f / e.area, from, p, e.direction);
    }

    static ShapeDescription description() {
        return {.name = "mesh", .help = "Without a material, a whole OBJ or PLY file brings its own."};
    }

  private:
    struct Triangle {
        GLINT_HD Triangle(const MeshView& mesh, uint32_t primitive)
            : corner(mesh.indices + 3 * static_cast<size_t>(primitive)),
              p0(mesh.positions[corner[0]]),
              p1(mesh.positions[corner[1]]),
              p2(mesh.positions[corner[2]]) {}

        const uint32_t* corner;
        const Vec3& p0;
        const Vec3& p1;
        const Vec3& p2;
    };

    template <class T>
    GLINT_HD static T interpolate(const T* values, const uint32_t* corner, const Vec3& weights) {
        return values[corner[0]] * weights.x + values[corner[1]] * weights.y + values[corner[2]] * weights.z;
    }

    /// e1 x e2, each product difference compensated: thin triangles keep their direction.
    GLINT_HD static Vec3 normal(const Triangle& t) {
        const Vec3 e1 = t.p1 - t.p0;
        const Vec3 e2 = t.p2 - t.p0;
        const float scale = maxComponent(glm::max(absVec(e1), absVec(e2)));
        if (!(scale > 0.0f)) { return Vec3(0.0f); }
        const Vec3 a = e1 / scale;
        const Vec3 b = e2 / scale;
        return {differenceOfProducts(a.y, b.z, a.z, b.y), differenceOfProducts(a.z, b.x, a.x, b.z),
                differenceOfProducts(a.x, b.y, a.y, b.x)};
    }

    /// Weighted corners of a triangle are off by some units in the last place of the corners. Where the
    /// triangle is much larger than the way to it, the point is better found along the ray.
    GLINT_HD static void refineOnLargeTriangle(const Triangle& t, const Ray& ray, ObjectPoint* point) {
        const Vec3 way = ray.direction * planeDistance(t.p0, t.p1, t.p2, ray.origin, ray.direction);
        const Vec3 error = errorGamma(3) * (absVec(ray.origin) + absVec(way));
        if (!(maxComponent(error) < maxComponent(point->error))) { return; }
        point->p = ray.origin + way;
        point->error = error;
    }

    GLINT_HD static Vec3 center(const EmitterData& e) {
        return e.position + (1.0f / 3.0f) * (e.axisU + e.axisV);
    }

    GLINT_HD static SphericalTriangle asSeen(const EmitterData& e, const Vec3& from) {
        const Vec3 a = e.position - from;
        return makeSphericalTriangle(a, a + e.axisU, a + e.axisV);
    }
};

}  // namespace glint
