#include "engine/scene/scene_use.h"

#include <algorithm>

namespace glint {
namespace {

void mark(int index, std::vector<bool>* used) {
    if (index >= 0 && static_cast<size_t>(index) < used->size()) {
        (*used)[static_cast<size_t>(index)] = true;
    }
}

}  // namespace

std::vector<int> inputTextures(const Material& material) {
    std::vector<int> textures;
    forEachInput(material, [&](const FieldTraits&, const auto& input) { textures.push_back(input.texture); });
    return textures;
}

std::vector<int*> inputTextures(Material* material) {
    std::vector<int*> textures;
    forEachInput(*material, [&](const FieldTraits&, auto& input) { textures.push_back(&input.texture); });
    return textures;
}

std::vector<int> usedTextures(const Material& material) {
    std::vector<const void*> unseen;
    forEachModelInput(
        [&](const InputInfo& info, const auto& input) {
            if (!looksAt(material, info)) { unseen.push_back(&input); }
        },
        material);
    std::vector<int> textures;
    forEachInput(material, [&](const FieldTraits&, const auto& input) {
        const bool isSeen = std::ranges::find(unseen, &input) == unseen.end();
        if (isSeen && input.texture >= 0) { textures.push_back(input.texture); }
    });
    return textures;
}

bool showsImage(const Light& light) { return hasImage(light.kind) && light.image.texture >= 0; }

std::vector<bool> usedMaterials(const SceneDescription& scene) {
    std::vector<bool> used(scene.materials.size(), false);
    for (const Object& object : scene.objects) {
        mark(object.material, &used);
    }
    return used;
}

std::vector<bool> usedTextures(const SceneDescription& scene) {
    std::vector<bool> used(scene.textures.size(), false);
    const std::vector<bool> materials = usedMaterials(scene);
    for (size_t i = 0; i < scene.materials.size(); ++i) {
        if (!materials[i]) { continue; }
        for (const int texture : usedTextures(scene.materials[i])) {
            mark(texture, &used);
        }
    }
    for (const Light& light : scene.lights) {
        if (showsImage(light)) { mark(light.image.texture, &used); }
    }
    return used;
}

std::vector<bool> usedMeshes(const SceneDescription& scene) {
    std::vector<bool> used(scene.meshes.size(), false);
    for (const Object& object : scene.objects) {
        if (object.shape == ShapeKind::Mesh) { mark(object.mesh, &used); }
    }
    return used;
}

std::vector<bool> texturedMeshes(const SceneDescription& scene) {
    std::vector<bool> used(scene.meshes.size(), false);
    for (const Object& object : scene.objects) {
        const auto material = static_cast<size_t>(object.material);
        if (object.shape == ShapeKind::Mesh && object.material >= 0 && material < scene.materials.size() &&
            (isAnisotropic(scene.materials[material]) || !usedTextures(scene.materials[material]).empty())) {
            mark(object.mesh, &used);
        }
    }
    return used;
}

bool usesEnvironmentImage(const SceneDescription& scene) {
    const Environment& environment = scene.environment;
    return environment.emissive() && environment.image >= 0 &&
           static_cast<size_t>(environment.image) < scene.environmentImages.size();
}

bool hasLight(const SceneDescription& scene) {
    const auto shines = [&](const Object& object) {
        const auto material = static_cast<size_t>(object.material);
        return object.material >= 0 && material < scene.materials.size() &&
               scene.materials[material].emissive();
    };
    const auto isOn = [](const Light& light) {
        return !light.onlyRayCast && light.strength > 0.0f && maxComponent(light.color) > 0.0f;
    };
    return std::ranges::any_of(scene.objects, shines) || std::ranges::any_of(scene.lights, isOn) ||
           (scene.environment.emissive() && !scene.environment.seenOnly);
}

}  // namespace glint
