// Test scenes: each function states one scene, with the helpers above it for what they share.

#include "tests/support/test_scenes.h"

namespace glint::test {
namespace {

int addMaterial(SceneDescription* scene, MaterialKind kind, const Vec3& color, float roughness = 0.0f) {
    Material material = diffuseMaterial(color);
    material.kind = kind;
    material.roughness.value = roughness;
    return glint::addMaterial(scene, material);
}

int addEmitterMaterial(SceneDescription* scene, const Vec3& emission, bool bothSides = false) {
    Material material = emissiveMaterial(emission, bothSides);
    material.color.value = Vec3(0.2f);
    return glint::addMaterial(scene, material);
}

SceneDescription seenFrom(const Vec3& cameraPosition, const Vec3& target) {
    SceneDescription scene;
    scene.camera.position = cameraPosition;
    scene.camera.target = target;
    scene.resolution = {64, 64};
    scene.options.maxDepth = 8;
    return scene;
}

/// A rectangle of half size 1 around `center` whose normal is +z turned by `angleRad` about `axis`.
Affine wall(const Vec3& center, const Vec3& axis, float angleRad) {
    return translate(center) * rotate(axis, angleRad);
}

constexpr Vec3 kX{1.0f, 0.0f, 0.0f};
constexpr Vec3 kY{0.0f, 1.0f, 0.0f};

/// Floor, ceiling, back and the two side walls of a room of [-1, 1] x [0, 2] x [-1, 1], open to +z.
void addRoom(SceneDescription* scene) {
    const int white = addMaterial(scene, MaterialKind::Diffuse, Vec3(0.73f));
    const int red = addMaterial(scene, MaterialKind::Diffuse, Vec3(0.65f, 0.05f, 0.05f));
    const int green = addMaterial(scene, MaterialKind::Diffuse, Vec3(0.12f, 0.45f, 0.15f));
    addObject(scene, ShapeKind::Rectangle, wall({0, 0, 0}, kX, -0.5f * kPi), white);
    addObject(scene, ShapeKind::Rectangle, wall({0, 2, 0}, kX, 0.5f * kPi), white);
    addObject(scene, ShapeKind::Rectangle, wall({0, 1, -1}, kX, 0.0f), white);
    addObject(scene, ShapeKind::Rectangle, wall({-1, 1, 0}, kY, 0.5f * kPi), red);
    addObject(scene, ShapeKind::Rectangle, wall({1, 1, 0}, kY, -0.5f * kPi), green);
}

Light makeLight(LightKind kind, const Vec3& position, const Vec3& direction, const Vec3& color) {
    Light light;
    light.kind = kind;
    light.position = position;
    light.direction = direction;
    light.color = color;
    return light;
}

/// One sphere of each kind of material, smooth and rough; returns how many.
int addMaterialRow(SceneDescription* scene) {
    const int first = static_cast<int>(scene->materials.size());
    addMaterial(scene, MaterialKind::Diffuse, Vec3(0.8f, 0.4f, 0.2f));
    addMaterial(scene, MaterialKind::Mirror, Vec3(0.9f));
    addMaterial(scene, MaterialKind::Conductor, Vec3(1.0f));
    addMaterial(scene, MaterialKind::Conductor, Vec3(1.0f), 0.3f);
    scene->materials.back().metal.clear();
    addMaterial(scene, MaterialKind::Dielectric, Vec3(1.0f));
    addMaterial(scene, MaterialKind::Dielectric, Vec3(0.95f), 0.2f);
    addMaterial(scene, MaterialKind::Dielectric, Vec3(0.9f));
    scene->materials.back().thin = true;
    addMaterial(scene, MaterialKind::Plastic, Vec3(0.1f, 0.3f, 0.7f));
    addMaterial(scene, MaterialKind::Plastic, Vec3(0.6f, 0.1f, 0.1f), 0.15f);
    addMaterial(scene, MaterialKind::Mixture, Vec3(0.7f));
    scene->materials.back().mixtureWeights.value = Vec3(1.0f, 1.0f, 2.0f);
    const int count = static_cast<int>(scene->materials.size()) - first;
    for (int i = 0; i < count; ++i) {
        const Vec3 center(-2.2f + 1.1f * static_cast<float>(i % 5), 0.5f, i < 5 ? -0.7f : 0.7f);
        addObject(scene, ShapeKind::Sphere, translate(center) * scale(Vec3(0.45f)), first + i);
    }
    return count;
}

}  // namespace

SceneDescription cornellBox() {
    SceneDescription scene = seenFrom({0.0f, 1.0f, 4.2f}, {0.0f, 1.0f, 0.0f});
    scene.title = "Cornell box with two diffuse spheres";
    addRoom(&scene);
    const int emitter = addEmitterMaterial(&scene, Vec3(17.0f, 12.0f, 4.0f));
    addObject(&scene, ShapeKind::Rectangle, wall({0, 1.99f, 0}, kX, 0.5f * kPi) * scale({0.25f, 0.25f, 1}),
              emitter);
    addObject(&scene, ShapeKind::Sphere, translate({-0.4f, 0.4f, -0.3f}) * scale(Vec3(0.4f)), 0);
    addObject(&scene, ShapeKind::Sphere, translate({0.45f, 0.3f, 0.3f}) * scale(Vec3(0.3f)), 0);
    return scene;
}

SceneDescription allMaterials() {
    SceneDescription scene = seenFrom({0.0f, 2.5f, 6.0f}, {0.0f, 0.4f, 0.0f});
    scene.title = "Every material and every light without a shape";
    scene.camera.apertureDiameter = 0.08f;
    scene.camera.apertureBlades = 5;
    scene.camera.focalDistance = 6.2f;
    const int emitter = addEmitterMaterial(&scene, Vec3(6.0f));
    addObject(&scene, ShapeKind::Disc, wall({0, 4, 0}, kX, 0.5f * kPi) * scale({0.8f, 0.8f, 1}), emitter);
    addMaterialRow(&scene);

    scene.textures.push_back({"checker", checkerImage(5, 3, false), ColorEncoding::Srgb, false, Vec2(0.5f)});
    scene.textures.push_back(
        {"floats", checkerImage(4, 4, true), ColorEncoding::Linear, true, Vec2(2.0f, 1.0f)});
    const int floor = addMaterial(&scene, MaterialKind::Diffuse, Vec3(0.5f));
    scene.materials.back().color.texture = 0;
    addObject(&scene, ShapeKind::Plane, rotate(kX, -0.5f * kPi), floor);
    const int poster = addMaterial(&scene, MaterialKind::Plastic, Vec3(0.5f), 0.2f);
    scene.materials.back().color.texture = 1;
    addObject(&scene, ShapeKind::Rectangle, wall({0, 1.4f, -1.8f}, kX, 0.0f) * scale({2.5f, 0.8f, 1}),
              poster);

    scene.lights.push_back(makeLight(LightKind::Point, {-2, 2, 2}, {0, -1, 0}, Vec3(4.0f, 2.0f, 1.0f)));
    scene.lights.push_back(makeLight(LightKind::Spot, {2, 3, 2}, {-0.4f, -1, -0.5f}, Vec3(1.0f, 3.0f, 8.0f)));
    scene.lights.push_back(makeLight(LightKind::Directional, {0, 0, 0}, {0.3f, -1, -0.2f}, Vec3(0.3f)));
    return scene;
}

SceneDescription texturedInputs() {
    SceneDescription scene = seenFrom({0.0f, 1.5f, 6.0f}, {0.0f, 0.4f, 0.0f});
    scene.title = "Textures on every input of every kind of material";
    const int emitter = addEmitterMaterial(&scene, Vec3(8.0f));
    addObject(&scene, ShapeKind::Disc, wall({0, 4, 0}, kX, 0.5f * kPi) * scale({0.8f, 0.8f, 1}), emitter);
    addObject(&scene, ShapeKind::Plane, rotate(kX, -0.5f * kPi),
              addMaterial(&scene, MaterialKind::Diffuse, Vec3(0.6f)));
    scene.textures.push_back({"numbers", checkerImage(5, 3, false), ColorEncoding::Srgb, false, Vec2(2.0f)});
    scene.textures.push_back({"indices", checkerImage(4, 4, true), ColorEncoding::Linear, true, Vec2(1.0f)});
    const size_t first = scene.materials.size();
    for (const MaterialKind kind : {MaterialKind::Conductor, MaterialKind::Dielectric, MaterialKind::Plastic,
                                    MaterialKind::Plastic, MaterialKind::Mixture, MaterialKind::Principled}) {
        const int material = addMaterial(&scene, kind, Vec3(0.9f, 0.7f, 0.5f), 0.2f);
        const float x = 1.1f * (static_cast<float>(material) - static_cast<float>(first) - 2.0f);
        addObject(&scene, ShapeKind::Sphere, translate({x, 0.5f, 0.0f}) * scale(Vec3(0.5f)), material);
        scene.materials.back().metal.clear();
        forEachModelInput([](const InputInfo&, auto& input) { input.texture = 1; }, scene.materials.back());
        scene.materials.back().roughness.texture = 0;
    }
    scene.materials[first + 2].ior = {1.5f};
    scene.environment.color = Vec3(0.2f, 0.3f, 0.4f);
    return scene;
}

SceneDescription meshInstances() {
    SceneDescription scene = seenFrom({0.0f, 1.5f, 7.0f}, {0.0f, 0.0f, 0.0f});
    scene.title = "One mesh under every kind of affine transform";
    const int colored = addMesh(&scene, bumpySphere(12, 20, true));
    const int plain = addMesh(&scene, bumpySphere(5, 7, false));
    const int diffuse = addMaterial(&scene, MaterialKind::Diffuse, Vec3(0.8f));
    const int glossy = addMaterial(&scene, MaterialKind::Conductor, Vec3(1.0f), 0.25f);
    const int textured = addMaterial(&scene, MaterialKind::Diffuse, Vec3(0.5f));
    scene.textures.push_back({"checker", checkerImage(8, 8, false), ColorEncoding::Srgb, false, Vec2(4.0f)});
    scene.materials.back().color.texture = 0;

    Affine shear;
    shear.linear[1] = Vec3(0.6f, 1.0f, 0.0f);
    addMeshObject(&scene, colored, Affine{}, diffuse);
    addMeshObject(&scene, colored, translate({-2.4f, 0, 0}) * rotate({1, 2, 3}, 1.0f), diffuse);
    addMeshObject(&scene, colored, translate({2.4f, 0, 0}) * scale({-1, 1, 1}), glossy);
    addMeshObject(&scene, plain, translate({-1.2f, 1.7f, -1}) * shear * scale(Vec3(0.7f)), textured);
    addMeshObject(&scene, plain, translate({1.2f, 1.7f, -1}) * scale({1.2f, 0.4f, 0.8f}), textured);
    scene.objects.back().frontOnly = true;

    scene.environmentImages.push_back(checkerImage(16, 8, true));
    scene.environment.color = Vec3(1.0f, 0.9f, 0.8f);
    scene.environment.image = 0;
    scene.environment.rotationDeg = 30.0f;
    return scene;
}

SceneDescription manyLights(uint32_t triangles) {
    SceneDescription scene = seenFrom({0.0f, 1.0f, 4.2f}, {0.0f, 1.0f, 0.0f});
    scene.title = "Many small lamps";
    addRoom(&scene);
    auto mesh = std::make_shared<MeshData>();
    for (uint32_t i = 0; i < triangles; ++i) {
        const float turn = 2.399963f * static_cast<float>(i);  // the golden angle spreads them over a disc
        const float radius = 0.9f * std::sqrt((static_cast<float>(i) + 0.5f) / static_cast<float>(triangles));
        const Vec3 p(radius * std::cos(turn), 1.95f - 0.2f * radius, radius * std::sin(turn));
        mesh->positions.insert(mesh->positions.end(), {p, p + Vec3(0.02f, 0, 0), p + Vec3(0, 0, 0.02f)});
        mesh->indices.insert(mesh->indices.end(), {3 * i, 3 * i + 1, 3 * i + 2});
    }
    const int emitter = addEmitterMaterial(&scene, Vec3(40.0f), true);
    addMeshObject(&scene, addMesh(&scene, mesh), Affine{}, emitter);
    addObject(&scene, ShapeKind::Sphere, translate({0, 0.4f, 0}) * scale(Vec3(0.4f)), 0);
    return scene;
}

SceneDescription emitterShapes() {
    SceneDescription scene = seenFrom({0.0f, 1.0f, 4.2f}, {0.0f, 1.0f, 0.0f});
    scene.title = "Lamps of every shape";
    addRoom(&scene);
    Affine shear;
    shear.linear[1] = Vec3(0.4f, 1.0f, 0.0f);
    const int oneSided = addEmitterMaterial(&scene, Vec3(3.0f, 2.0f, 1.0f));
    const int twoSided = addEmitterMaterial(&scene, Vec3(1.0f, 2.0f, 3.0f), true);
    addObject(&scene, ShapeKind::Sphere, translate({-0.6f, 0.3f, 0}) * scale(Vec3(0.15f)), oneSided);
    addObject(&scene, ShapeKind::Sphere, translate({0.6f, 0.3f, 0}) * scale({0.1f, 0.25f, 0.15f}), oneSided);
    addObject(&scene, ShapeKind::Disc,
              translate({0, 1.2f, -0.5f}) * rotate({1, 1, 0}, 0.8f) * scale(Vec3(0.2f)), twoSided);
    addObject(&scene, ShapeKind::Rectangle, translate({-0.5f, 1.5f, 0}) * shear * scale(Vec3(0.15f)),
              twoSided);
    const int mesh = addMesh(&scene, bumpySphere(3, 5, false));
    addMeshObject(&scene, mesh, translate({0.5f, 1.5f, 0}) * scale(Vec3(-0.15f)), oneSided);
    return scene;
}

SceneDescription whiteFurnace() {
    SceneDescription scene = seenFrom({0.0f, 0.0f, 4.0f}, Vec3(0.0f));
    scene.title = "A white sphere in uniform light";
    scene.options.filter = FilterKind::Box;
    scene.options.filterRadius = 0.5f;
    scene.options.sampler = SamplerKind::Independent;
    addObject(&scene, ShapeKind::Sphere, Affine{}, addMaterial(&scene, MaterialKind::Diffuse, Vec3(1.0f)));
    scene.environment.color = Vec3(1.0f);
    return scene;
}

SceneDescription darkness() {
    SceneDescription scene = meshInstances();
    scene.title = "Every shape and no light";
    scene.environment = {};
    scene.environmentImages.clear();
    addObject(&scene, ShapeKind::Sphere, translate({0, 2, 0}), 0);
    addObject(&scene, ShapeKind::Plane, translate({0, 0, -5}), 0);
    addObject(&scene, ShapeKind::Disc, translate({0, -2, 0}), 0);
    addObject(&scene, ShapeKind::Rectangle, translate({0, -3, 0}), 0);
    return scene;
}

SceneDescription turnedProfiles() {
    SceneDescription scene = seenFrom({0.0f, 1.5f, 6.0f}, {0.0f, 0.4f, 0.0f});
    scene.title = "Surfaces of revolution, one with a texture that is turned and mirrored";
    addObject(&scene, ShapeKind::Disc, wall({0, 4, 0}, kX, 0.5f * kPi) * scale({0.8f, 0.8f, 1}),
              addEmitterMaterial(&scene, Vec3(8.0f)));
    addObject(&scene, ShapeKind::Plane, rotate(kX, -0.5f * kPi),
              addMaterial(&scene, MaterialKind::Diffuse, Vec3(0.6f)));
    Texture texture{"checker", checkerImage(8, 8, false), ColorEncoding::Srgb, false, Vec2(4.0f)};
    texture.rotationDeg = 30.0f;
    scene.textures.push_back(texture);
    for (const CurveKind curve : {CurveKind::Bezier, CurveKind::Bspline}) {
        const bool isGlass = curve == CurveKind::Bspline;
        const int material =
            addMaterial(&scene, isGlass ? MaterialKind::Dielectric : MaterialKind::Plastic, Vec3(0.9f), 0.1f);
        if (!isGlass) { scene.materials.back().color.texture = 0; }
        addObject(&scene, ShapeKind::Revolved,
                  translate({isGlass ? 1.0f : -1.0f, 0.0f, 0.0f}) * rotate({1, 0, 1}, 0.3f), material);
        scene.objects.back().curve = curve;
        scene.objects.back().profile = {{0.0f, 0.0f}, {0.9f, 0.0f}, {0.2f, 0.8f}, {1.1f, 1.3f}, {0.0f, 1.5f}};
    }
    scene.environment.color = Vec3(0.2f, 0.3f, 0.4f);
    return scene;
}

SceneDescription kdTrees() {
    SceneDescription scene = darkness();
    scene.title = "Every shape in kd-trees";
    scene.options.accelerator = AcceleratorKind::KdTree;
    scene.environment.color = Vec3(0.3f, 0.4f, 0.5f);
    return scene;
}

SceneDescription dispersiveBalls() {
    SceneDescription scene = cornellBox();
    Material glass;
    glass.kind = MaterialKind::Dielectric;
    glass.color.value = Vec3(1.0f);
    glass.glass = "SF11";
    for (Object& object : scene.objects) {
        if (object.shape != ShapeKind::Sphere) { continue; }
        object.material = addMaterial(&scene, glass);
        glass.glass.clear();
        glass.abbeNumber = 20.0f;
        glass.roughness.value = 0.3f;
    }
    return scene;
}

}  // namespace glint::test
