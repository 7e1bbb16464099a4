#include "engine/report/stress_scene.h"

#include <cmath>

#include <fmt/format.h>

#include "engine/math/frame.h"

namespace glint {
namespace {

template <class Change>
void changeVertices(SceneDescription* scene, const Change& change) {
    for (Mesh& mesh : scene->meshes) {
        auto data = std::make_shared<MeshData>(*mesh.data);
        for (Vec3& p : data->positions) {
            p = change(p);
        }
        mesh.data = std::move(data);
    }
}

/// Meshes without a transform change their vertices where asked to; all else is placed by its transform.
void changeObjects(SceneDescription* scene, const Affine& map, StressChange change) {
    for (Object& object : scene->objects) {
        const bool baked = change == StressChange::Vertices && object.shape == ShapeKind::Mesh &&
                           object.objectToWorld == Affine{};
        if (!baked) { object.objectToWorld = map * object.objectToWorld; }
    }
}

MeshData roomWalls() {
    MeshData mesh;
    addQuad(&mesh, {-2, 0, -3}, {-2, 0, 2}, {2, 0, 2}, {2, 0, -3});
    addQuad(&mesh, {-2, 0, -3}, {2, 0, -3}, {2, 3, -3}, {-2, 3, -3});
    addQuad(&mesh, {-2, 0, 2}, {-2, 0, -3}, {-2, 3, -3}, {-2, 3, 2});
    addQuad(&mesh, {2, 0, -3}, {2, 0, 2}, {2, 3, 2}, {2, 3, -3});
    addQuad(&mesh, {-2, 3, -3}, {2, 3, -3}, {2, 3, 2}, {-2, 3, 2});
    return mesh;
}

MeshData block(const Vec3& lo, const Vec3& hi) {
    MeshData mesh;
    addBox(&mesh, lo, hi, false);
    return mesh;
}

}  // namespace

SceneDescription emptyStressScene(const Vec3& from, const Vec3& to, float fovDeg, int size) {
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

Material diffuseStress(float albedo) {
    Material material;
    material.color.value = Vec3(albedo);
    return material;
}

Material emitterStress(float radiance, bool bothSides) {
    Material material = diffuseStress(0.0f);
    material.emission = Vec3(radiance);
    material.emitsBothSides = bothSides;
    return material;
}

Material whiteMetal(float roughness) {
    Material material = diffuseStress(1.0f);
    material.kind = MaterialKind::Conductor;
    material.metal.clear();
    material.eta = Vec3(1e-4f);
    material.k = Vec3(100.0f);
    material.roughness = roughness;
    return material;
}

Material glass(float ior) {
    Material material = diffuseStress(1.0f);
    material.kind = MaterialKind::Dielectric;
    material.ior = ior;
    return material;
}

size_t addShape(SceneDescription* scene, ShapeKind shape, const Affine& objectToWorld,
                const Material& material) {
    Object object;
    object.shape = shape;
    object.objectToWorld = objectToWorld;
    object.material = static_cast<int>(scene->materials.size());
    scene->materials.push_back(material);
    scene->objects.push_back(object);
    return scene->objects.size() - 1;
}

size_t addMesh(SceneDescription* scene, MeshData mesh, const Affine& objectToWorld,
               const Material& material) {
    const size_t index = addShape(scene, ShapeKind::Mesh, objectToWorld, material);
    scene->objects.back().mesh = static_cast<int>(scene->meshes.size());
    scene->meshes.emplace_back();
    scene->meshes.back().data = std::make_shared<const MeshData>(std::move(mesh));
    return index;
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

SceneDescription closeUpOfFloor(const Vec3& from, const Vec3& target, float width) {
    const float fov = 2.0f * std::atan(0.5f * width / glm::length(target - from)) * 180.0f / kPi;
    SceneDescription scene = emptyStressScene(from, target, fov);
    addShape(&scene, ShapeKind::Plane, placeFlatShape({0, 0, 0}, {0, 1, 0}, 1, 1),
             diffuseStress(kFloorAlbedo));
    scene.options.maxDepth = 1;
    return scene;
}

SceneDescription skyOverMesh(MeshData mesh, float width, bool tilted) {
    const Affine turn = tilted ? rotate({0.3f, 0.2f, 1.0f}, 0.7f) : Affine{};
    const Vec3 from = turn.point({0.2f, 0.8f, 0.3f});
    const float fov = 2.0f * std::atan(0.5f * width / glm::length(from)) * 180.0f / kPi;
    SceneDescription scene = emptyStressScene(from, {0, 0, 0}, fov);
    scene.environment.color = Vec3(1.0f);
    scene.options.maxDepth = 1;
    addMesh(&scene, std::move(mesh), turn, diffuseStress(kFloorAlbedo));
    return scene;
}

SceneDescription stressRoom() {
    SceneDescription scene = emptyStressScene({0.1f, 1.4f, 5.5f}, {0.1f, 1.2f, 0.0f}, 42.0f, 32);
    scene.camera.apertureDiameter = 0.06f;
    scene.camera.focalDistance = 5.4f;
    scene.options.maxDepth = 6;
    addMesh(&scene, roomWalls(), {}, diffuseStress(0.7f));
    addShape(&scene, ShapeKind::Rectangle, placeFlatShape({0.3f, 2.9f, -0.5f}, {0, -1, 0}, 0.6f, 0.5f),
             emitterStress(12.0f));
    addShape(&scene, ShapeKind::Sphere, translate({0.8f, 0.62f, 0.4f}) * scale(Vec3(0.6f)), glass(1.5f));
    Material gold = diffuseStress(1.0f);
    gold.kind = MaterialKind::Conductor;
    gold.roughness = 0.3f;
    addMesh(&scene, block({-1.6f, 0.01f, -1.8f}, {-0.6f, 1.7f, -0.8f}), {}, gold);
    Material plastic = diffuseStress(0.4f);
    plastic.kind = MaterialKind::Plastic;
    plastic.roughness = 0.1f;
    addMesh(&scene, block({-0.4f, 0.0f, -0.5f}, {0.4f, 0.5f, 0.5f}),
            translate({-0.7f, 0.01f, 0.8f}) * rotate({0, 1, 0}, 0.4f), plastic);
    return scene;
}

SceneDescription gridRoom() {
    SceneDescription scene = emptyStressScene({0, 1.5f, 5.5f}, {0, 1, 0}, 42.0f, 32);
    scene.camera.apertureDiameter = 0.06f;
    scene.camera.focalDistance = 5.4f;
    scene.options.maxDepth = 6;
    addMesh(&scene, roomWalls(), {}, diffuseStress(0.7f));
    addShape(&scene, ShapeKind::Rectangle, placeFlatShape({0.5f, 2.5f, -0.5f}, {0, -1, 0}, 0.6f, 0.5f),
             emitterStress(12.0f));
    addShape(&scene, ShapeKind::Sphere, translate({1, 1, 0.5f}) * scale(Vec3(0.6f)), glass(1.5f));
    Material gold = diffuseStress(1.0f);
    gold.kind = MaterialKind::Conductor;
    gold.roughness = 0.3f;
    addMesh(&scene, block({-1.5f, 0.5f, -2}, {-0.5f, 2, -1}), {}, gold);
    Material plastic = diffuseStress(0.4f);
    plastic.kind = MaterialKind::Plastic;
    plastic.roughness = 0.1f;
    addMesh(&scene, block({-0.4f, 0.0f, -0.5f}, {0.4f, 0.5f, 0.5f}),
            translate({-0.5f, 0.5f, 1}) * rotate({0, 1, 0}, 0.4f), plastic);
    return scene;
}

SceneDescription scaledScene(const SceneDescription& scene, float factor, StressChange change) {
    SceneDescription scaled = scene;
    if (change == StressChange::Vertices) {
        changeVertices(&scaled, [&](const Vec3& p) { return factor * p; });
    }
    for (Object& object : scaled.objects) {
        const bool mesh = object.shape == ShapeKind::Mesh;
        object.objectToWorld.translation *= factor;
        if (!mesh || change == StressChange::Transforms) { object.objectToWorld.linear *= factor; }
    }
    scaled.camera.position *= factor;
    scaled.camera.target *= factor;
    scaled.camera.apertureDiameter *= factor;
    scaled.camera.focalDistance *= factor;
    for (Light& light : scaled.lights) {
        light.position *= factor;
        if (light.kind != LightKind::Directional) { light.color *= factor * factor; }
    }
    scaled.sppm.radiusWorld *= factor;
    return scaled;
}

SceneDescription movedScene(const SceneDescription& scene, const Vec3& offset, StressChange change) {
    SceneDescription moved = scene;
    if (change == StressChange::Vertices) {
        for (Mesh& mesh : moved.meshes) {
            mesh.data = nullptr;  // only those without a transform are moved
        }
        for (const Object& object : scene.objects) {
            if (object.shape != ShapeKind::Mesh) { continue; }
            const auto index = static_cast<size_t>(object.mesh);
            auto data = std::make_shared<MeshData>(*scene.meshes[index].data);
            if (object.objectToWorld == Affine{}) {
                for (Vec3& p : data->positions) {
                    p += offset;
                }
            }
            moved.meshes[index].data = std::move(data);
        }
    }
    changeObjects(&moved, translate(offset), change);
    moved.camera.position += offset;
    moved.camera.target += offset;
    for (Light& light : moved.lights) {
        light.position += offset;
    }
    return moved;
}

std::string gradeNumber(double value) {
    const double magnitude = std::abs(value);
    if (value == 0.0 || (magnitude >= 1e-2 && magnitude < 1e4)) { return fmt::format("{:.7g}", value); }
    std::string text = fmt::format("{:.3e}", value);
    const size_t e = text.find('e');
    std::string mantissa = text.substr(0, e);
    mantissa.erase(mantissa.find_last_not_of('0') + 1);
    if (mantissa.ends_with('.')) { mantissa.pop_back(); }
    return fmt::format("{}e{}", mantissa, std::stoi(text.substr(e + 1)));
}

}  // namespace glint
