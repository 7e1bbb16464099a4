#include "tests/support/sppm_scenes.h"

#include <cmath>

#include "engine/scene/scene_building.h"
#include "tests/support/relief_scenes.h"
#include "tests/support/test_scenes.h"

namespace glint::test {

namespace {

Material roughGlass() {
    Material glass;
    glass.name = "rough glass";
    glass.kind = MaterialKind::Dielectric;
    glass.color.value = Vec3(1.0f);
    glass.roughness.value = 0.3f;
    return glass;
}

}  // namespace

SceneDescription small(SceneDescription scene) {
    scene.resolution = {32, 32};
    scene.options.maxDepth = 8;
    return scene;
}

SceneDescription roughGlassBox() {
    SceneDescription scene = small(cornellBox());
    const int glass = addMaterial(&scene, roughGlass());
    for (Object& object : scene.objects) {
        if (object.shape == ShapeKind::Sphere) { object.material = glass; }
    }
    return scene;
}

SceneDescription roughGlassInContact() {
    SceneDescription scene = small(emptyScene({0.0f, 1.3f, 3.0f}, {0.0f, 0.0f, 0.1f}, 32.0f, 32));
    const Vec3 up(0.0f, 1.0f, 0.0f);
    addObject(&scene, ShapeKind::Rectangle, placeFlatShape(Vec3(0.0f), up, 4.0f, 4.0f),
              diffuseMaterial(0.73f));
    addObject(&scene, ShapeKind::Rectangle, placeFlatShape({0.0f, 2.0f, 0.0f}, -up, 0.5f, 0.5f),
              emissiveMaterial(Vec3(15.0f)));
    const int glass = addMaterial(&scene, roughGlass());
    const auto addBall = [&](const Vec3& center, float radius) {
        addObject(&scene, ShapeKind::Sphere, translate(center) * scale(Vec3(radius)), glass);
    };
    addBall({-0.45f, 0.35f, -0.2f}, 0.35f);
    addBall({-0.45f, 0.35f, -0.2f}, 0.97f * 0.35f);
    addBall({0.35f, 0.3f, -0.2f}, 0.3f);
    for (const float x : {-0.25f, 0.25f}) {
        addObject(&scene, ShapeKind::Rectangle, placeFlatShape({x, 0.02f, 0.55f}, up, 0.25f, 0.25f), glass);
    }
    return scene;
}

SceneDescription bumpyBox() {
    SceneDescription scene = small(cornellBox());
    const int heights = addTexture(&scene, waves(32, 4));
    const int normals =
        addTexture(&scene, std::make_shared<ImageF>(ImageF{2, 1, {0.8f, 0.5f, 0.9f, 0.3f, 0.6f, 0.9f}}));
    for (Material& material : scene.materials) {
        material.bump.texture = heights;
        material.bumpHeight = 0.05f;
    }
    for (Object& object : scene.objects) {
        if (object.shape != ShapeKind::Sphere) { continue; }
        Material leaning = scene.materials[static_cast<size_t>(object.material)];
        leaning.bump.texture = -1;
        leaning.normalMap.texture = normals;
        object.material = addMaterial(&scene, leaning);
    }
    return scene;
}

SceneDescription cutoutBox() {
    SceneDescription scene = small(cornellBox());
    const int holes = addTexture(
        &scene, greyImage(8, 8, [](int x, int y) { return (x / 2 + y / 2) % 2 == 0 ? 0.0f : 1.0f; }));
    for (Object& object : scene.objects) {
        if (object.shape != ShapeKind::Sphere) { continue; }
        Material cut = scene.materials[static_cast<size_t>(object.material)];
        cut.opacity.texture = holes;
        object.material = addMaterial(&scene, cut);
    }
    Material veil = diffuseMaterial(Vec3(0.8f, 0.6f, 0.3f));
    veil.opacity.value = 0.4f;
    addObject(&scene, ShapeKind::Rectangle,
              placeFlatShape({0.0f, 1.2f, 0.0f}, {0.0f, 1.0f, 0.2f}, 0.6f, 0.6f), veil);
    return scene;
}

SceneDescription absorbingGlassBox() {
    SceneDescription scene = small(cornellBox());
    Material glass = roughGlass();
    const int clear = addMaterial(&scene, glass);
    glass.attenuationColor = Vec3(0.7f, 0.3f, 0.2f);
    glass.attenuationDistance = 0.4f;
    const int absorbing = addMaterial(&scene, glass);
    for (size_t i = 0, count = scene.objects.size(); i < count; ++i) {
        if (scene.objects[i].shape != ShapeKind::Sphere) { continue; }
        scene.objects[i].material = absorbing;
        addObject(&scene, ShapeKind::Sphere, scene.objects[i].objectToWorld * scale(Vec3(0.6f)), clear);
    }
    return scene;
}

SceneDescription translucentBox() {
    SceneDescription scene = small(cornellBox());
    Material leaf = diffuseMaterial(Vec3(0.2f, 0.3f, 0.1f));
    leaf.kind = MaterialKind::Translucent;
    leaf.transmission.value = Vec3(0.4f, 0.6f, 0.2f);
    const int material = addMaterial(&scene, leaf);
    for (Object& object : scene.objects) {
        if (object.shape == ShapeKind::Sphere) {
            object.material = material;
            break;
        }
    }
    addObject(&scene, ShapeKind::Rectangle,
              placeFlatShape({0.0f, 1.2f, 0.0f}, {0.0f, 1.0f, 0.2f}, 0.6f, 0.6f), material);
    return scene;
}

SceneDescription principledBox() {
    SceneDescription scene = small(cornellBox());
    Material paint = diffuseMaterial(Vec3(0.6f, 0.1f, 0.1f));
    paint.kind = MaterialKind::Principled;
    paint.metallic.value = 0.6f;
    paint.roughness.value = 0.35f;
    paint.clearcoat.value = 1.0f;
    Material cloth = diffuseMaterial(Vec3(0.1f, 0.2f, 0.5f));
    cloth.kind = MaterialKind::Principled;
    cloth.roughness.value = 0.7f;
    cloth.sheenColor.value = Vec3(0.9f, 0.8f, 0.7f);
    const Material balls[] = {paint, cloth};
    int next = 0;
    for (Object& object : scene.objects) {
        if (object.shape == ShapeKind::Sphere) { object.material = addMaterial(&scene, balls[next++]); }
    }
    Material worn = paint;
    worn.metallic.texture =
        addTexture(&scene, greyImage(4, 4, [](int x, int y) { return (x + y) % 2 == 0 ? 0.1f : 1.0f; }));
    worn.roughness.texture = addTexture(&scene, waves(16, 2));
    scene.textures.back().base = 0.3f;
    scene.textures.back().gain = 0.7f;
    worn.clearcoatRoughness.value = 0.3f;
    addObject(&scene, ShapeKind::Rectangle,
              placeFlatShape({0.0f, 1.2f, -0.3f}, {0.0f, 1.0f, 0.6f}, 0.6f, 0.6f), worn);
    return scene;
}

SceneDescription passingBox() {
    SceneDescription scene = small(cornellBox());
    Material body = diffuseMaterial(Vec3(0.3f, 0.6f, 0.8f));
    body.kind = MaterialKind::Principled;
    body.specularTransmission.value = 0.6f;
    body.roughness.value = 0.4f;
    body.rootTint = true;
    body.attenuationColor = Vec3(0.7f, 0.8f, 0.9f);
    body.attenuationDistance = 0.5f;
    const int clear = addMaterial(&scene, body);
    for (Object& object : scene.objects) {
        if (object.shape != ShapeKind::Sphere) { continue; }
        object.material = clear;
        break;
    }
    Material sheet = diffuseMaterial(Vec3(0.8f, 0.6f, 0.3f));
    sheet.kind = MaterialKind::Principled;
    sheet.specularTransmission.value = 0.7f;
    sheet.roughness.value = 0.5f;
    sheet.thin = true;
    addObject(&scene, ShapeKind::Rectangle,
              placeFlatShape({0.0f, 1.2f, 0.0f}, {0.0f, 1.0f, 0.2f}, 0.6f, 0.6f), sheet);
    return scene;
}

SceneDescription highlightBox() {
    SceneDescription scene = small(cornellBox());
    Material phong = diffuseMaterial(Vec3(0.3f, 0.3f, 0.5f));
    phong.kind = MaterialKind::Phong;
    phong.specularReflectance.value = Vec3(0.5f, 0.4f, 0.3f);
    phong.exponent.value = 8.0f;
    Material ward = diffuseMaterial(Vec3(0.2f));
    ward.kind = MaterialKind::Ward;
    ward.wardForm = WardForm::Duer;
    ward.specularReflectance.value = Vec3(0.6f);
    ward.roughness.value = 0.4f;
    ward.crossRoughness.value = 0.8f;
    addObject(&scene, ShapeKind::Rectangle,
              placeFlatShape({-0.3f, 1.2f, -0.3f}, {0.0f, 1.0f, 0.6f}, 0.5f, 0.6f), phong);
    addObject(&scene, ShapeKind::Rectangle,
              placeFlatShape({0.5f, 1.0f, -0.3f}, {-0.5f, 1.0f, 0.3f}, 0.4f, 0.4f), ward);
    return scene;
}

SceneDescription brushedBox() {
    SceneDescription scene = small(cornellBox());
    Material metal = diffuseMaterial(Vec3(1.0f));
    metal.kind = MaterialKind::Conductor;
    metal.roughness.value = 0.4f;
    metal.crossRoughness.value = 0.9f;
    metal.anisotropyRotationDeg = 30.0f;
    Material beckmann = metal;
    beckmann.distribution = FacetDistribution::Beckmann;
    addObject(&scene, ShapeKind::Rectangle,
              placeFlatShape({-0.3f, 1.2f, -0.3f}, {0.0f, 1.0f, 0.6f}, 0.5f, 0.6f), metal);
    addObject(&scene, ShapeKind::Rectangle,
              placeFlatShape({0.5f, 1.0f, -0.3f}, {-0.5f, 1.0f, 0.3f}, 0.4f, 0.4f), beckmann);
    return scene;
}

SceneDescription coatedBox() {
    SceneDescription scene = brushedBox();
    for (Material& metal : scene.materials) {
        if (metal.kind != MaterialKind::Conductor) { continue; }
        metal.kind = MaterialKind::Coated;
        metal.ior.value = 1.5f;
        metal.coatAbsorption.value = Vec3(0.1f, 0.3f, 0.6f);
    }
    return scene;
}

SceneDescription dispersiveGlass() {
    SceneDescription scene = small(emptyScene({0.0f, 2.0f, 3.0f}, {0.0f, 0.15f, 0.1f}, 32.0f, 32));
    const Vec3 up(0.0f, 1.0f, 0.0f);
    addObject(&scene, ShapeKind::Rectangle, placeFlatShape(Vec3(0.0f), up, 4.0f, 4.0f),
              diffuseMaterial({0.8f, 0.7f, 0.6f}));
    addObject(&scene, ShapeKind::Rectangle, placeFlatShape({0.0f, 2.6f, 0.0f}, -up, 0.7f, 0.7f),
              emissiveMaterial(Vec3(12.0f)));
    Material glass = roughGlass();
    glass.abbeNumber = 4.0f;
    const int rough = addMaterial(&scene, glass);
    glass.roughness.value = 0.0f;
    const int smooth = addMaterial(&scene, glass);
    addObject(&scene, ShapeKind::Sphere, translate({-0.45f, 0.4f, -0.1f}) * scale(Vec3(0.4f)), smooth);
    addObject(&scene, ShapeKind::Sphere, translate({0.5f, 0.3f, 0.2f}) * scale(Vec3(0.3f)), rough);
    MeshData cube;
    addBox(&cube, {-0.15f, 0.02f, 0.5f}, {0.15f, 0.32f, 0.8f}, false);
    addMeshObject(&scene, addMesh(&scene, std::make_shared<const MeshData>(std::move(cube))), {}, smooth);
    return scene;
}

SceneDescription otherWinding(SceneDescription scene) {
    for (Object& object : scene.objects) {
        const bool isFlat = object.shape == ShapeKind::Rectangle || object.shape == ShapeKind::Disc;
        const Material& material = scene.materials[static_cast<size_t>(object.material)];
        if (isFlat && !object.frontOnly && !material.emissive() && material.kind == MaterialKind::Diffuse) {
            object.objectToWorld = object.objectToWorld * rotate(Vec3(1.0f, 0.0f, 0.0f), kPi);
        }
    }
    return scene;
}

SceneDescription glassBox() {
    SceneDescription scene = cornellBox();
    scene.resolution = {37, 29};  // no multiple of the launch's tiles
    scene.options.maxDepth = 6;
    scene.sppm.photonsPerPass = 3000;
    Material glass;
    glass.name = "glass";
    glass.kind = MaterialKind::Dielectric;
    scene.materials.push_back(glass);
    scene.objects.back().material = static_cast<int>(scene.materials.size()) - 1;
    return scene;
}

SceneDescription whiteRoom() {
    SceneDescription scene = cornellBox();
    scene.resolution = {16, 16};
    scene.options.maxDepth = 16;
    scene.sppm.photonsPerPass = 2000;
    scene.sppm.radiusWorld = 0.3f;
    for (Material& material : scene.materials) {
        if (!material.emissive()) { material.color.value = Vec3(0.95f); }
    }
    return scene;
}

}  // namespace glint::test
