#include "engine/scene/scene_building.h"

#include <cmath>

#include "engine/math/frame.h"

namespace glint {

SceneDescription emptyScene(const Vec3& from, const Vec3& to, float fovDeg, int size) {
    SceneDescription scene;
    scene.camera.position = from;
    scene.camera.target = to;
    scene.camera.up = std::abs(glm::normalize(to - from).y) > 0.9f ? Vec3(0, 0, 1) : Vec3(0, 1, 0);
    scene.camera.verticalFovDeg = fovDeg;
    scene.resolution = {size, size};
    scene.options.filter = FilterKind::Box;
    scene.options.filterRadius = 0.5f;
    return scene;
}

Material diffuseMaterial(const Vec3& color) {
    Material material;
    material.color.value = color;
    return material;
}

Material emissiveMaterial(const Vec3& radiance, bool bothSides) {
    Material material = diffuseMaterial(0.0f);
    material.emission.value = radiance;
    material.emitsBothSides = bothSides;
    return material;
}

Light directionalLight(const Vec3& direction, const Vec3& color) {
    Light light;
    light.kind = LightKind::Directional;
    light.direction = direction;
    light.color = color;
    return light;
}

int addMaterial(SceneDescription* scene, Material material) {
    scene->materials.push_back(std::move(material));
    return static_cast<int>(scene->materials.size()) - 1;
}

int addMesh(SceneDescription* scene, std::shared_ptr<const MeshData> data) {
    scene->meshes.push_back({{}, {}, std::move(data)});
    return static_cast<int>(scene->meshes.size()) - 1;
}

size_t addObject(SceneDescription* scene, ShapeKind shape, const Affine& objectToWorld, int material) {
    Object object;
    object.shape = shape;
    object.objectToWorld = objectToWorld;
    object.material = material;
    scene->objects.push_back(object);
    return scene->objects.size() - 1;
}

size_t addMeshObject(SceneDescription* scene, int mesh, const Affine& objectToWorld, int material) {
    const size_t index = addObject(scene, ShapeKind::Mesh, objectToWorld, material);
    scene->objects.back().mesh = mesh;
    return index;
}

size_t addObject(SceneDescription* scene, ShapeKind shape, const Affine& objectToWorld,
                 const Material& material) {
    return addObject(scene, shape, objectToWorld, addMaterial(scene, material));
}

size_t addMeshObject(SceneDescription* scene, MeshData mesh, const Affine& objectToWorld,
                     const Material& material) {
    const int index = addMesh(scene, std::make_shared<const MeshData>(std::move(mesh)));
    return addMeshObject(scene, index, objectToWorld, addMaterial(scene, material));
}

Affine placeFlatShape(const Vec3& center, const Vec3& normal, float halfX, float halfY) {
    const Frame frame = Frame::fromNormal(glm::normalize(normal));
    Affine a;
    a.linear = Mat3(frame.s * halfX, frame.t * halfY, frame.n);
    a.translation = center;
    return a;
}

void addQuad(MeshData* mesh, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const auto first = static_cast<uint32_t>(mesh->positions.size());
    mesh->positions.insert(mesh->positions.end(), {a, b, c, d});
    for (const uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u}) {
        mesh->indices.push_back(first + corner);
    }
}

void addBox(MeshData* mesh, const Vec3& lo, const Vec3& hi, bool inward) {
    const auto side = [&](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
        inward ? addQuad(mesh, d, c, b, a) : addQuad(mesh, a, b, c, d);
    };
    side({lo.x, lo.y, hi.z}, {hi.x, lo.y, hi.z}, {hi.x, hi.y, hi.z}, {lo.x, hi.y, hi.z});
    side({hi.x, lo.y, lo.z}, {lo.x, lo.y, lo.z}, {lo.x, hi.y, lo.z}, {hi.x, hi.y, lo.z});
    side({hi.x, lo.y, hi.z}, {hi.x, lo.y, lo.z}, {hi.x, hi.y, lo.z}, {hi.x, hi.y, hi.z});
    side({lo.x, lo.y, lo.z}, {lo.x, lo.y, hi.z}, {lo.x, hi.y, hi.z}, {lo.x, hi.y, lo.z});
    side({lo.x, hi.y, hi.z}, {hi.x, hi.y, hi.z}, {hi.x, hi.y, lo.z}, {lo.x, hi.y, lo.z});
    side({lo.x, lo.y, lo.z}, {hi.x, lo.y, lo.z}, {hi.x, lo.y, hi.z}, {lo.x, lo.y, hi.z});
}

}  // namespace glint
