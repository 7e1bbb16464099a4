#include "tests/support/relief_scenes.h"

#include <cmath>

#include "tests/support/test_scenes.h"

namespace glint::test {

std::shared_ptr<const ImageF> greyImage(int width, int height, const std::function<float(int, int)>& value) {
    auto image = std::make_shared<ImageF>(ImageF{width, height, {}});
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            image->rgb.insert(image->rgb.end(), 3, value(x, y));
        }
    }
    return image;
}

std::shared_ptr<const ImageF> waves(int size, int count) {
    const float step = 2.0f * kPi * static_cast<float>(count) / static_cast<float>(size);
    return greyImage(size, size, [step](int x, int y) {
        return 0.5f + 0.25f * (std::sin(step * (static_cast<float>(x) + 0.5f)) +
                               std::sin(step * (static_cast<float>(y) + 0.5f)));
    });
}

int addTexture(SceneDescription* scene, std::shared_ptr<const ImageF> image) {
    Texture texture;
    texture.name = "image";
    texture.image.floats = std::move(image);
    scene->textures.push_back(std::move(texture));
    return static_cast<int>(scene->textures.size()) - 1;
}

SceneDescription reliefRoom(const Material& floor) {
    SceneDescription scene = emptyScene({0.0f, 2.0f, 5.0f}, {0.0f, 0.4f, 0.0f}, 40.0f, 32);
    scene.options.maxDepth = 6;
    scene.environment.color = Vec3(0.1f);
    addObject(&scene, ShapeKind::Rectangle,
              placeFlatShape({0.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}, 3.0f, 3.0f), floor);
    addObject(&scene, ShapeKind::Rectangle,
              placeFlatShape({0.0f, 1.0f, -3.0f}, {0.0f, 0.0f, 1.0f}, 3.0f, 3.0f), diffuseMaterial(0.6f));
    addObject(&scene, ShapeKind::Sphere, translate({1.5f, 3.5f, 1.0f}) * scale(Vec3(0.7f)),
              emissiveMaterial(Vec3(8.0f)));
    return scene;
}

SceneDescription reliefs() {
    Material floor;
    floor.kind = MaterialKind::Plastic;
    floor.roughness.value = 0.2f;
    floor.color.texture = 0;
    floor.bump.texture = 1;
    SceneDescription scene = reliefRoom(floor);
    scene.title = "Bumps, holes and a mip map";
    scene.resolution = {64, 64};
    const auto add = [&](const char* name, SceneImage image, float scale) {
        Texture texture;
        texture.name = name;
        texture.image = std::move(image);
        texture.scale = Vec2(scale);
        scene.textures.push_back(texture);
    };
    add("checker", checkerImage(16, 8, false), 2.0f);
    scene.textures[0].filter = TexelFilter::Mipmap;
    add("heights", checkerImage(8, 8, true), 3.0f);
    scene.textures[1].channel = TextureChannel::Luminance;
    const Image8 holes{2, 2, std::vector<uint8_t>(12, 90), {0, 80, 255, 200}};
    add("holes", {.bytes = std::make_shared<const Image8>(holes)}, 4.0f);
    for (const MaterialKind kind :
         {MaterialKind::Diffuse, MaterialKind::Conductor, MaterialKind::Dielectric}) {
        Material material = diffuseMaterial(0.8f);
        material.kind = kind;
        material.roughness.value = 0.1f;
        material.bump.texture = kind == MaterialKind::Dielectric ? -1 : 1;
        material.normalMap.texture = kind == MaterialKind::Diffuse ? -1 : 1;
        material.color.texture = kind == MaterialKind::Diffuse ? 2 : -1;
        const float x = static_cast<float>(scene.objects.size()) - 4.0f;
        addObject(&scene, ShapeKind::Sphere, translate({1.2f * x, 0.5f, 0}) * scale(Vec3(0.5f)), material);
    }
    Material veil = diffuseMaterial(0.5f);
    veil.opacity.value = 0.6f;
    addObject(&scene, ShapeKind::Rectangle,
              placeFlatShape({0.0f, 1.4f, -1.8f}, {0.0f, 0.0f, 1.0f}, 2.5f, 0.8f), veil);
    return scene;
}

}  // namespace glint::test
