#include "tests/support/sppm_scenes.h"

#include "tests/support/test_scenes.h"

namespace glint::test {

SceneDescription small(SceneDescription scene) {
    scene.resolution = {32, 32};
    scene.options.maxDepth = 8;
    return scene;
}

SceneDescription roughGlassBox() {
    SceneDescription scene = small(cornellBox());
    Material glass;
    glass.name = "rough glass";
    glass.kind = MaterialKind::Dielectric;
    glass.color.value = Vec3(1.0f);
    glass.roughness.value = 0.3f;
    scene.materials.push_back(glass);
    for (Object& object : scene.objects) {
        if (object.shape == ShapeKind::Sphere) {
            object.material = static_cast<int>(scene.materials.size()) - 1;
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
