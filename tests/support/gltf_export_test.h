// What tests of glTF files written and opened again share.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/io/exporter.h"
#include "tests/support/gltf_test.h"
#include "tests/support/gltf_validity.h"

namespace glint::test {

class GltfExportTest : public GltfTest {
  protected:
    /// The scene as it is opened from its export.
    SceneDescription exported(const SceneDescription& scene, const std::string& name = "out.glb") {
        const std::string path = folder.path(name);
        warnings.clear();
        const Status saved = exporterOf(path)->save(scene, path, &warnings);
        EXPECT_TRUE(saved) << saved.error().format();
        expectValidGltf(path);
        auto opened = loadScene(path, {.noStudio = true});
        EXPECT_TRUE(opened) << opened.error().format();
        return opened ? std::move(*opened) : SceneDescription();
    }
    /// In the dark.
    SceneDescription square() {
        SceneDescription scene = load(gltf(material("")));
        scene.environment.color = Vec3(0.0f);
        return scene;
    }
    Material exportedMaterial(const Material& material) {
        SceneDescription scene = square();
        scene.materials[0] = material;
        const SceneDescription opened = exported(scene);
        return opened.materials.empty() ? Material() : opened.materials[0];
    }
    static int addTexture(SceneDescription* scene, const Image8& image, ColorEncoding encoding,
                          TextureChannel channel = TextureChannel::Red) {
        Texture texture;
        texture.encoding = encoding;
        texture.channel = channel;
        texture.image.bytes = std::make_shared<const Image8>(image);
        scene->textures.push_back(texture);
        return static_cast<int>(scene->textures.size()) - 1;
    }
    SceneDescription repositoryScene(const std::string& name) {
        auto scene = loadScene(std::string(GLINT_SOURCE_DIR) + "/scenes/" + name);
        EXPECT_TRUE(scene) << scene.error().format();
        return scene ? std::move(*scene) : SceneDescription();
    }
    std::vector<std::string> warnings;
};

}  // namespace glint::test
