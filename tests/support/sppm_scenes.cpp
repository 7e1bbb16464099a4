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
    glass.roughness = 0.3f;
    scene.materials.push_back(glass);
    for (Object& object : scene.objects) {
        if (object.shape == ShapeKind::Sphere) {
            object.material = static_cast<int>(scene.materials.size()) - 1;
        }
    }
    return scene;
}

}  // namespace glint::test
