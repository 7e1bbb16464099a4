// A box that holds more is nearer to the origin and larger: a scene is known not to be far as soon as some of
// its points show it, which is after a look at a few of them for nearly every scene.
#include "engine/builders/recentring.h"

#include <algorithm>
#include <cmath>

#include <glm/ext/matrix_double3x3.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "engine/kernels/shapes/shape_facts.h"
#include "engine/scene/object_box.h"

namespace glint {
namespace {

bool isFar(const WideBox& box) { return box.distanceFromOrigin() > kFarSizes * box.size(); }

/// The middle of the box on a grid of its size: few digits, and the same when the box changes a little.
Vec3 gridCenter(const WideBox& box) {
    if (!(box.size() > 0.0)) { return Vec3(box.center()); }
    const double step = std::exp2(std::ceil(std::log2(box.size())));
    return Vec3(glm::round(box.center() / step) * step);
}

bool isIdentity(const Affine& a) { return a == Affine{}; }

/// How far the plane passes from a point.
double planeDistance(const Affine& objectToWorld, const glm::dvec3& p) {
    const glm::dmat3 inverseTranspose = glm::transpose(glm::inverse(glm::dmat3(objectToWorld.linear)));
    const glm::dvec3 normal = glm::normalize(inverseTranspose * glm::dvec3(0.0, 0.0, 1.0));
    return std::abs(glm::dot(normal, p - glm::dvec3(objectToWorld.translation)));
}

class Search {
  public:
    explicit Search(const SceneDescription& scene) : scene_(scene) {}

    /// Zero where the scene is not far away.
    Vec3 origin() {
        if (!isFar(sceneBox(kFewCorners))) { return Vec3(0.0f); }
        const WideBox box = sceneBox(0);
        if (box.empty() || !isFar(box)) { return Vec3(0.0f); }
        for (const Object& object : scene_.objects) {
            if (isFiniteShape(object.shape)) { continue; }
            const double distance = planeDistance(object.objectToWorld, box.center());
            if (!(box.distanceFromOrigin() > kFarSizes * distance)) { return Vec3(0.0f); }
        }
        return gridCenter(box);
    }

    /// What to subtract from each mesh's vertices. Meshes that are where their vertices say follow the scene;
    /// the others follow all that is placed by the same transform, so that their seams stay tight.
    std::vector<Vec3> meshCenters(const Vec3& origin) {
        std::vector<Vec3> centers(scene_.meshes.size(), Vec3(0.0f));
        std::vector<bool> known(scene_.meshes.size(), false);
        for (const Object& object : scene_.objects) {
            if (object.shape != ShapeKind::Mesh || !isIdentity(object.objectToWorld)) { continue; }
            centers[static_cast<size_t>(object.mesh)] = origin;
            known[static_cast<size_t>(object.mesh)] = true;
        }
        for (const Object& object : scene_.objects) {
            if (object.shape != ShapeKind::Mesh || known[static_cast<size_t>(object.mesh)]) { continue; }
            const auto mesh = static_cast<size_t>(object.mesh);
            known[mesh] = true;
            if (!isFar(boxOf(mesh, kFewCorners))) { continue; }
            const WideBox group = groupBox(object.objectToWorld);
            if (!group.empty() && isFar(group)) { centers[mesh] = gridCenter(group); }
        }
        return centers;
    }

  private:
    /// So many corners of a mesh, spread over it, are a first look.
    static constexpr size_t kFewCorners = 64;

    /// corners 0: all of them.
    WideBox boxOf(size_t mesh, size_t corners) const {
        const auto& data = scene_.meshes[mesh].data;
        if (!data) { return {}; }
        return meshBox(*data, corners > 0 ? std::max<size_t>(1, data->indices.size() / corners) : 1);
    }

    /// Stops as soon as the box is not far away.
    WideBox sceneBox(size_t corners) const {
        WideBox box;
        for (const Object& object : scene_.objects) {
            const WideBox mesh = object.shape == ShapeKind::Mesh
                                     ? boxOf(static_cast<size_t>(object.mesh), corners)
                                     : WideBox{};
            box.grow(placedBox(object, mesh));
            if (!box.empty() && !isFar(box)) { break; }
        }
        return box;
    }

    /// In object space, of all meshes that the transform places.
    WideBox groupBox(const Affine& objectToWorld) const {
        WideBox box;
        for (const Object& object : scene_.objects) {
            if (object.shape != ShapeKind::Mesh || !(object.objectToWorld == objectToWorld)) { continue; }
            box.grow(boxOf(static_cast<size_t>(object.mesh), 0));
            if (!box.empty() && !isFar(box)) { break; }
        }
        return box;
    }

    const SceneDescription& scene_;
};

std::shared_ptr<const MeshData> centeredMesh(const MeshData& mesh, const Vec3& center) {
    auto data = std::make_shared<MeshData>(mesh);
    for (Vec3& p : data->positions) {
        p -= center;
    }
    return data;
}

/// `known` (may be null): what the mesh of the same index was before.
CenteredMesh centered(const std::shared_ptr<const MeshData>& mesh, const Vec3& center,
                      const CenteredMesh* known) {
    if (!mesh || isZero(center)) { return {mesh, Vec3(0.0f), mesh}; }
    if (known != nullptr && known->original == mesh && known->center == center) { return *known; }
    return {mesh, center, centeredMesh(*mesh, center)};
}

/// In double: the products of a transform with a far centre cancel against its far translation.
Affine moved(const Affine& objectToWorld, const Vec3& center, const Vec3& origin) {
    Affine out = objectToWorld;
    out.translation = Vec3(glm::dmat3(objectToWorld.linear) * glm::dvec3(center) +
                           glm::dvec3(objectToWorld.translation) - glm::dvec3(origin));
    return out;
}

}  // namespace

std::shared_ptr<const Recentring> findRecentring(const SceneDescription& scene, const Recentring* previous) {
    Search search(scene);
    auto recentring = std::make_shared<Recentring>();
    recentring->origin = search.origin();
    const std::vector<Vec3> centers = search.meshCenters(recentring->origin);
    const bool nothing = isZero(recentring->origin) && std::ranges::all_of(centers, isZero);
    if (nothing) { return nullptr; }
    for (size_t i = 0; i < centers.size(); ++i) {
        const CenteredMesh* known =
            previous != nullptr && i < previous->meshes.size() ? &previous->meshes[i] : nullptr;
        recentring->meshes.push_back(centered(scene.meshes[i].data, centers[i], known));
    }
    return recentring;
}

bool samePlaces(const Recentring* a, const Recentring* b) {
    if (a == nullptr || b == nullptr) { return a == b; }
    return a->origin == b->origin &&
           std::ranges::equal(a->meshes, b->meshes, {}, &CenteredMesh::centered, &CenteredMesh::centered);
}

SceneDescription recentred(const SceneDescription& scene, const Recentring& recentring) {
    const Vec3& origin = recentring.origin;
    SceneDescription out = scene;
    for (size_t i = 0; i < out.meshes.size() && i < recentring.meshes.size(); ++i) {
        out.meshes[i].data = recentring.meshes[i].centered;
    }
    for (Object& object : out.objects) {
        const auto mesh = static_cast<size_t>(object.mesh);
        const bool hasCenter = object.shape == ShapeKind::Mesh && mesh < recentring.meshes.size();
        const Vec3 center = hasCenter ? recentring.meshes[mesh].center : Vec3(0.0f);
        object.objectToWorld = moved(object.objectToWorld, center, origin);
    }
    for (Light& light : out.lights) {
        light.position -= origin;
    }
    for (Vec3& corner : out.environment.portal) {
        corner -= origin;
    }
    out.camera.position -= origin;
    out.camera.target -= origin;
    return out;
}

}  // namespace glint
