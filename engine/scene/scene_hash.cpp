// Field by field, since padding has no defined content. A field that is added to the scene has to be
// added here.
#include "engine/scene/scene_hash.h"

#include <fmt/format.h>

#include "engine/scene/scene_use.h"

namespace glint {
namespace {

void add(ContentHash& hash, float number) { hash.add(number); }

void add(ContentHash& hash, const Vec2& v) {
    hash.add(v.x);
    hash.add(v.y);
}

void add(ContentHash& hash, const Vec3& v) {
    hash.add(v.x);
    hash.add(v.y);
    hash.add(v.z);
}

/// Arrays of numbers and of vectors, which hold no padding.
template <class T>
void add(ContentHash& hash, const std::vector<T>& values) {
    hash.addBytes(values.data(), values.size() * sizeof(T));
}

void add(ContentHash& hash, const Camera& camera) {
    add(hash, camera.position);
    add(hash, camera.target);
    add(hash, camera.up);
    hash.add(camera.verticalFovDeg);
    hash.add(camera.horizontalScale);
    hash.add(camera.apertureDiameter);
    hash.add(camera.focalDistance);
    hash.add(camera.apertureBlades);
    hash.add(camera.bladeRotationDeg);
}

void add(ContentHash& hash, const MeshData& mesh, bool isTextured) {
    add(hash, mesh.positions);
    add(hash, mesh.normals);
    if (isTextured) { add(hash, mesh.uvs); }
    add(hash, mesh.colors);
    add(hash, mesh.indices);
}

void add(ContentHash& hash, const Object& object) {
    hash.add(object.shape);
    hash.add(object.mesh);
    hash.add(object.material);
    hash.add(object.frontOnly);
    for (int column = 0; column < 3; ++column) {
        add(hash, object.objectToWorld.linear[column]);
    }
    add(hash, object.objectToWorld.translation);
}

/// A constant adds no more than it did before numbers and other colours could be textured.
template <class Input>
void addInput(ContentHash& hash, std::string_view key, const Input& input) {
    add(hash, input.value);
    if (input.texture >= 0) {
        hash.add(key);
        hash.add(input.texture);
    }
}

void add(ContentHash& hash, const Material& material) {
    hash.add(material.kind);
    add(hash, material.color.value);
    hash.add(material.color.texture);
    hash.add(material.metal);
    addInput(hash, "eta", material.eta);
    addInput(hash, "k", material.k);
    addInput(hash, "ior", material.ior);
    addInput(hash, "roughness", material.roughness);
    hash.add(material.thin);
    addInput(hash, "weights", material.mixtureWeights);
    addInput(hash, "emission", material.emission);
    hash.add(material.emissionStrength);
    hash.add(material.emitsBothSides);
}

void add(ContentHash& hash, const SceneImage& image) {
    if (image.bytes) {
        hash.add(image.bytes->width);
        hash.add(image.bytes->height);
        add(hash, image.bytes->rgb);
    }
    if (image.floats) {
        hash.add(image.floats->width);
        hash.add(image.floats->height);
        add(hash, image.floats->rgb);
    }
}

void add(ContentHash& hash, const Texture& texture) {
    add(hash, texture.image);
    hash.add(texture.encoding);
    hash.add(texture.flipV);
    add(hash, texture.scale);
}

void add(ContentHash& hash, const Light& light) {
    hash.add(light.kind);
    add(hash, light.position);
    add(hash, light.direction);
    add(hash, light.color);
    hash.add(light.strength);
    hash.add(light.coneAngleDeg);
    hash.add(light.coneFalloffStartDeg);
}

void add(ContentHash& hash, const Environment& environment) {
    add(hash, environment.color);
    hash.add(environment.strength);
    hash.add(environment.image);
    hash.add(environment.rotationDeg);
}

template <class T>
void addAll(ContentHash& hash, const std::vector<T>& items) {
    hash.add(static_cast<uint64_t>(items.size()));
    for (const T& item : items) {
        add(hash, item);
    }
}

void addGeometry(ContentHash& hash, const SceneDescription& scene) {
    addAll(hash, scene.objects);
    const std::vector<bool> used = usedMeshes(scene);
    const std::vector<bool> textured = texturedMeshes(scene);
    for (size_t i = 0; i < used.size(); ++i) {
        if (used[i] && scene.meshes[i].data) { add(hash, *scene.meshes[i].data, textured[i]); }
    }
}

void addTextures(ContentHash& hash, const SceneDescription& scene) {
    hash.add(static_cast<uint64_t>(scene.textures.size()));
    const std::vector<bool> used = usedTextures(scene);
    for (size_t i = 0; i < used.size(); ++i) {
        if (used[i]) { add(hash, scene.textures[i]); }
    }
}

void addLights(ContentHash& hash, const SceneDescription& scene) {
    addAll(hash, scene.lights);
    add(hash, scene.environment);
    hash.add(static_cast<uint64_t>(scene.environmentImages.size()));
    if (usesEnvironmentImage(scene)) {
        add(hash, scene.environmentImages[static_cast<size_t>(scene.environment.image)]);
    }
}

Hash128 hashPart(const SceneDescription& scene, ScenePart part) {
    ContentHash hash;
    switch (part) {
        case ScenePart::Camera:
            add(hash, scene.camera);
            break;
        case ScenePart::Geometry:
            addGeometry(hash, scene);
            break;
        case ScenePart::Materials:
            addAll(hash, scene.materials);
            break;
        case ScenePart::Textures:
            addTextures(hash, scene);
            break;
        case ScenePart::Lights:
            addLights(hash, scene);
            break;
    }
    return hash.finish();
}

const char* nameOf(IntegratorKind kind) { return kind == IntegratorKind::Sppm ? "sppm" : "path"; }

const char* nameOf(FilterKind kind) {
    switch (kind) {
        case FilterKind::Box:
            return "box";
        case FilterKind::Gaussian:
            return "gaussian";
        case FilterKind::BlackmanHarris:
            return "blackman-harris";
    }
    return "";
}

void addSettings(const SppmOptions& sppm, std::vector<Setting>* settings) {
    settings->insert(settings->end(), {{"photonsPerPass", fmt::to_string(sppm.photonsPerPass)},
                                       {"alpha", fmt::to_string(sppm.alpha)},
                                       {"radius", fmt::to_string(sppm.radiusWorld)},
                                       {"radiusFootprints", fmt::to_string(sppm.radiusFootprints)},
                                       {"storeRoughness", fmt::to_string(sppm.storeRoughness)},
                                       {"directLight", sppm.sampleDirectLight ? "sampled" : "photons"},
                                       {"lookup", sppm.lookup == PhotonLookupKind::Tree ? "tree" : "grid"},
                                       {"memoryBudgetMiB", fmt::to_string(sppm.memoryBudgetMiB)}});
}

const char* nameOf(SamplerKind kind) { return kind == SamplerKind::Independent ? "independent" : "sobol"; }

}  // namespace

const char* scenePartName(ScenePart part) {
    switch (part) {
        case ScenePart::Camera:
            return "the camera";
        case ScenePart::Geometry:
            return "the geometry";
        case ScenePart::Materials:
            return "the materials";
        case ScenePart::Textures:
            return "the textures";
        case ScenePart::Lights:
            return "the lights";
    }
    return "";
}

SceneHashes hashSceneParts(const SceneDescription& scene) {
    SceneHashes hashes;
    for (size_t i = 0; i < hashes.parts.size(); ++i) {
        hashes.parts[i] = hashPart(scene, static_cast<ScenePart>(i));
    }
    return hashes;
}

std::vector<Setting> renderSettings(const SceneDescription& scene) {
    const RenderOptions& options = scene.options;
    std::vector<Setting> settings = {{"width", fmt::to_string(scene.resolution.width)},
                                     {"height", fmt::to_string(scene.resolution.height)},
                                     {"integrator", nameOf(options.integrator)},
                                     {"maxDepth", fmt::to_string(options.maxDepth)},
                                     {"rouletteStartDepth", fmt::to_string(options.rouletteStartDepth)},
                                     {"filter", nameOf(options.filter)},
                                     {"filterRadius", fmt::to_string(options.filterRadius)},
                                     {"sampler", nameOf(options.sampler)},
                                     {"seed", fmt::to_string(options.seed)},
                                     {"fireflyClamp", fmt::to_string(options.fireflyClamp)}};
    if (options.integrator == IntegratorKind::Sppm) { addSettings(scene.sppm, &settings); }
    return settings;
}

Hash128 sceneHash(const SceneDescription& scene) {
    ContentHash hash;
    for (const Hash128& part : hashSceneParts(scene).parts) {
        hash.add(part.low);
        hash.add(part.high);
    }
    for (const Setting& setting : renderSettings(scene)) {
        hash.add(setting.name);
        hash.add(setting.value);
    }
    return hash.finish();
}

}  // namespace glint
