#include "viewer/model/image_choice.h"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <utility>

#include "engine/io/file_path.h"
#include "engine/scene/scene_use.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

std::string absolutePath(const std::string& path) { return fs::absolute(path).lexically_normal().string(); }

bool isOfFile(const SceneImage& image, const std::string& scenePath, const std::string& path) {
    const std::string own = pathOf(image.source);
    return !own.empty() && absolutePath(resolvePath(own, scenePath)) == path;
}

ColorEncoding encodingOf(const Material& material, size_t input) {
    size_t index = 0;
    bool isColor = false;
    forEachInput(material, [&](const FieldTraits& traits, const auto&) {
        if (index++ == input) { isColor = traits.isColor; }
    });
    return isColor ? ColorEncoding::Srgb : ColorEncoding::Linear;
}

/// The index of the scene's texture of an absolute file, which is made where there is none.
int textureOf(SceneDescription* scene, const std::string& file, ColorEncoding encoding) {
    const auto known = std::ranges::find_if(scene->textures, [&](const Texture& texture) {
        return texture.encoding == encoding && isOfFile(texture.image, scene->path, file);
    });
    const auto index = static_cast<int>(known - scene->textures.begin());
    if (known == scene->textures.end()) {
        Texture texture;
        texture.name = fs::path(file).filename().string();
        texture.image.source = FileSource{file};
        texture.encoding = encoding;
        scene->textures.push_back(std::move(texture));
    }
    return index;
}

/// The last image, or one that is alike.
template <class IsAlike>
void showImage(SceneDescription* scene, SceneImage image, const IsAlike& isAlike) {
    std::vector<SceneImage>& images = scene->environmentImages;
    const auto known = std::ranges::find_if(images, isAlike);
    scene->environment.image = static_cast<int>(known - images.begin());
    if (known == images.end()) { images.push_back(std::move(image)); }
    if (!scene->environment.emissive()) {
        scene->environment.color = Vec3(1.0f);
        scene->environment.strength = 1.0f;
    }
}

}  // namespace

void chooseTextureFile(SceneDocument* document, size_t material, size_t input, const std::string& path) {
    SceneDescription& scene = document->draft();
    if (material >= scene.materials.size()) { return; }
    const std::string file = absolutePath(path);
    *inputTextures(&scene.materials[material])[input] =
        textureOf(&scene, file, encodingOf(scene.materials[material], input));
    document->nameEdit("Texture " + fs::path(file).filename().string());
}

void chooseImageFile(SceneDocument* document, size_t light, const std::string& path) {
    SceneDescription& scene = document->draft();
    if (light >= scene.lights.size()) { return; }
    const std::string file = absolutePath(path);
    scene.lights[light].image.texture = textureOf(&scene, file, ColorEncoding::Srgb);
    document->nameEdit("Picture " + fs::path(file).filename().string());
}

void chooseEnvironmentFile(SceneDocument* document, const std::string& path) {
    const std::string file = absolutePath(path);
    SceneDescription& scene = document->draft();
    showImage(&scene, {.source = FileSource{file}},
              [&](const SceneImage& image) { return isOfFile(image, scene.path, file); });
    document->nameEdit("Environment " + fs::path(file).filename().string());
}

void chooseSky(SceneDocument* document) {
    showImage(&document->draft(), {.source = SkySource{}},
              [](const SceneImage& image) { return std::holds_alternative<SkySource>(image.source); });
    document->nameEdit("Environment sky");
}

}  // namespace glint
